// Error against run time: every problem over a ladder of spacings, bond laws and kernels, as CSV on standard output.
//   vbgpd_accuracy [--finest N] [PROBLEM ...]
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "problem.h"

namespace vbgpd::accuracy {
namespace {

struct Options {
  int finest = 1000;
  std::vector<std::string_view> wanted;
};

bool wants(const Options& o, const char* name) {
  if (o.wanted.empty()) return true;
  for (std::string_view w : o.wanted)
    if (w == name) return true;
  return false;
}

double wall() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void run_rung(const Problem& p, const SceneDef& choice, int rung) {
  const double spacing = p.height / rung, wall_begin = wall(), cpu_begin = cpu();
  Outcome out;
  try {
    out = p.run(choice, spacing);
  } catch (const Error& error) {
    out.error = std::nan("");
    std::fprintf(stderr, "%s at %g m: %s\n", p.name, spacing, error.what());
  }
  std::printf("%s,%s,%s,%g,%lld,%.6g,%s,%.4f,%.4f,%lld,%.0f\n", p.name, choice.bond.c_str(), choice.kernel.c_str(),
              spacing, static_cast<long long>(out.particles), out.error, p.error_kind, cpu() - cpu_begin,
              wall() - wall_begin, static_cast<long long>(out.steps), out.bytes);
  std::fflush(stdout);
}

void run(std::span<const Problem> problems, const Options& options) {
  for (const Problem& p : problems) {
    if (!wants(options, p.name)) continue;
    for (const char* bond : {"virtual_bond", "none"})
      for (const char* kernel : {"wendland_c2", "cubic_spline"}) {
        SceneDef choice;
        choice.bond = bond, choice.kernel = kernel;
        for (int rung = 5; rung <= p.finest && rung <= options.finest; rung *= 2) run_rung(p, choice, rung);
      }
  }
}

}  // namespace
}  // namespace vbgpd::accuracy

int main(int argc, char** argv) {
  vbgpd::accuracy::Options options;
  for (int a = 1; a < argc; ++a) {
    if (std::string_view(argv[a]) == "--finest" && a + 1 < argc) options.finest = std::atoi(argv[++a]);
    else options.wanted.push_back(argv[a]);
  }
  std::puts("case,bond,kernel,spacing,particles,error,error_kind,cpu_s,wall_s,steps,bytes");
  vbgpd::accuracy::run(vbgpd::accuracy::elastic_problems(), options);
  vbgpd::accuracy::run(vbgpd::accuracy::limit_problems(), options);
  return 0;
}
