// Validation of a profile: every fault the engine can find, kept as a list of issues.
#include <algorithm>

#include "convert.h"
#include "geometry/check.h"
#include "guard.h"

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_profile_validate(vbgpd_profile* profile, int64_t* errors, int64_t* warnings) {
  return with(profile, [&](ProfileObject& object) {
    std::vector<Issue> issues = all_issues(object.scene);
    object.issues.swap(issues);
    const auto count = [&](Severity severity) {
      return std::count_if(object.issues.begin(), object.issues.end(),
                           [&](const Issue& issue) { return issue.severity == severity; });
    };
    if (errors != nullptr) *errors = count(Severity::kError);
    if (warnings != nullptr) *warnings = count(Severity::kWarning);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_profile_issue(const vbgpd_profile* profile, int64_t i, vbgpd_error_info* info, char* text,
                                 int64_t cap, int64_t* needed) {
  return with(profile, [&](ProfileObject& object) {
    const Issue* const issue = item_at(object.issues, i, 2);
    if (issue == nullptr) return Status::kEndOfData;
    issue_out(*issue, 0, info, text, cap, needed, 3);
    return Status::kOk;
  });
}
