/* A slope of 10 m height at 45 degrees, built by calls; the tests share it. */
#ifndef VBGPD_TESTS_SLOPE_H
#define VBGPD_TESTS_SLOPE_H
#include <time.h>

#include "check.h"

/* A tenth of the processor time since then, s: for slices that a slow machine finishes too. */
static inline double a_tenth_since(clock_t start) { return 0.1 * (double)(clock() - start) / CLOCKS_PER_SEC; }

static const double slope_exterior[] = {0, 0, 40, 0, 40, 5, 25, 5, 15, 15, 0, 15};

static inline vbgpd_context* make_context(void) {
  vbgpd_context* context = NULL;
  CHECK_OK(vbgpd_context_create(NULL, &context));
  return context;
}

static inline void set_number(vbgpd_profile* profile, int32_t kind, int64_t id, const char* name, double value) {
  CHECK_OK(vbgpd_profile_set_f64(profile, kind, id, name, VBGPD_STRLEN, value));
}

static inline vbgpd_profile* make_profile(vbgpd_context* context, double spacing) {
  vbgpd_profile* profile = NULL;
  int64_t soil = -1, layer = -1;
  CHECK_OK(vbgpd_profile_create(context, &profile));
  CHECK_OK(vbgpd_profile_set_exterior(profile, slope_exterior, 16, 6));
  CHECK_OK(vbgpd_profile_add_material(profile, "soil", VBGPD_STRLEN, &soil));
  set_number(profile, VBGPD_OBJECT_MATERIAL, soil, "unit_weight", 20e3);
  set_number(profile, VBGPD_OBJECT_MATERIAL, soil, "cohesion", 12e3);
  set_number(profile, VBGPD_OBJECT_MATERIAL, soil, "friction_angle", 20);
  CHECK_OK(vbgpd_profile_add_layer(profile, NULL, 16, 0, soil, &layer));
  set_number(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", spacing);
  CHECK(soil == 0 && layer == 0);
  return profile;
}

static inline vbgpd_model* make_model(vbgpd_context* context, double spacing) {
  vbgpd_profile* profile = make_profile(context, spacing);
  vbgpd_model* model = NULL;
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  CHECK_OK(vbgpd_profile_destroy(profile));
  return model;
}

static inline double model_number(const vbgpd_model* model, const char* name) {
  double value = -1;
  CHECK_OK(vbgpd_model_get_f64(model, name, VBGPD_STRLEN, &value));
  return value;
}

static inline double job_number(const vbgpd_job* job, const char* name) {
  double value = -1;
  CHECK_OK(vbgpd_job_get_f64(job, name, VBGPD_STRLEN, &value));
  return value;
}

#endif
