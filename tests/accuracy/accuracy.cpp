// Error against run time: every problem over a ladder of spacings, bond laws, kernels and threads, as CSV on standard
// output.
//   vbgpd_accuracy [--finest N] [--threads N,N,...] [PROBLEM ...]
// With several numbers of threads the same error and the same bits must come out of each: exit status 1 if they do not.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
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
  std::vector<int> threads = {1};
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

Outcome run_rung(const Problem& p, const SceneDef& choice, int threads) {
  const double wall_begin = wall(), cpu_begin = cpu();
  CompileOptions options;
  options.threads = threads;
  Outcome out;
  try {
    out = p.run(choice, options);
  } catch (const Error& error) {
    out = Outcome{}, out.error = std::nan("");
    std::fprintf(stderr, "%s at %g m: %s\n", p.name, choice.spacing, error.what());
  }
  std::printf("%s,%s,%s,%d,%g,%lld,%.6g,%s,%.4f,%.4f,%lld,%.0f,%016llx\n", p.name, choice.bond.c_str(),
              choice.kernel.c_str(), threads, choice.spacing, static_cast<long long>(out.particles), out.error,
              p.error_kind, cpu() - cpu_begin, wall() - wall_begin, static_cast<long long>(out.steps), out.bytes,
              static_cast<unsigned long long>(out.hash));
  std::fflush(stdout);
  return out;
}

bool same(const Outcome& a, const Outcome& b) {
  return a.hash == b.hash && std::memcmp(&a.error, &b.error, sizeof a.error) == 0;
}

std::vector<SceneDef> choices(Schemes schemes) {
  std::vector<const char*> bonds = {"virtual_bond", "none"}, kernels = {"wendland_c2"};
  if (schemes == Schemes::kLattice) kernels.push_back("cubic_spline");
  if (schemes == Schemes::kPairLaws)
    bonds.insert(bonds.end(), {"sph", "sph_artificial_stress", "pseudo_spring", "gpd"});
  std::vector<SceneDef> all;
  for (const char* bond : bonds)
    for (const char* kernel : kernels) {
      SceneDef choice;
      choice.bond = bond, choice.kernel = kernel;
      all.push_back(choice);
    }
  return all;
}

/// False when the number of threads made a difference.
bool run(const Problem& p, const Options& options) {
  bool agree = true;
  for (SceneDef& choice : choices(p.schemes))
    for (int rung = 5; rung <= p.finest && rung <= options.finest; rung *= 2) {
      choice.spacing = p.height / rung;
      const Outcome first = run_rung(p, choice, options.threads.front());
      for (std::size_t t = 1; t < options.threads.size(); ++t)
        if (!same(run_rung(p, choice, options.threads[t]), first)) {
          std::fprintf(stderr, "%s, %s, at %g m: %d threads give another answer than %d\n", p.name, choice.bond.c_str(),
                       choice.spacing, options.threads[t], options.threads.front());
          agree = false;
        }
    }
  return agree;
}

std::vector<int> numbers(const char* list) {
  std::vector<int> out;
  for (const char* at = list; *at != 0;) {
    char* end = nullptr;
    out.push_back(static_cast<int>(std::strtol(at, &end, 10)));
    if (end == at || out.back() < 1)
      std::fprintf(stderr, "--threads needs numbers from 1 on, not %s\n", list), std::exit(2);
    at = *end == ',' ? end + 1 : end;
  }
  return out;
}

Options parse(int argc, char** argv) {
  Options options;
  for (int a = 1; a < argc; ++a) {
    const std::string_view word = argv[a];
    if (word == "--finest" && a + 1 < argc) options.finest = std::atoi(argv[++a]);
    else if (word == "--threads" && a + 1 < argc) options.threads = numbers(argv[++a]);
    else options.wanted.push_back(word);
  }
  return options;
}

}  // namespace
}  // namespace vbgpd::accuracy

int main(int argc, char** argv) {
  namespace accuracy = vbgpd::accuracy;
  const accuracy::Options options = accuracy::parse(argc, argv);
  std::puts("case,bond,kernel,threads,spacing,particles,error,error_kind,cpu_s,wall_s,steps,bytes,hash");
  bool agree = true;
  for (const auto problems :
       {accuracy::elastic_problems, accuracy::wave_problems, accuracy::cavity_problems, accuracy::element_problems,
        accuracy::limit_problems, accuracy::motion_problems, accuracy::column_problems})
    for (const accuracy::Problem& p : problems())
      if (accuracy::wants(options, p.name)) agree &= accuracy::run(p, options);
  return agree ? 0 : 1;
}
