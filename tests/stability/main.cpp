// The table of stiff and extreme cases. `vbgpd_stability` runs all rows, `--fast` those of every test run; prints a
// table and ends with the number of rows that are not as they must be for no reason known.
#include <chrono>
#include <cstdio>
#include <cstring>

#include "row.h"

namespace vbgpd::stability {

namespace {

std::string number(double value, const char* form) {
  if (std::isnan(value)) return "";
  char text[40];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

bool within(double value, double most) { return std::isnan(most) || std::fabs(value) <= most; }

/// What is not as it must be; empty = nothing.
std::string fault(const Case& c, const Outcome& o) {
  if (o.verdict != c.expected) return "must be " + c.expected;
  if (!within(o.deviation, c.most_deviation)) return "deviation above " + number(c.most_deviation, "%.0e");
  if (!within(o.energy_residual, c.most_residual)) return "energy residual above " + number(c.most_residual, "%.0e");
  if (!within(o.momentum_drift, c.most_drift)) return "drift above " + number(c.most_drift, "%.0e");
  return "";
}

/// The first sentence or so: cells must stay cells.
std::string shortened(std::string text) {
  constexpr std::size_t kMost = 110;
  for (char& c : text)
    if (c == '\n' || c == '|') c = ' ';
  return text.size() > kMost ? text.substr(0, kMost) + " ..." : text;
}

/// True when the row is as it must be, or is not for a reason that is known.
bool run(const Case& c) {
  const auto start = std::chrono::steady_clock::now();
  const Outcome o = c.run();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const std::string wrong = fault(c, o);
  std::printf("| %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", c.name.c_str(), o.verdict.c_str(),
              number(o.factor_of_safety, "%.4f").c_str(), number(o.deviation, "%+.1e").c_str(),
              number(o.energy_residual, "%.1e").c_str(), number(o.momentum_drift, "%.1e").c_str(),
              number(o.steps, "%.0f").c_str(), number(seconds.count(), "%.1f").c_str(),
              ((wrong.empty() ? "" : "**" + wrong + "** " + (c.known.empty() ? "" : "(known: " + c.known + ") ")) +
               shortened(o.note))
                  .c_str());
  std::fflush(stdout);
  return wrong.empty() || (!c.known.empty() && (o.verdict == c.expected || o.verdict == c.known_verdict));
}

}  // namespace

int run_all(bool fast, const char* only) {
  std::printf(
      "| case | outcome | FS | deviation | energy residual | drift | steps | s | "
      "|\n|---|---|---|---|---|---|---|---|---|\n");
  int wrong = 0;
  for (const auto& cases : {strength_cases(), dynamic_cases()})
    for (const Case& c : cases)
      if ((!fast || c.fast) && (only == nullptr || c.name.find(only) != std::string::npos)) wrong += run(c) ? 0 : 1;
  return wrong;
}

}  // namespace vbgpd::stability

/// vbgpd_stability [--fast | PART-OF-A-NAME]
int main(int argc, char** argv) {
  const bool fast = argc > 1 && std::strcmp(argv[1], "--fast") == 0;
  return vbgpd::stability::run_all(fast, argc > 1 && !fast ? argv[1] : nullptr);
}
