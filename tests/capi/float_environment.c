/* R2: whatever rounding, traps and flush-to-zero the host has set, the engine computes the same bits and hands it back.
 */
#if defined(__GLIBC__) || defined(__linux__)
#define _GNU_SOURCE /* feenableexcept */
#endif
#include <fenv.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "slope.h"

static unsigned control_word(void) {
#if defined(__SSE__)
  return _mm_getcsr();
#else
  return 0;
#endif
}

static void set_host_environment(void) {
  CHECK(fesetround(FE_UPWARD) == 0);
  feclearexcept(FE_ALL_EXCEPT);
#if defined(__SSE__)
  _mm_setcsr(_mm_getcsr() | 0x8040); /* flush to zero, denormals are zero */
#endif
#if defined(__GLIBC__)
  feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW); /* as Fortran hosts do */
#endif
}

typedef struct {
  unsigned control;
  int rounding, calls;
} seen;

static int32_t VBGPD_CALL look(void* user, const vbgpd_progress* p) {
  seen* s = (seen*)user;
  (void)p;
  s->control = control_word();
  s->rounding = fegetround();
  return ++s->calls > 2;
}

static uint64_t hash_of_a_run(int32_t threads, int64_t steps) {
  vbgpd_context_desc desc;
  vbgpd_context* context = NULL;
  vbgpd_model* model;
  vbgpd_advance_result result;
  uint64_t hash = 0;
  CHECK_OK(vbgpd_context_desc_init(&desc, sizeof desc));
  desc.threads = threads;
  CHECK_OK(vbgpd_context_create(&desc, &context));
  model = make_model(context, 0.5);
  result.struct_size = sizeof result;
  CHECK_OK(vbgpd_model_step(model, steps, &result));
  CHECK_OK(vbgpd_model_state_hash(model, &hash));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_context_destroy(context));
  return hash;
}

static void failing_calls(void) {
  vbgpd_context* context = make_context();
  vbgpd_profile* profile = NULL;
  vbgpd_model* model = NULL;
  double value = 0;
  CHECK_OK(vbgpd_profile_create(context, &profile));
  CHECK(vbgpd_model_create(context, profile, &model) < 0);
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_profile_get_f64(profile, VBGPD_OBJECT_PROFILE, 0, "x", 1, &value));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_context_destroy(context));
}

static void callback_sees_the_hosts(unsigned control) {
  vbgpd_context* context = make_context();
  vbgpd_model* model = make_model(context, 0.15);
  vbgpd_job* job = NULL;
  seen s = {0, 0, 0};
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_job_run(job, 0, look, &s, NULL));
  CHECK(s.rounding == FE_UPWARD && s.control == control);
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_context_destroy(context));
}

int main(void) {
  const uint64_t expected = hash_of_a_run(1, 200);
  unsigned control;
  uint64_t hash, hash_of_workers;
  set_host_environment();
  control = control_word();
  hash = hash_of_a_run(1, 200);
  hash_of_workers = hash_of_a_run(3, 200); /* threads inherit the environment of the one that starts them */
  failing_calls();
  CHECK(fegetround() == FE_UPWARD);
  CHECK(fetestexcept(FE_ALL_EXCEPT) == 0);
  CHECK(control_word() == control);
  callback_sees_the_hosts(control);
  CHECK(fegetround() == FE_UPWARD && control_word() == control);
  CHECK(hash == expected);
  CHECK(hash_of_workers == expected);
  CHECK(hash != hash_of_a_run(1, 201));
  fesetenv(FE_DFL_ENV);
  return 0;
}
