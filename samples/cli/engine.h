// Thin RAII over vbgpd.h: handles that free themselves, and failures as exceptions that carry the engine's own
// sentence.
#pragma once

#include <vbgpd/vbgpd.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace cli {

template <auto Destroy>
struct Destroyer {
  template <class T>
  void operator()(T* handle) const {
    Destroy(handle);
  }
};
using Context = std::unique_ptr<vbgpd_context, Destroyer<vbgpd_context_destroy>>;
using Profile = std::unique_ptr<vbgpd_profile, Destroyer<vbgpd_profile_destroy>>;
using Model = std::unique_ptr<vbgpd_model, Destroyer<vbgpd_model_destroy>>;
using Job = std::unique_ptr<vbgpd_job, Destroyer<vbgpd_job_destroy>>;

struct Point {
  double x = 0, y = 0;
};

class EngineError : public std::runtime_error {
 public:
  EngineError(vbgpd_status status, const std::string& text) : std::runtime_error(text), status_(status) {}
  vbgpd_status status() const { return status_; }

 private:
  vbgpd_status status_;
};

/// The engine's sentence about the last failure of a call on this object; may have several lines, one per fault.
std::string error_text(const vbgpd_context* object);
std::string error_text(const vbgpd_profile* object);
std::string error_text(const vbgpd_model* object);
std::string error_text(const vbgpd_job* object);

/// Throws EngineError when a call on `object` failed; hands other outcomes (VBGPD_CANCELLED ...) back.
template <class Object>
vbgpd_status require(vbgpd_status status, const Object* object) {
  if (status < 0) throw EngineError(status, error_text(object));
  return status;
}

/// One engine context with that many threads (0 = all cores).
Context create_context(int threads);

/// What the engine has to say about a profile.
struct Issue {
  bool error = false;
  std::string text;
  std::size_t line = 0, column = 0;  ///< in the scene file, from 1; 0 = nowhere in particular
};
/// All of them, errors first.
std::vector<Issue> validate(vbgpd_profile* profile);

std::int64_t count(const vbgpd_profile* profile, std::int32_t kind);
double number(const vbgpd_profile* profile, std::int32_t kind, std::int64_t id, const char* name);
std::string text(const vbgpd_profile* profile, std::int32_t kind, std::int64_t id, const char* name);
std::vector<Point> polygon(const vbgpd_profile* profile, std::int32_t kind, std::int64_t id);
std::vector<Point> water_table(const vbgpd_profile* profile);

double number(const vbgpd_model* model, const char* name);
std::string state_hash(const vbgpd_model* model);
/// The present ground surface from left to right.
std::vector<Point> ground_surface(const vbgpd_model* model);
/// All items of a field, packed rows.
std::vector<double> field(const vbgpd_model* model, const char* name);

/// NaN or "" while the job has not finished.
double number(const vbgpd_job* job, const char* name);
std::string text(const vbgpd_job* job, const char* name);
std::vector<Point> slip_surface(const vbgpd_job* job);

}  // namespace cli
