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

void check(const vbgpd_context_desc& desc) {
  if (desc.abi_version != VBGPD_ABI_VERSION) {
    throw ArgumentError(1, Status::kVersion, "abi_version is not that of this library.");
  }
  constexpr std::int32_t kMostThreads = 1024;
  if (desc.threads < 0 || desc.threads > kMostThreads)
    throw ArgumentError(1, Status::kRange,
                        "threads is " + std::to_string(desc.threads) + "; it must be 0 (all cores) to " +
                            std::to_string(kMostThreads) + ".");
  if (desc.max_particles < 0) throw ArgumentError(1, Status::kRange, "max_particles must be 0 (no limit) or more.");
  if (desc.max_bytes < 0) throw ArgumentError(1, Status::kRange, "max_bytes must be 0 (no limit) or more.");
  if ((desc.alloc == nullptr) != (desc.free == nullptr)) {
    throw ArgumentError(1, Status::kArgument, "alloc and free must both be given, or neither of them.");
  }
  if (desc.reserved != 0) throw ArgumentError(1, Status::kArgument, "reserved must be 0.");
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
    require_struct(d, 1, true);
    vbgpd_context_desc desc = default_desc();
    if (d != nullptr) std::memcpy(&desc, d, std::min<std::size_t>(d->struct_size, sizeof desc));
    check(desc);
    auto context = std::make_unique<ContextObject>();
    context->threads = thread_count(desc.threads);
    context->max_particles = desc.max_particles;
    context->max_bytes = desc.max_bytes;
    if (desc.alloc != nullptr) context->heap = {desc.alloc, desc.free, desc.alloc_user};
    hand_out(std::move(context), out);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_context_destroy(vbgpd_context* context) { return destroy(context); }
