// What can go wrong, said so that a person (or a GIS) can find the place. One vocabulary for the whole engine.
#pragma once

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vbgpd {

/// Outcome of a call. 0 done, > 0 done with a named outcome, < 0 failed and nothing changed. Same numbers as vbgpd.h.
enum class Status : std::int32_t {
  kOk = 0,
  kCancelled = 1,
  kLimitReached = 2,
  kNotConverged = 3,
  kUnstable = 4,
  kEndOfData = 5,
  kArgument = -1,
  kHandle = -2,
  kMemory = -3,
  kLimit = -4,
  kBusy = -5,
  kLeased = -6,
  kReentrant = -7,
  kState = -8,
  kGeometry = -9,
  kUnknownName = -10,
  kRange = -11,
  kBuffer = -12,
  kFormat = -13,
  kVersion = -14,
  kDiverged = -15,
  kUnsupported = -17,
  kInternal = -99,
};

/// What an issue is about. Same numbers as VBGPD_OBJECT_* in vbgpd.h.
enum class ObjectKind : std::int32_t {
  kNone = 0,
  kContext = 1,
  kProfile = 2,
  kMaterial = 3,
  kLayer = 4,
  kLoad = 5,
  kBoundary = 6,
  kModel = 7,
  kJob = 8,
  kState = 9
};

enum class Severity : std::int32_t { kWarning = 0, kError = 1 };

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// One fault: which object, which vertex, where, which value, and in `text` a whole sentence that says what would be
/// right.
struct Issue {
  Severity severity = Severity::kError;
  Status status = Status::kArgument;
  ObjectKind object = ObjectKind::kNone;
  std::int64_t object_id = -1;  ///< 0-based index of the material, layer ..., -1 = none
  std::int64_t item = -1;       ///< 0-based vertex index, -1 = none
  double x = kNone, y = kNone;  ///< where, in the scene's coordinates, NaN = nowhere in particular
  double value = kNone;         ///< the offending value, NaN = none
  std::string text;
};

/// Thrown inside the engine only; the C face turns it into a status and an error record on the object.
class Error : public std::runtime_error {
 public:
  explicit Error(Issue issue) : std::runtime_error(issue.text), issue_(std::move(issue)) {}
  Error(Status status, const std::string& text) : Error(make(status, text)) {}
  const Issue& issue() const { return issue_; }

 private:
  static Issue make(Status status, const std::string& text) {
    Issue issue;
    issue.status = status;
    issue.text = text;
    return issue;
  }
  Issue issue_;
};

}  // namespace vbgpd
