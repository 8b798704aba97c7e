/* Ground water through the C face: what is set can be read, what is wrong is said, what is wet is weaker. */
#include <math.h>

#include "slope.h"

static vbgpd_model* model_of(vbgpd_context* context, vbgpd_profile* profile) {
  vbgpd_model* model = NULL;
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  return model;
}

static double factor_of_safety(vbgpd_context* context, vbgpd_profile* profile) {
  vbgpd_model* model = model_of(context, profile);
  vbgpd_job* job = NULL;
  double factor;
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "levels", VBGPD_STRLEN, 1));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  factor = job_number(job, "factor_of_safety");
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
  return factor;
}

static void is_read_as_it_was_set(vbgpd_profile* profile) {
  const double table[] = {0, 12, 40, 4};
  double back[8] = {0};
  int64_t n = -1;
  CHECK_OK(vbgpd_profile_water_table(profile, NULL, 16, 0, &n));
  CHECK(n == 0);
  CHECK_OK(vbgpd_profile_set_water_table(profile, table, 16, 2));
  CHECK_OK(vbgpd_profile_water_table(profile, back, 16, 4, &n));
  CHECK(n == 2 && back[0] == 0 && back[1] == 12 && back[2] == 40 && back[3] == 4);
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_profile_water_table(profile, back, 16, 1, &n));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_set_water_table(profile, NULL, 16, 2));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_set_water_table(profile, table, 16, -1));
  CHECK_OK(vbgpd_profile_water_table(profile, NULL, 16, 0, &n));
  CHECK(n == 2); /* a refused call changes nothing */
}

static void faults_are_told(vbgpd_context* context, vbgpd_profile* profile) {
  const double backwards[] = {0, 12, 20, 8, 10, 9, 40, 4};
  int64_t errors = -1, warnings = -1;
  vbgpd_error_info info = {0};
  vbgpd_model* model = NULL;
  char text[300];
  info.struct_size = sizeof info;
  CHECK_OK(vbgpd_profile_set_water_table(profile, backwards, 16, 4));
  CHECK_OK(vbgpd_profile_validate(profile, &errors, &warnings));
  CHECK(errors == 1 && warnings == 0);
  CHECK_OK(vbgpd_profile_issue(profile, 0, &info, text, sizeof text, NULL));
  CHECK(strcmp(text, "water: table[2]: x = 10 m: must be right of x = 20 m of the point before") == 0);
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_create(context, profile, &model));
}

/* Pressures of a model: hydrostatic, taken over by a host, and those of r_u. */
static void fills_the_pores(vbgpd_context* context, vbgpd_profile* profile) {
  vbgpd_model* model = model_of(context, profile);
  double u[4000], x[8000];
  int64_t n = 0, i;
  int32_t pressure, place;
  CHECK_OK(vbgpd_field_find("pore_pressure", VBGPD_STRLEN, &pressure));
  CHECK_OK(vbgpd_field_find("reference_position", VBGPD_STRLEN, &place));
  CHECK_OK(vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, &n));
  CHECK(n > 100 && n < 4000);
  CHECK_OK(vbgpd_model_read_f64(model, pressure, u, 8, 8, n, &n));
  CHECK_OK(vbgpd_model_read_f64(model, place, x, 16, 8, n, &n));
  for (i = 0; i < n; ++i) CHECK(fabs(u[i] - 9810 * fmax(0, 5 - x[2 * i + 1])) < 1e-6);
  CHECK_OK(vbgpd_model_destroy(model));
}

int main(void) {
  const double low[] = {0, 5, 40, 5}, high[] = {0, 12, 10, 12, 25, 5, 40, 5};
  vbgpd_context* context = make_context();
  vbgpd_profile* profile = make_profile(context, 1.25);
  double dry, wet, ratio;
  is_read_as_it_was_set(profile);
  faults_are_told(context, profile);
  CHECK_OK(vbgpd_profile_set_water_table(profile, low, 16, 2));
  fills_the_pores(context, profile);
  CHECK_OK(vbgpd_profile_set_water_table(profile, NULL, 16, 0));
  dry = factor_of_safety(context, profile);
  CHECK_OK(vbgpd_profile_set_water_table(profile, high, 16, 4));
  wet = factor_of_safety(context, profile);
  CHECK_OK(vbgpd_profile_set_water_table(profile, NULL, 16, 0));
  set_number(profile, VBGPD_OBJECT_MATERIAL, 0, "pore_pressure_ratio", 0.3);
  ratio = factor_of_safety(context, profile);
  CHECK(wet < 0.95 * dry && ratio < 0.95 * dry);
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
