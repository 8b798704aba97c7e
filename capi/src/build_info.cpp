// What this build is and what it uses here.
#include <algorithm>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "convert.h"
#include "exchange/checkpoint.h"
#include "exchange/scene_buffer.h"
#include "exchange/snapshot.h"
#include "geometry/predicates.h"
#include "guard.h"
#include "step/flow_kernels.h"
#include "step/kernels.h"

namespace vbgpd::capi {
namespace {

std::string instruction_sets() {
  std::string names;
  for (const Kernels& k : all_kernels()) names.append(names.empty() ? "" : " ").append(k.isa);
  return names;
}

std::vector<std::pair<const char*, std::string>> facts() {
  const auto yes = [](bool has) { return std::string(has ? "yes" : "no"); };
  return {
      {"version", VBGPD_VERSION_STRING},
      {"abi_version", std::to_string(VBGPD_ABI_VERSION)},
      {"compiler", VBGPD_COMPILER},
      {"build_type", VBGPD_BUILD_TYPE},
      {"cgal", yes(checks_with_cgal())},
      {"flatbuffers", yes(reads_flatbuffers())},
      {"instruction_sets", instruction_sets()},
      {"instruction_set", std::string(best_kernels().isa)},
      {"instruction_set_runout", std::string(best_flow_kernels().isa)},
      {"cores", std::to_string(std::max(1U, std::thread::hardware_concurrency()))},
      {"checkpoint_format", std::to_string(kCheckpointFormat)},
      {"snapshot_format", std::to_string(kSnapshotFormat)},
  };
}

std::string told(std::string_view key) {
  std::string all;
  for (const auto& [name, value] : facts()) {
    if (key == name) return value;
    all.append(name).append(" = ").append(value).append("\n");
  }
  if (!key.empty()) throw ArgumentError(1, Status::kUnknownName, "The build has no fact of that name.");
  return all;
}

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_build_info(const char* key, int64_t key_len, char* buf, int64_t cap, int64_t* needed) {
  return guarded([&] {
    text_out(told(text_in(key, key_len, 1, "key")), buf, cap, needed, 3);
    return Status::kOk;
  });
}
