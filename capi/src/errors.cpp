// The last failure of a call on an object. Reading it never changes it.
#include "convert.h"
#include "guard.h"

namespace vbgpd::capi {
namespace {

template <class Handle>
vbgpd_status last_error(const Handle* handle, vbgpd_error_info* info, char* text, std::int64_t cap,
                        std::int64_t* needed) noexcept {
  return peek(handle, [&](const Object& object) {
    if (object.error.empty()) return Status::kEndOfData;
    issue_out(object.error.issue, object.error.argument, info, text, cap, needed, 2);
    return Status::kOk;
  });
}

}  // namespace
}  // namespace vbgpd::capi

using vbgpd::capi::last_error;

vbgpd_status vbgpd_context_error(const vbgpd_context* context, vbgpd_error_info* info, char* text, int64_t cap,
                                 int64_t* needed) {
  return last_error(context, info, text, cap, needed);
}

vbgpd_status vbgpd_profile_error(const vbgpd_profile* profile, vbgpd_error_info* info, char* text, int64_t cap,
                                 int64_t* needed) {
  return last_error(profile, info, text, cap, needed);
}

vbgpd_status vbgpd_model_error(const vbgpd_model* model, vbgpd_error_info* info, char* text, int64_t cap,
                               int64_t* needed) {
  return last_error(model, info, text, cap, needed);
}

vbgpd_status vbgpd_job_error(const vbgpd_job* job, vbgpd_error_info* info, char* text, int64_t cap, int64_t* needed) {
  return last_error(job, info, text, cap, needed);
}
