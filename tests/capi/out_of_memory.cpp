// Memory that runs out at the n-th allocation, for every n: the call says VBGPD_E_MEMORY, the object is as it was, and
// nothing is left behind. This program's operator new is the library's, too.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <new>

#include "slope.h"

namespace {

std::int64_t allocations, alive, fail_at = -1;  // fail_at < 0: never

void* allocate(std::size_t size, std::size_t alignment) {
  if (fail_at >= 0 && allocations++ >= fail_at) throw std::bad_alloc();
  void* p = nullptr;
  if (posix_memalign(&p, alignment < sizeof(void*) ? sizeof(void*) : alignment, size ? size : 1) != 0)
    throw std::bad_alloc();
  ++alive;
  return p;
}

void release(void* p) noexcept {
  if (p) --alive;
  std::free(p);
}

}  // namespace

void* operator new(std::size_t n) { return allocate(n, 16); }
void* operator new(std::size_t n, std::align_val_t a) { return allocate(n, static_cast<std::size_t>(a)); }
void operator delete(void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }

namespace {

vbgpd_context* context;
vbgpd_profile* profile;
vbgpd_model* model;
vbgpd_state* state;

std::uint64_t hash() {
  std::uint64_t h = 0;
  CHECK_OK(vbgpd_model_state_hash(model, &h));
  return h;
}

/// What a model is: its state, and how it would go on.
struct Fingerprint {
  std::uint64_t now, later;
  bool operator==(const Fingerprint& o) const { return now == o.now && later == o.later; }
};

Fingerprint fingerprint() {
  Fingerprint f;
  vbgpd_state* kept = nullptr;
  CHECK_OK(vbgpd_model_save_state(model, &kept));
  f.now = hash();
  CHECK_OK(vbgpd_model_step(model, 2, nullptr));
  f.later = hash();
  CHECK_OK(vbgpd_model_restore_state(model, kept));
  CHECK_OK(vbgpd_state_destroy(kept));
  return f;
}

/// Calls until no allocation fails; `undo` takes back what the call that succeeded did.
void survives(
    const char* name, const std::function<vbgpd_status()>& call, const std::function<void()>& undo = [] {}) {
  CHECK_OK(call());  // lazily made caches are made
  undo();
  const Fingerprint before = fingerprint();
  const std::int64_t alive_before = alive;
  for (std::int64_t n = 0;; n += 1 + n / 64) {
    allocations = 0, fail_at = n;
    const vbgpd_status s = call();
    fail_at = -1;
    if (s == VBGPD_OK) {
      std::printf("%-40s survived failures at %lld places\n", name, static_cast<long long>(n));
      break;
    }
    if (s != VBGPD_E_MEMORY || !(fingerprint() == before)) {
      std::fprintf(stderr, "%s: %s at allocation %lld\n", name, vbgpd_status_name(s), static_cast<long long>(n));
      std::exit(1);
    }
  }
  undo();
  CHECK(fingerprint() == before);
  // an error record keeps its sentence; nothing else may stay
  CHECK(alive <= alive_before + 4);
}

/// Threads that cannot be started are done without: nothing ends the process, the model works on.
void threads_may_be_missing() {
  vbgpd_context_desc desc;
  CHECK_OK(vbgpd_context_desc_init(&desc, sizeof desc));
  desc.threads = 3;
  vbgpd_context* several = nullptr;
  CHECK_OK(vbgpd_context_create(&desc, &several));
  std::uint64_t expected = 0, got = 0;
  vbgpd_model* one = nullptr;
  CHECK_OK(vbgpd_model_create(context, profile, &one));
  CHECK_OK(vbgpd_model_step(one, 2, nullptr));
  CHECK_OK(vbgpd_model_state_hash(one, &expected));
  CHECK_OK(vbgpd_model_destroy(one));
  for (std::int64_t n = 0; n < 40; ++n) {
    CHECK_OK(vbgpd_model_create(several, profile, &one));
    CHECK_OK(vbgpd_model_step(one, 0, nullptr));
    allocations = 0, fail_at = n;
    const vbgpd_status s = vbgpd_model_step(one, 2, nullptr);
    fail_at = -1;
    CHECK(s == VBGPD_OK || s == VBGPD_E_MEMORY);
    if (s != VBGPD_OK) CHECK_OK(vbgpd_model_step(one, 2, nullptr));
    CHECK_OK(vbgpd_model_state_hash(one, &got));
    CHECK(got == expected);
    CHECK_OK(vbgpd_model_destroy(one));
  }
  CHECK_OK(vbgpd_context_destroy(several));
}

/// A job that runs out of memory under way is over and says so again, one that did not get to begin may begin again;
/// the model works on, and nothing of the job stays behind.
void job_survives(const char* name, vbgpd_status (*make)(vbgpd_model*, vbgpd_job**)) {
  const Fingerprint before = fingerprint();
  std::int64_t alive_before = -1, places = 0;
  for (std::int64_t n = 0;; n += 1 + n / 8, ++places) {
    vbgpd_job* job = nullptr;
    CHECK_OK(make(model, &job));
    allocations = 0, fail_at = n;
    const vbgpd_status s = vbgpd_job_run(job, 0, nullptr, nullptr, nullptr);
    fail_at = -1;
    if (s < 0) {
      CHECK_STATUS(VBGPD_E_MEMORY, s);
      const vbgpd_status again = vbgpd_job_run(job, 0, nullptr, nullptr, nullptr);
      CHECK(again == VBGPD_E_MEMORY || (again >= 0 && n < 3));
      CHECK_OK(vbgpd_job_error(job, nullptr, nullptr, 0, nullptr));
    }
    CHECK_OK(vbgpd_job_destroy(job));
    CHECK_OK(vbgpd_model_step(model, 1, nullptr));
    CHECK_OK(vbgpd_model_restore_state(model, state));
    CHECK(fingerprint() == before);
    if (s >= 0) break;
  }
  std::printf("%-40s survived failures at %lld places\n", name, static_cast<long long>(places));
  for (int k = 0; k < 2; ++k) {  // what the model keeps for jobs is made by now
    vbgpd_job* job = nullptr;
    CHECK_OK(make(model, &job));
    allocations = 0, fail_at = 5;
    CHECK_STATUS(VBGPD_E_MEMORY, vbgpd_job_run(job, 0, nullptr, nullptr, nullptr));
    fail_at = -1;
    CHECK_OK(vbgpd_job_destroy(job));
    CHECK_OK(vbgpd_model_restore_state(model, state));
    if (k > 0) CHECK(alive <= alive_before);
    alive_before = alive;
  }
}

/// A run-out whose memory ends in the middle of its steps stands after a whole one, and goes on as if nothing had been.
void run_out_survives() {
  constexpr std::int64_t kSteps = 400;
  vbgpd_model* flow = nullptr;
  CHECK_OK(vbgpd_model_set_f64(model, "strength_reduction_factor", VBGPD_STRLEN, 4));
  const auto start = [&] {
    if (flow) CHECK_OK(vbgpd_model_destroy(flow));
    flow = nullptr;
    CHECK_OK(vbgpd_model_create_runout(model, &flow));
  };
  const auto state_of = [&] {
    std::uint64_t h = 0;
    CHECK_OK(vbgpd_model_state_hash(flow, &h));
    return h;
  };
  start();
  CHECK_OK(vbgpd_model_step(flow, kSteps, nullptr));
  const std::uint64_t expected = state_of();
  CHECK(model_number(flow, "max_displacement") > 1);  // neighbours were searched for anew
  std::int64_t places = 0;
  for (std::int64_t n = 0;; n += 1 + n / 16, ++places) {
    start();
    allocations = 0, fail_at = n;
    const vbgpd_status s = vbgpd_model_step(flow, kSteps, nullptr);
    fail_at = -1;
    if (s != VBGPD_OK) CHECK_STATUS(VBGPD_E_MEMORY, s);
    const auto done = static_cast<std::int64_t>(model_number(flow, "steps"));
    CHECK(model_number(flow, "kinetic_energy") >= 0);
    if (done < kSteps) CHECK_OK(vbgpd_model_step(flow, kSteps - done, nullptr));
    CHECK(state_of() == expected);
    if (s == VBGPD_OK) break;
  }
  std::printf("%-40s survived failures at %lld places\n", "model_step of a run-out", static_cast<long long>(places));
  CHECK_OK(vbgpd_model_destroy(flow));
  CHECK_OK(vbgpd_model_restore_state(model, state));
}

std::int32_t field(const char* name) {
  std::int32_t f = -1;
  CHECK_OK(vbgpd_field_find(name, VBGPD_STRLEN, &f));
  return f;
}

}  // namespace

