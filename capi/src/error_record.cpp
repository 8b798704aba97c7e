#include "error_record.h"

#include <new>
#include <stdexcept>

namespace vbgpd::capi {
namespace {

ErrorRecord plain(Status status, std::string text) {
  ErrorRecord record;
  record.issue.status = status;
  record.issue.text = std::move(text);
  return record;
}

// A failure must be negative for the caller, whatever was thrown.
ErrorRecord of_error(const Error& error, int argument) {
  ErrorRecord record;
  record.issue = error.issue();
  record.argument = argument;
  if (static_cast<std::int32_t>(record.issue.status) >= 0) record.issue.status = Status::kInternal;
  return record;
}

ErrorRecord current_exception_record() {
  try {
    throw;
  } catch (const ArgumentError& error) {
    return of_error(error, error.argument());
  } catch (const Error& error) {
    return of_error(error, 0);
  } catch (const std::bad_alloc&) {
    return plain(Status::kMemory, "There is not enough memory for this call.");
  } catch (const std::length_error&) {
    return plain(Status::kMemory, "This call asks for more memory than an address space holds.");
  } catch (const std::exception& error) {
    return plain(Status::kInternal, std::string("Internal error: ") + error.what());
  } catch (...) {
    return plain(Status::kInternal, "Internal error: an exception of an unknown type was thrown.");
  }
}

}  // namespace

Status ErrorRecord::keep_current_exception() noexcept {
  try {
    *this = current_exception_record();
  } catch (...) {
    issue.status = Status::kMemory;
    issue.object = ObjectKind::kNone;
    issue.object_id = issue.item = -1;
    issue.x = issue.y = issue.value = kNone;
    issue.text.clear();
    argument = 0;
  }
  return issue.status;
}

}  // namespace vbgpd::capi
