#include "engine.h"

#include <unistd.h>

#include <algorithm>
#include <limits>

#include "format.h"

namespace cli {

namespace {

constexpr std::int64_t kPointStride = sizeof(Point);

/// Text by the size-then-copy habit of the ABI; read(buffer, capacity, needed).
template <class Read>
vbgpd_status read_text(Read&& read, std::string& out) {
  std::int64_t needed = 0;
  const vbgpd_status asked = read(nullptr, 0, &needed);
  if (asked != VBGPD_OK && asked != VBGPD_E_BUFFER) return asked;
  out.resize(static_cast<std::size_t>(needed) + 1);
  const vbgpd_status status = read(out.data(), needed + 1, &needed);
  out.resize(static_cast<std::size_t>(needed));
  return status;
}

template <class Object, class Error>
std::string last_error(const Object* object, Error error) {
  std::string sentence;
  const auto read = [&](char* buffer, std::int64_t capacity, std::int64_t* needed) {
    return error(object, nullptr, buffer, capacity, needed);
  };
  if (read_text(read, sentence) != VBGPD_OK || sentence.empty()) return "the engine gave no reason";
  return sentence;
}

/// Points by the same habit; read(xy, capacity, n).
template <class Object, class Read>
std::vector<Point> read_points(const Object* object, Read&& read) {
  std::int64_t n = 0;
  const vbgpd_status asked = read(nullptr, 0, &n);
  if (asked == VBGPD_E_STATE) return {};
  if (asked != VBGPD_E_BUFFER) require(asked, object);
  std::vector<Point> points(static_cast<std::size_t>(n));
  if (n > 0) require(read(&points[0].x, n, &n), object);
  return points;
}

}  // namespace

std::string error_text(const vbgpd_context* object) { return last_error(object, vbgpd_context_error); }
std::string error_text(const vbgpd_profile* object) { return last_error(object, vbgpd_profile_error); }
std::string error_text(const vbgpd_model* object) { return last_error(object, vbgpd_model_error); }
std::string error_text(const vbgpd_job* object) { return last_error(object, vbgpd_job_error); }

Context create_context(int threads) {
  // a spacing typed too fine is refused with one that would fit, before the machine is out of memory
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  vbgpd_context_desc description;
  vbgpd_context_desc_init(&description, sizeof description);
  description.abi_version = VBGPD_ABI_VERSION;
  description.threads = threads;
  if (pages > 0 && page > 0) description.max_bytes = static_cast<std::int64_t>(pages) / 4 * 3 * page;
  vbgpd_context* context = nullptr;
  const vbgpd_status status = vbgpd_context_create(&description, &context);
  if (status != VBGPD_OK)
    throw EngineError(status, std::string("the engine does not start: ") + vbgpd_status_name(status));
  return Context(context);
}

std::vector<Issue> validate(vbgpd_profile* profile) {
  std::int64_t errors = 0, warnings = 0;
  require(vbgpd_profile_validate(profile, &errors, &warnings), profile);
  std::vector<Issue> issues;
  for (std::int64_t i = 0; i < errors + warnings; ++i) {
    vbgpd_error_info info{};
    info.struct_size = sizeof info;
    Issue issue;
    const auto read = [&](char* buffer, std::int64_t capacity, std::int64_t* needed) {
      return vbgpd_profile_issue(profile, i, &info, buffer, capacity, needed);
    };
    require(read_text(read, issue.text), profile);
    issue.error = info.status != VBGPD_OK;
    issues.push_back(std::move(issue));
  }
  std::stable_partition(issues.begin(), issues.end(), [](const Issue& issue) { return issue.error; });
  return issues;
}

std::int64_t count(const vbgpd_profile* profile, std::int32_t kind) {
  std::int64_t n = 0;
  require(vbgpd_profile_count(profile, kind, &n), profile);
  return n;
}

double number(const vbgpd_profile* profile, std::int32_t kind, std::int64_t id, const char* name) {
  double value = 0;
  require(vbgpd_profile_get_f64(profile, kind, id, name, VBGPD_STRLEN, &value), profile);
  return value;
}

std::string text(const vbgpd_profile* profile, std::int32_t kind, std::int64_t id, const char* name) {
  std::string value;
  const auto read = [&](char* buffer, std::int64_t capacity, std::int64_t* needed) {
    return vbgpd_profile_get_text(profile, kind, id, name, VBGPD_STRLEN, buffer, capacity, needed);
  };
  require(read_text(read, value), profile);
  return value;
}

std::vector<Point> polygon(const vbgpd_profile* profile, std::int32_t kind, std::int64_t id) {
  return read_points(profile, [&](double* xy, std::int64_t capacity, std::int64_t* n) {
    return vbgpd_profile_polygon(profile, kind, id, xy, kPointStride, capacity, n);
  });
}

std::vector<Point> water_table(const vbgpd_profile* profile) {
  return read_points(profile, [&](double* xy, std::int64_t capacity, std::int64_t* n) {
    return vbgpd_profile_water_table(profile, xy, kPointStride, capacity, n);
  });
}

double number(const vbgpd_model* model, const char* name) {
  double value = 0;
  require(vbgpd_model_get_f64(model, name, VBGPD_STRLEN, &value), model);
  return value;
}

std::string state_hash(const vbgpd_model* model) {
  std::uint64_t hash = 0;
  require(vbgpd_model_state_hash(model, &hash), model);
  return format("%016llx", static_cast<unsigned long long>(hash));
}

std::vector<Point> ground_surface(const vbgpd_model* model) {
  return read_points(model, [&](double* xy, std::int64_t capacity, std::int64_t* n) {
    return vbgpd_model_ground_surface(model, xy, kPointStride, capacity, n);
  });
}

std::vector<double> field(const vbgpd_model* model, const char* name) {
  std::int32_t index = -1;
  const vbgpd_status found = vbgpd_field_find(name, VBGPD_STRLEN, &index);
  if (found != VBGPD_OK) throw EngineError(found, std::string("the engine has no field '") + name + "'");
  vbgpd_field_info info{};
  info.struct_size = sizeof info;
  require(vbgpd_field_info_at(index, &info), model);
  std::int64_t n = 0;
  require(vbgpd_model_item_count(model, info.location, &n), model);
  std::vector<double> values(static_cast<std::size_t>(n * info.components));
  require(vbgpd_model_read_f64(model, index, values.data(), 0, 0, n, nullptr), model);
  return values;
}

double number(const vbgpd_job* job, const char* name) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const vbgpd_status status = vbgpd_job_get_f64(job, name, VBGPD_STRLEN, &value);
  if (status == VBGPD_E_STATE) return std::numeric_limits<double>::quiet_NaN();
  require(status, job);
  return value;
}

std::string text(const vbgpd_job* job, const char* name) {
  std::string value;
  const auto read = [&](char* buffer, std::int64_t capacity, std::int64_t* needed) {
    return vbgpd_job_get_text(job, name, VBGPD_STRLEN, buffer, capacity, needed);
  };
  const vbgpd_status status = read_text(read, value);
  if (status == VBGPD_E_STATE) return "";
  require(status, job);
  return value;
}

std::vector<Point> slip_surface(const vbgpd_job* job) {
  return read_points(job, [&](double* xy, std::int64_t capacity, std::int64_t* n) {
    return vbgpd_job_slip_surface(job, xy, kPointStride, capacity, n);
  });
}

}  // namespace cli