int main() {
  static const double corners[4] = {20e3, 10e3, 0, -20e3}, places[6] = {0, 0, 40, 0, 0, 15}, values[3] = {1e4, 2e4, 0};
  static double out[8000];
  static unsigned char bytes[1 << 20];
  static std::int64_t ids[4000];
  std::int64_t size = 0;
  context = make_context();
  profile = make_profile(context, 2);
  CHECK_OK(vbgpd_profile_add_load(profile, 2, 8, 10e3, 10e3, nullptr));
  static const double toe[] = {31, -1, 41, -1, 41, 6, 31, 6};
  CHECK_OK(vbgpd_profile_add_layer(profile, toe, 16, 4, 0, nullptr));
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  CHECK_OK(vbgpd_model_step(model, 20, nullptr));
  CHECK_OK(vbgpd_model_save_state(model, &state));
  CHECK_OK(vbgpd_model_checkpoint(model, bytes, sizeof bytes, &size));
  const std::int32_t pore = field("pore_pressure"), stress = field("stress");
  const auto restore = [] { CHECK_OK(vbgpd_model_restore_state(model, state)); };

  vbgpd_model* made = nullptr;
  const auto drop_model = [&] {
    CHECK_OK(vbgpd_model_destroy(made));
    made = nullptr;
  };
  survives(
      "model_create", [&] { return vbgpd_model_create(context, profile, &made); }, drop_model);
  survives(
      "model_create_from_checkpoint", [&] { return vbgpd_model_create_from_checkpoint(context, bytes, size, &made); },
      drop_model);
  vbgpd_profile* scene = nullptr;
  survives(
      "profile_create", [&] { return vbgpd_profile_create(context, &scene); },
      [&] {
        CHECK_OK(vbgpd_profile_destroy(scene));
        scene = nullptr;
      });
  survives("profile_to_flatbuffer", [&] { return vbgpd_profile_to_flatbuffer(profile, out, sizeof out, nullptr); });
  survives(
      "model_step", [] { return vbgpd_model_step(model, 3, nullptr); }, restore);
  survives(
      "model_advance_to", [] { return vbgpd_model_advance_to(model, 1, 0, nullptr, nullptr, nullptr); }, restore);
  survives(
      "model_set_f64", [] { return vbgpd_model_set_f64(model, "kh", VBGPD_STRLEN, 0.1); }, restore);
  survives(
      "model_set_f64 of the factor",
      [] { return vbgpd_model_set_f64(model, "strength_reduction_factor", VBGPD_STRLEN, 1.25); }, restore);
  survives(
      "model_set_load", [] { return vbgpd_model_set_load(model, 0, 30e3, 20e3); }, restore);
  survives(
      "model_set_layer_active", [] { return vbgpd_model_set_layer_active(model, 1, 0); }, restore);
  survives(
      "model_restore_state to other layers",
      [&] {
        const std::int64_t fail = fail_at;
        fail_at = -1;
        CHECK_OK(vbgpd_model_set_layer_active(model, 1, 0));
        const std::uint64_t dug = hash();
        fail_at = fail;
        const vbgpd_status s = vbgpd_model_restore_state(model, state);
        fail_at = -1;
        if (s == VBGPD_OK) return s;
        CHECK(hash() == dug);
        CHECK_OK(vbgpd_model_restore_state(model, state));
        return s;
      },
      restore);
  survives(
      "model_write_grid", [&] { return vbgpd_model_write_grid(model, pore, 0, 0, 40, 15, 2, 2, corners, 0); }, restore);
  survives(
      "model_write_points", [&] { return vbgpd_model_write_points(model, pore, places, 16, values, 0, 0, 3); },
      restore);
  std::int64_t n = 0;
  CHECK_OK(vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, &n));
  for (std::int64_t k = 0; k < 2 * n; ++k) out[k] = 10.0 * static_cast<double>(k % 7);
  survives(
      "model_write_f64", [&] { return vbgpd_model_write_f64(model, field("external_force"), nullptr, out, 0, 0, n); },
      restore);
  vbgpd_state* saved = nullptr;
  survives(
      "model_save_state", [&] { return vbgpd_model_save_state(model, &saved); },
      [&] {
        CHECK_OK(vbgpd_state_destroy(saved));
        saved = nullptr;
      });
  survives("model_save_state over another", [] { return vbgpd_model_save_state(model, &state); });
  survives("model_restore_state", [] { return vbgpd_model_restore_state(model, state); });
  survives("model_checkpoint", [&] { return vbgpd_model_checkpoint(model, bytes, sizeof bytes, &size); });
  survives("model_restore_checkpoint", [&] { return vbgpd_model_restore_checkpoint(model, bytes, size); });
  survives("model_select", [&] { return vbgpd_model_select(model, nullptr, ids, 8, 4000, nullptr); });
  survives("model_read_f64", [&] { return vbgpd_model_read_f64(model, stress, out, 0, 0, 2000, nullptr); });
  survives("model_read_selected_f64",
           [&] { return vbgpd_model_read_selected_f64(model, stress, nullptr, out, 0, 0, 2000, nullptr); });
  survives("model_sample_points",
           [&] { return vbgpd_model_sample_points(model, stress, places, 16, 3, out, 0, 0, nullptr, 0); });
  survives("model_ground_surface", [&] { return vbgpd_model_ground_surface(model, out, 16, 4000, nullptr); });
  survives("model_boundary_reaction", [&] { return vbgpd_model_boundary_reaction(model, 0, out, out + 1); });
  vbgpd_view view;
  view.struct_size = sizeof view;
  survives(
      "model_view_acquire", [&] { return vbgpd_model_view_acquire(model, field("displacement"), &view); },
      [&] { CHECK_OK(vbgpd_model_view_release(model, view.lease)); });
  survives("model_get_f64 of a forecast",
           [&] { return vbgpd_model_get_f64(model, "forecast_steps", VBGPD_STRLEN, out); });
  threads_may_be_missing();
  vbgpd_job* job = nullptr;
  survives(
      "job_create_strength_reduction", [&] { return vbgpd_job_create_strength_reduction(model, &job); },
      [&] {
        CHECK_OK(vbgpd_job_destroy(job));
        job = nullptr;
      });
  survives("model_snapshot", [&] { return vbgpd_model_snapshot(model, bytes, sizeof bytes, &size); });
  survives("build_info",
           [&] { return vbgpd_build_info(nullptr, 0, reinterpret_cast<char*>(bytes), sizeof bytes, &size); });
  job_survives("job_run of an equilibrium", vbgpd_job_create_equilibrium);
  job_survives("job_run of a strength reduction", vbgpd_job_create_strength_reduction);
  run_out_survives();
  CHECK_OK(vbgpd_state_destroy(state));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
