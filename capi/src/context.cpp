// Contexts: how many threads, how many particles and bytes.
#include <thread>

#include "convert.h"
#include "guard.h"

namespace vbgpd::capi {
namespace {

vbgpd_context_desc default_desc() {
  vbgpd_context_desc desc{};
  desc.struct_size = sizeof desc;
  desc.abi_version = VBGPD_ABI_VERSION;
  desc.threads = 1;
  return desc;
}

/// What is wrong with a description: the first fault's status and value, every fault's sentence; kOk where nothing is.
Issue fault_of(const vbgpd_context_desc& desc) {
  Issue issue{.status = Status::kOk, .object = ObjectKind::kContext, .text = {}};
  const auto require = [&](bool good, Status status, double value, const std::string& text) {
    if (good) return;
    if (issue.status == Status::kOk) issue.status = status, issue.value = value;
    issue.text += (issue.text.empty() ? "" : " ") + text;
  };
  const auto no_less_than_0 = [&](const char* name, std::int64_t value) {
    require(value >= 0, Status::kRange, static_cast<double>(value),
            std::string(name) + " is " + std::to_string(value) + "; it must be 0 (no limit) or more.");
  };
  require(desc.abi_version == VBGPD_ABI_VERSION, Status::kVersion, desc.abi_version,
          "abi_version is " + std::to_string(desc.abi_version) + "; this library has ABI version " +
              std::to_string(VBGPD_ABI_VERSION) + ".");
  constexpr std::int32_t kMostThreads = 1024;
  require(desc.threads >= 0 && desc.threads <= kMostThreads, Status::kRange, desc.threads,
          "threads is " + std::to_string(desc.threads) + "; it must be 0 (all cores) to " +
              std::to_string(kMostThreads) + ".");
  no_less_than_0("max_particles", desc.max_particles);
  no_less_than_0("max_bytes", desc.max_bytes);
  require((desc.alloc == nullptr) == (desc.free == nullptr), Status::kArgument, kNone,
          "alloc and free must both be given, or neither of them.");
  require(desc.reserved == 0, Status::kArgument, desc.reserved, "reserved must be 0.");
  return issue;
}

/// The description of the caller, as far as it goes, over the defaults; NULL = defaults.
vbgpd_context_desc desc_in(const vbgpd_context_desc* d) {
  require_struct(d, 1, true);
  vbgpd_context_desc desc = default_desc();
  if (d != nullptr) std::memcpy(&desc, d, std::min<std::size_t>(d->struct_size, sizeof desc));
  return desc;
}

// hardware_concurrency() says 0 when it does not know.
int thread_count(std::int32_t asked) {
  if (asked > 0) return asked;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace
}  // namespace vbgpd::capi

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_context_desc_init(vbgpd_context_desc* d, uint32_t struct_size) {
  return guarded([&] {
    require_not_null(d, 1, "d");
    require_struct_size(struct_size, 2);
    d->struct_size = struct_size;
    fill(d, default_desc());
    return Status::kOk;
  });
}

vbgpd_status vbgpd_context_create(const vbgpd_context_desc* d, vbgpd_context** out) {
  return guarded([&] {
    require_not_null(out, 2, "out");
    const vbgpd_context_desc desc = desc_in(d);
    if (const Issue issue = fault_of(desc); issue.status != Status::kOk) throw ArgumentError(1, issue);
    auto context = std::make_unique<ContextObject>();
    context->threads = thread_count(desc.threads);
    context->max_particles = desc.max_particles;
    context->max_bytes = desc.max_bytes;
    if (desc.alloc != nullptr) context->heap = {desc.alloc, desc.free, desc.alloc_user};
    hand_out(std::move(context), out);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_context_desc_check(const vbgpd_context_desc* d, vbgpd_error_info* info, char* text, int64_t cap,
                                      int64_t* needed) {
  return guarded([&] {
    const Issue issue = fault_of(desc_in(d));
    if (issue.status == Status::kOk) return Status::kEndOfData;
    issue_out(issue, 1, info, text, cap, needed, 2);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_context_destroy(vbgpd_context* context) { return destroy(context); }
