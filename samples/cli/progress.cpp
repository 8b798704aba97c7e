#include "progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "format.h"

namespace cli {

namespace {

std::string phase_text(const vbgpd_progress& p) {
  switch (p.phase) {
    case 1:
      return "gravity";
    case 5:
      return "slip surface";
    case 6:
      return format("moving  u=%.3g m", p.max_displacement);
    default:
      return format("trial %d  F=%.3f", p.trial + 1, p.strength_reduction_factor);
  }
}

std::string end_text(double srf) { return std::isfinite(srf) ? format("%.3f", srf) : "?"; }

int terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string progress_text(const vbgpd_progress& p, int levels, double elapsed_seconds) {
  std::string text = format("grid %d", p.level + 1);
  if (levels > 0) text += format("/%d", levels);
  text += "  " + phase_text(p);
  if (std::isfinite(p.srf_stable) || std::isfinite(p.srf_unstable))
    text += "  bracket [" + end_text(p.srf_stable) + "," + end_text(p.srf_unstable) + "]";
  text += format("  R=%.1e  %.0f %%", p.unbalanced_force_ratio, 100 * p.fraction);
  const double least = 0.02;  // below it the estimate of what is left is a guess
  if (p.fraction > least && p.fraction < 1)
    text += "  " + duration(elapsed_seconds * (1 - p.fraction) / p.fraction) + " left";
  return text;
}

ProgressLine::ProgressLine(bool wanted, int levels)
    : enabled_(wanted && isatty(STDERR_FILENO)), levels_(levels), start_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(const vbgpd_progress& progress) {
  if (!enabled_) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  std::string text = progress_text(progress, levels_, elapsed.count());
  const auto width =
      static_cast<std::size_t>(terminal_width() - 1);  // a full line would wrap and could not be rewritten
  if (text.size() > width) text.resize(width);
  std::fprintf(stderr, "\r%s\x1b[K", text.c_str());
  std::fflush(stderr);
  shown_ = true;
}

void ProgressLine::clear() {
  if (!shown_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace cli
