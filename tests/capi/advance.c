/* Advancing to an exact time, in slices, and saved states. */
#include "slope.h"

static uint64_t hash_of(const vbgpd_model* model) {
  uint64_t hash = 0;
  CHECK_OK(vbgpd_model_state_hash(model, &hash));
  return hash;
}

static void ends_exactly_at_its_time(vbgpd_context* context) {
  static const double times[] = {0.1, 0.1, 0.25, 1.0 / 3, 0.5};
  vbgpd_model* model = make_model(context, 1);
  vbgpd_advance_result r;
  int i;
  r.struct_size = sizeof r;
  for (i = 0; i < 5; ++i) {
    const double stable = model_number(model, "stable_time_step");
    CHECK_OK(vbgpd_model_advance_to(model, times[i], 0, NULL, NULL, &r));
    CHECK(r.time == times[i] && model_number(model, "time") == times[i]);
    CHECK(r.time_step <= stable);
  }
  CHECK(model_number(model, "energy_residual") < 0.01); /* every new step length costs leap-frog a little */
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_advance_to(model, 0.4, 0, NULL, NULL, &r));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_advance_to(model, NAN, 0, NULL, NULL, &r));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_advance_to(model, INFINITY, 0, NULL, NULL, &r));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_advance_to(model, 1, NAN, NULL, NULL, &r));
  CHECK(model_number(model, "time") == 0.5);
  CHECK_OK(vbgpd_model_destroy(model));
}

static int32_t VBGPD_CALL stop_now(void* user, const vbgpd_progress* p) {
  *(int*)user += p->struct_size == sizeof *p && p->fraction >= 0 && p->fraction <= 1 && p->steps > 0;
  return 1;
}

static void slices_change_no_bit(vbgpd_context* context) {
  vbgpd_model *whole = make_model(context, 0.5), *sliced = make_model(context, 0.5);
  const clock_t start = clock();
  double slice;
  int slices = 0, calls = 0;
  vbgpd_status s;
  CHECK_OK(vbgpd_model_advance_to(whole, 1.5, 0, NULL, NULL, NULL));
  slice = a_tenth_since(start);
  while ((s = vbgpd_model_advance_to(sliced, 1.5, slice, NULL, NULL, NULL)) == VBGPD_LIMIT_REACHED) ++slices;
  CHECK_STATUS(VBGPD_OK, s);
  CHECK(slices > 1);
  CHECK(hash_of(whole) == hash_of(sliced));
  CHECK_OK(vbgpd_model_cancel(whole));
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_model_advance_to(whole, 2, 0, NULL, NULL, NULL));
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_model_advance_to(whole, 1e3, 0, stop_now, &calls, NULL));
  CHECK(calls == 1);
  CHECK_OK(vbgpd_model_destroy(whole));
  CHECK_OK(vbgpd_model_destroy(sliced));
}

static vbgpd_job* job_of_the_model;

static int32_t VBGPD_CALL call_back_in(void* user, const vbgpd_progress* p) {
  double value;
  (void)p;
  CHECK_OK(vbgpd_job_get_f64(job_of_the_model, "factor_of_safety", VBGPD_STRLEN, &value));
  CHECK_STATUS(VBGPD_E_REENTRANT, vbgpd_job_get_f64(job_of_the_model, "bonds", VBGPD_STRLEN, &value));
  CHECK_STATUS(VBGPD_E_REENTRANT, vbgpd_model_step((vbgpd_model*)user, 1, NULL));
  return 1;
}

/* The implicit pattern: save, try, take back, try otherwise. */
static void states_bring_back_everything(vbgpd_context* context) {
  vbgpd_model *model = make_model(context, 1), *other = make_model(context, 1);
  vbgpd_state *state = NULL, *same;
  const double xy[6] = {0, 0, 40, 0, 0, 15}, pressure[3] = {50e3, 50e3, 0};
  int32_t pore;
  uint64_t saved, tried;
  double residual;
  CHECK_OK(vbgpd_field_find("pore_pressure", VBGPD_STRLEN, &pore));
  CHECK_OK(vbgpd_model_advance_to(model, 0.1, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_model_save_state(model, &state));
  saved = hash_of(model);
  residual = model_number(model, "external_work");
  CHECK_OK(vbgpd_model_advance_to(model, 0.2, 0, NULL, NULL, NULL));
  tried = hash_of(model);
  CHECK(tried != saved);
  CHECK_OK(vbgpd_model_restore_state(model, state));
  CHECK(hash_of(model) == saved && model_number(model, "time") == 0.1);
  CHECK(model_number(model, "external_work") == residual);
  CHECK_OK(vbgpd_model_write_points(model, pore, xy, 16, pressure, 0, 0, 3));
  CHECK_OK(vbgpd_model_advance_to(model, 0.2, 0, NULL, NULL, NULL));
  CHECK(hash_of(model) != tried);
  CHECK_OK(vbgpd_model_restore_state(model, state)); /* takes the pressure back as well */
  CHECK_OK(vbgpd_model_advance_to(model, 0.2, 0, NULL, NULL, NULL));
  CHECK(hash_of(model) == tried);
  same = state;
  CHECK_OK(vbgpd_model_save_state(model, &state));
  CHECK(same == state);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_restore_state(other, state));
  CHECK_STATUS(VBGPD_E_HANDLE, vbgpd_model_restore_state(model, NULL));
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job_of_the_model));
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_model_advance_to(model, 1e3, 0, call_back_in, model, NULL));
  CHECK_OK(vbgpd_job_destroy(job_of_the_model));
  CHECK_OK(vbgpd_model_destroy(model)); /* before its state */
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_restore_state(other, state));
  CHECK_OK(vbgpd_state_destroy(state));
  CHECK_STATUS(VBGPD_E_HANDLE, vbgpd_state_destroy(state));
  CHECK_OK(vbgpd_state_destroy(NULL));
  CHECK_OK(vbgpd_model_destroy(other));
}

/* A job counts on its model from its first slice to its last. */
static void jobs_under_way_keep_their_model(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 0.5);
  vbgpd_job *job = NULL, *other = NULL;
  CHECK_OK(vbgpd_job_create_equilibrium(model, &job));
  CHECK_OK(vbgpd_job_create_equilibrium(model, &other));
  CHECK_OK(vbgpd_model_step(model, 1, NULL)); /* not begun yet */
  CHECK_STATUS(VBGPD_LIMIT_REACHED, vbgpd_job_run(job, 1e-6, NULL, NULL, NULL));
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_model_step(model, 1, NULL));
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_model_set_f64(model, "kh", VBGPD_STRLEN, 0.1));
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_job_run(other, 1e-6, NULL, NULL, NULL));
  CHECK(model_number(model, "particles") > 0); /* reading is free */
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_step(model, 1, NULL));
  CHECK(vbgpd_job_run(other, 0, NULL, NULL, NULL) >= 0);
  CHECK_OK(vbgpd_model_step(model, 1, NULL));
  CHECK_OK(vbgpd_job_destroy(other));
  CHECK_OK(vbgpd_model_destroy(model));
}

int main(void) {
  vbgpd_context* context = make_context();
  int64_t epoch = -1;
  vbgpd_model* model = make_model(context, 2.5);
  CHECK_OK(vbgpd_model_epoch(model, &epoch));
  CHECK(epoch == 0);
  CHECK_OK(vbgpd_model_destroy(model));
  ends_exactly_at_its_time(context);
  slices_change_no_bit(context);
  states_bring_back_everything(context);
  jobs_under_way_keep_their_model(context);
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
