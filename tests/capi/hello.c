/* The whole life cycle: a slope built by calls, its factor of safety in slices, fields and results. */
#include "slope.h"

static vbgpd_progress run_in_slices(vbgpd_job* job) {
  vbgpd_progress progress;
  vbgpd_status status;
  double last_fraction = 0;
  int64_t slices = 0;
  memset(&progress, 0, sizeof progress);
  progress.struct_size = sizeof progress;
  do {
    status = vbgpd_job_run(job, 0.001, NULL, NULL, &progress);
    CHECK(progress.fraction >= 0 && progress.fraction <= 1);
    CHECK(progress.fraction >= last_fraction - 0.5); /* an estimate: it may step back, not start again */
    last_fraction = progress.fraction;
    ++slices;
  } while (status == VBGPD_LIMIT_REACHED);
  CHECK_STATUS(VBGPD_OK, status);
  CHECK(slices > 1);
  CHECK(progress.steps > 0);
  return progress;
}

static void check_results(const vbgpd_job* job) {
  vbgpd_trial trial;
  vbgpd_level level;
  int64_t i, n = 0, stable = 0;
  double xy[2000];
  char text[64];
  const double fs = job_number(job, "factor_of_safety");
  /* Bishop-type charts give about 0.9 to 1.2 for c/(gamma H) = 0.06, phi = 20, 45 degrees; the bounds are wide on
   * purpose. */
  CHECK(fs > 0.6 && fs < 1.6);
  CHECK(job_number(job, "srf_stable") <= job_number(job, "srf_unstable"));
  trial.struct_size = sizeof trial;
  for (i = 0; vbgpd_job_trial(job, i, &trial) == VBGPD_OK; ++i) {
    CHECK(trial.strength_reduction_factor > 0);
    stable += trial.verdict == VBGPD_VERDICT_STABLE;
  }
  CHECK(i > 1 && stable > 0);
  CHECK_STATUS(VBGPD_END_OF_DATA, vbgpd_job_trial(job, i, &trial));
  level.struct_size = sizeof level;
  CHECK_OK(vbgpd_job_level(job, 0, &level));
  CHECK(level.particles > 0 && level.spacing_x > 0);
  CHECK_STATUS(VBGPD_END_OF_DATA, vbgpd_job_level(job, 1, &level));
  CHECK_OK(vbgpd_job_get_text(job, "status", VBGPD_STRLEN, text, sizeof text, NULL));
  CHECK(strcmp(text, "OK") == 0);
  CHECK_OK(vbgpd_job_slip_surface(job, xy, 16, 1000, &n));
  CHECK(n >= 2);
  CHECK(xy[0] < xy[2 * (n - 1)]);
}

static void check_fields(const vbgpd_model* model) {
  int64_t particles = -1, fields = 0, i, n = -1;
  double* values;
  CHECK_OK(vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, &particles));
  CHECK(particles > 0);
  CHECK((double)particles == model_number(model, "particles"));
  CHECK_OK(vbgpd_field_count(&fields));
  CHECK(fields > 0);
  for (i = 0; i < fields; ++i) {
    vbgpd_field_info info;
    int32_t found = -1;
    int64_t k, items = 0;
    info.struct_size = sizeof info;
    CHECK_OK(vbgpd_field_info_at(i, &info));
    CHECK(info.name[0] != 0 && info.unit[0] != 0 && info.doc[0] != 0 && info.components > 0);
    CHECK_OK(vbgpd_field_find(info.name, VBGPD_STRLEN, &found));
    CHECK(found == i);
    CHECK_OK(vbgpd_model_item_count(model, info.location, &items));
    values = (double*)malloc((size_t)(items * info.components + 1) * sizeof *values);
    CHECK(values != NULL);
    CHECK_OK(vbgpd_model_read_f64(model, found, values, 0, 0, items, &n));
    CHECK(n == items);
    for (k = 0; k < items * info.components; ++k) CHECK(isfinite(values[k]) || info.type == VBGPD_TYPE_F64);
    free(values);
  }
}

int main(void) {
  vbgpd_context* context = make_context();
  vbgpd_model* model = make_model(context, 1.25);
  vbgpd_job* job = NULL;
  uint64_t before = 0, after = 0;
  CHECK_OK(vbgpd_model_state_hash(model, &before));
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "levels", VBGPD_STRLEN, 1));
  run_in_slices(job);
  check_results(job);
  check_fields(model);
  CHECK_OK(vbgpd_model_state_hash(model, &after));
  CHECK(before != after);
  /* Parents first: the job keeps what it needs. */
  CHECK_OK(vbgpd_context_destroy(context));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK(job_number(job, "factor_of_safety") > 0);
  CHECK_OK(vbgpd_job_destroy(job));
  return 0;
}
