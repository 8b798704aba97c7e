/* A slope failed by its strength reduction factor runs out through the C face: hand-over, job, ground, refusals. */
#include "slope.h"

static void refusals(vbgpd_model* at_rest, vbgpd_model* moving) {
  vbgpd_job* job = NULL;
  vbgpd_model* model = NULL;
  double value = 0;
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_job_create_runout(at_rest, &job));
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_job_create_strength_reduction(moving, &job));
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_job_create_equilibrium(moving, &job));
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_model_create_runout(moving, &model));
  CHECK(job == NULL && model == NULL);
  /* numbers of the model at rest that a run-out has no use for are refused, not swallowed */
  CHECK_STATUS(VBGPD_E_UNSUPPORTED, vbgpd_model_set_f64(moving, "kh", VBGPD_STRLEN, 0.1));
  CHECK_STATUS(VBGPD_E_UNSUPPORTED, vbgpd_model_get_f64(moving, "kh", VBGPD_STRLEN, &value));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_set_f64(moving, "damping", VBGPD_STRLEN, 2));
  CHECK_STATUS(VBGPD_E_UNSUPPORTED, vbgpd_model_set_layer_active(moving, 0, 0));
}

static void ground_of(const vbgpd_model* model, double* lowest, double* highest) {
  double xy[200];
  int64_t n = 0, i;
  CHECK_OK(vbgpd_model_ground_surface(model, NULL, 16, 0, &n));
  CHECK(n > 5 && n < 100);
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_model_ground_surface(model, xy, 16, n - 1, &n));
  CHECK_OK(vbgpd_model_ground_surface(model, xy, 16, 100, &n));
  *lowest = *highest = xy[1];
  for (i = 1; i < n; ++i) {
    CHECK(xy[2 * i] > xy[2 * i - 2]);
    if (xy[2 * i + 1] < *lowest) *lowest = xy[2 * i + 1];
    if (xy[2 * i + 1] > *highest) *highest = xy[2 * i + 1];
  }
}

int main(void) {
  vbgpd_context* context = make_context();
  vbgpd_model *at_rest = make_model(context, 1), *moving = NULL;
  vbgpd_job* job = NULL;
  vbgpd_advance_result advance;
  uint64_t before = 0, after = 0;
  double low, high, value = 0;
  CHECK_OK(vbgpd_model_state_hash(at_rest, &before));
  CHECK_OK(vbgpd_model_set_f64(at_rest, "strength_reduction_factor", VBGPD_STRLEN, 3));
  CHECK_OK(vbgpd_model_create_runout(at_rest, &moving));
  refusals(at_rest, moving);
  CHECK_OK(vbgpd_model_get_f64(moving, "strength_reduction_factor", VBGPD_STRLEN, &value));
  CHECK(value == 3);
  CHECK_OK(vbgpd_job_create_runout(moving, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "end_time", VBGPD_STRLEN, 1.5));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK(job_number(job, "crest_settlement") > 0.1);
  CHECK(job_number(job, "moved_area") > 1);
  CHECK(job_number(job, "plastic_fraction") > 0.2);
  CHECK(job_number(job, "energy_residual") < 0.01);
  ground_of(moving, &low, &high);
  CHECK(high > 12 && high <= 15.5 && low > 4 && low < 6);
  advance.struct_size = sizeof advance;
  CHECK_OK(vbgpd_model_step(moving, 10, &advance));
  CHECK(advance.steps == 10 && advance.time > 1.5 && advance.max_displacement > 0.1);
  CHECK_OK(vbgpd_model_state_hash(at_rest, &after));
  CHECK(before == after); /* the model it came from is not changed */
  CHECK_OK(vbgpd_model_destroy(moving));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(at_rest));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
