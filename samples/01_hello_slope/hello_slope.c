/* The factor of safety of a slope given by four corners, in plain C. */
#include <stdio.h>
#include <vbgpd/vbgpd.h>

/* Griffiths and Lane (1999), example 1: 10 m high, 2 to 1, c = 10 kPa, phi = 20 degrees; their answer is 1.4. */
static const double corners[][2] = {{0, 0}, {32, 0}, {12, 10}, {0, 10}};
static const struct {
  const char* name;
  double value; /* SI units */
} soil[] = {
    {"unit_weight", 20e3}, {"young_modulus", 1e8}, {"poisson_ratio", 0.3}, {"cohesion", 10e3}, {"friction_angle", 20}};

static int report(const vbgpd_context* context, const char* what) {
  char text[1000] = "no reason given";
  vbgpd_context_error(context, NULL, text, sizeof text, NULL);
  fprintf(stderr, "%s: %s\n", what, text);
  return 1;
}

int main(void) {
  vbgpd_context* context = NULL;
  vbgpd_profile* profile = NULL;
  vbgpd_model* model = NULL;
  vbgpd_job* job = NULL;
  int64_t clay = 0;
  double fs = 0, error = 0;

  if (vbgpd_context_create(NULL, &context) || vbgpd_profile_create(context, &profile)) return report(context, "engine");
  vbgpd_profile_set_exterior(profile, &corners[0][0], sizeof corners[0], 4);
  vbgpd_profile_add_material(profile, "clay", VBGPD_STRLEN, &clay);
  for (unsigned i = 0; i < sizeof soil / sizeof soil[0]; ++i)
    vbgpd_profile_set_f64(profile, VBGPD_OBJECT_MATERIAL, clay, soil[i].name, VBGPD_STRLEN, soil[i].value);
  vbgpd_profile_add_layer(profile, NULL, 0, 0, clay, NULL); /* fills the section; base fixed, rollers at the sides */
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", VBGPD_STRLEN, 0.5);

  if (vbgpd_model_create(context, profile, &model)) return report(context, "slope"); /* says all that is wrong */
  if (vbgpd_job_create_strength_reduction(model, &job)) return report(context, "job");
  const vbgpd_status status = vbgpd_job_run(job, 0, NULL, NULL, NULL);
  vbgpd_job_get_f64(job, "factor_of_safety", VBGPD_STRLEN, &fs);
  vbgpd_job_get_f64(job, "error_estimate", VBGPD_STRLEN, &error);
  printf("factor of safety %.3f, error estimate %.3f (%s)\n", fs, error, vbgpd_status_name(status));

  vbgpd_job_destroy(job);
  vbgpd_model_destroy(model);
  vbgpd_profile_destroy(profile);
  vbgpd_context_destroy(context);
  return status == VBGPD_OK ? 0 : 1;
}
