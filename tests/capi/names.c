/* Named numbers and texts: every property of the tables can be set, read and taken back; layers follow their material.
 */
#include "slope.h"

static void table_is_sound(int32_t kind, int64_t least) {
  vbgpd_property_info info, other;
  int64_t n = -1, i, k;
  CHECK_OK(vbgpd_property_count(kind, &n));
  CHECK(n >= least);
  info.struct_size = other.struct_size = sizeof info;
  for (i = 0; i < n; ++i) {
    CHECK_OK(vbgpd_property_info_at(kind, i, &info));
    CHECK(info.name[0] != 0 && info.unit[0] != 0 && info.doc[0] != 0);
    CHECK(info.min_value < info.max_value);
    CHECK(isnan(info.default_value) || (info.default_value >= info.min_value && info.default_value <= info.max_value));
    CHECK(!info.required || isnan(info.default_value));
    for (k = 0; k < i; ++k) {
      CHECK_OK(vbgpd_property_info_at(kind, k, &other));
      CHECK(strcmp(info.name, other.name) != 0);
    }
  }
  CHECK_STATUS(VBGPD_END_OF_DATA, vbgpd_property_info_at(kind, n, &info));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_property_info_at(kind, -1, &info));
}

static void set_get_forget(vbgpd_profile* p, int32_t kind) {
  vbgpd_property_info info;
  int64_t i;
  double value;
  info.struct_size = sizeof info;
  for (i = 0; vbgpd_property_info_at(kind, i, &info) == VBGPD_OK; ++i) {
    CHECK_OK(vbgpd_profile_set_f64(p, kind, 0, info.name, VBGPD_STRLEN, 0.25 + (double)i));
    CHECK_OK(vbgpd_profile_get_f64(p, kind, 0, info.name, (int64_t)strlen(info.name), &value));
    CHECK(value == 0.25 + (double)i);
    CHECK_OK(vbgpd_profile_set_f64(p, kind, 0, info.name, VBGPD_STRLEN, NAN));
    CHECK_OK(vbgpd_profile_get_f64(p, kind, 0, info.name, VBGPD_STRLEN, &value));
    CHECK(isnan(info.default_value) ? isnan(value) : value == info.default_value);
  }
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_set_f64(p, kind, kind == VBGPD_OBJECT_PROFILE ? 0 : 99, NULL, 3, 1));
}

static const char* text_of(const vbgpd_profile* p, int32_t kind, int64_t id, const char* name) {
  static char text[64];
  CHECK_OK(vbgpd_profile_get_text(p, kind, id, name, VBGPD_STRLEN, text, sizeof text, NULL));
  return text;
}

static void texts(vbgpd_profile* p) {
  static const struct {
    int32_t kind;
    const char *name, *value;
  } all[] = {{VBGPD_OBJECT_PROFILE, "name", "a"},       {VBGPD_OBJECT_PROFILE, "source", "b"},
             {VBGPD_OBJECT_PROFILE, "bond", "none"},    {VBGPD_OBJECT_PROFILE, "kernel", "cubic_spline"},
             {VBGPD_OBJECT_MATERIAL, "law", "elastic"}, {VBGPD_OBJECT_BOUNDARY, "name", "rock"},
             {VBGPD_OBJECT_BOUNDARY, "side", "left"},   {VBGPD_OBJECT_BOUNDARY, "kind", "roller"}};
  size_t i;
  for (i = 0; i < sizeof all / sizeof all[0]; ++i) {
    CHECK_OK(vbgpd_profile_set_text(p, all[i].kind, 0, all[i].name, VBGPD_STRLEN, all[i].value, VBGPD_STRLEN));
    CHECK(strcmp(text_of(p, all[i].kind, 0, all[i].name), all[i].value) == 0);
  }
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_profile_set_text(p, VBGPD_OBJECT_LOAD, 0, "name", 4, "x", 1));
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_profile_set_text(p, VBGPD_OBJECT_BOUNDARY, 0, "kind", 4, "rollr", 5));
  CHECK(strcmp(text_of(p, VBGPD_OBJECT_BOUNDARY, 0, "kind"), "roller") == 0);
}

static void layers_follow_their_material(vbgpd_profile* p) {
  int64_t clay = -1, layer = -1;
  CHECK_OK(vbgpd_profile_add_material(p, "clay", VBGPD_STRLEN, &clay));
  CHECK_OK(vbgpd_profile_add_layer(p, slope_exterior, 16, 6, clay, &layer));
  CHECK(clay == 1 && layer == 1);
  CHECK_OK(vbgpd_profile_set_text(p, VBGPD_OBJECT_MATERIAL, clay, "name", 4, "peat", 4));
  CHECK(strcmp(text_of(p, VBGPD_OBJECT_LAYER, layer, "material"), "peat") == 0);
  CHECK(strcmp(text_of(p, VBGPD_OBJECT_LAYER, 0, "material"), "soil") == 0);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_set_text(p, VBGPD_OBJECT_MATERIAL, clay, "name", 4, "soil", 4));
  CHECK(strcmp(text_of(p, VBGPD_OBJECT_MATERIAL, clay, "name"), "peat") == 0);
}

static void jobs_and_models(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 2.5);
  vbgpd_job* job = NULL;
  vbgpd_property_info info;
  int64_t i;
  info.struct_size = sizeof info;
  for (i = 0; vbgpd_property_info_at(VBGPD_OBJECT_MODEL, i, &info) == VBGPD_OK; ++i) {
    CHECK(model_number(model, info.name) == info.default_value);
    CHECK_OK(vbgpd_model_set_f64(model, info.name, VBGPD_STRLEN, info.default_value));
  }
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "levels", VBGPD_STRLEN, 1));
  CHECK(job_number(job, "levels") == 1);
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_job_set_f64(job, "levels", VBGPD_STRLEN, 9));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_job_set_f64(job, "levels", VBGPD_STRLEN, 2.5));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_job_set_f64(job, "target_error", VBGPD_STRLEN, 1.5));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_job_set_f64(job, "budget", VBGPD_STRLEN, -1));
  CHECK_OK(vbgpd_job_set_f64(job, "budget", VBGPD_STRLEN, 60));
  CHECK(job_number(job, "budget") == 60 && job_number(job, "target_error") == 0);
  CHECK(vbgpd_job_run(job, 1e-6, NULL, NULL, NULL) >= 0);
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_job_set_f64(job, "levels", VBGPD_STRLEN, 2));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
}

/* A text that says which names there are; behind "it has", each is asked for. */
static const char* told_of(const vbgpd_model* model, const vbgpd_job* job, const char* part) {
  static char text[4000];
  if (job != NULL) CHECK_OK(vbgpd_job_error(job, NULL, text, sizeof text, NULL));
  else CHECK_OK(vbgpd_model_error(model, NULL, text, sizeof text, NULL));
  CHECK_CONTAINS(text, part);
  return text;
}

static void unknown_names_are_answered_with_the_known_ones(vbgpd_context* context) {
  vbgpd_model *model = make_model(context, 2.5), *runout = NULL;
  vbgpd_job* job = NULL;
  double value;
  char *name, names[4000];
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_model_get_f64(model, "kinetic_enrgy", VBGPD_STRLEN, &value));
  told_of(model, NULL, "did you mean \"kinetic_energy\"");
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_model_set_f64(model, "dampin", VBGPD_STRLEN, 0));
  told_of(model, NULL, "a model has no number named \"dampin\": it has damping, ");
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_model_get_f64(model, "forecast_weather", VBGPD_STRLEN, &value));
  told_of(model, NULL, "it has forecast_step_seconds");
  CHECK_OK(vbgpd_model_create_runout(model, &runout));
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_model_get_f64(runout, "standing_tim", VBGPD_STRLEN, &value));
  told_of(runout, NULL, "did you mean \"standing_time\"");
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_job_set_f64(job, "srf_mn", VBGPD_STRLEN, 1));
  told_of(model, job, "A job has no option named \"srf_mn\": it has srf_min, ");
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_job_get_f64(job, "weather", VBGPD_STRLEN, &value));
  strcpy(names, strstr(told_of(model, job, "it has srf_min, "), "srf_min"));
  for (name = strtok(names, ", "); name != NULL; name = strtok(NULL, ", "))
    CHECK_OK(vbgpd_job_get_f64(job, name, VBGPD_STRLEN, &value));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(runout));
  CHECK_OK(vbgpd_model_destroy(model));
}

/* An end that is open for a profile is open for a model. */
static void seismic_coefficients_have_one_range(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 2.5);
  vbgpd_property_info info;
  int64_t i;
  int seen = 0;
  info.struct_size = sizeof info;
  for (i = 0; vbgpd_property_info_at(VBGPD_OBJECT_MODEL, i, &info) == VBGPD_OK; ++i) {
    if (info.name[0] != 'k') continue;
    ++seen;
    CHECK(info.min_open && info.max_open && info.min_value == -1 && info.max_value == 1);
    CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_set_f64(model, info.name, VBGPD_STRLEN, -1));
    told_of(model, NULL, "must be in (-1, 1)");
    CHECK_OK(vbgpd_model_set_f64(model, info.name, VBGPD_STRLEN, -0.999));
  }
  CHECK(seen == 2);
  CHECK_OK(vbgpd_model_destroy(model));
}

static void plan(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 1);
  vbgpd_feature f;
  int64_t i, left_out = 0;
  double sum = 0, seconds, step;
  f.struct_size = sizeof f;
  for (i = 0; vbgpd_model_plan(model, i, &f) == VBGPD_OK; ++i) {
    CHECK(f.name != NULL && f.doc[0] != 0 && (f.used == 0 || f.used == 1));
    CHECK(f.used || (f.bytes == 0 && f.bytes_per_particle == 0 && f.bytes_per_bond == 0));
    left_out += !f.used;
    sum += (double)f.bytes;
  }
  CHECK(left_out > 5 && i - left_out > 5);
  CHECK(sum == model_number(model, "bytes"));
  seconds = model_number(model, "forecast_seconds"), step = model_number(model, "forecast_step_seconds");
  CHECK(seconds > 0 && step > 0 && step < seconds);
  CHECK(model_number(model, "forecast_bytes") > sum);
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_model_get_f64(model, "forecast_weather", VBGPD_STRLEN, &step));
  CHECK_OK(vbgpd_model_destroy(model));
}

static void versions(void) {
  char expected[32];
  const int32_t number = vbgpd_version_number();
  CHECK(number == VBGPD_VERSION_NUMBER && vbgpd_abi_version() == VBGPD_ABI_VERSION);
  snprintf(expected, sizeof expected, "%d.%d.%d", number / 1000000, number / 1000 % 1000, number % 1000);
  CHECK(strcmp(vbgpd_version_string(), expected) == 0);
  CHECK(strcmp(vbgpd_status_name(VBGPD_E_RANGE), "VBGPD_E_RANGE") == 0);
  CHECK(strcmp(vbgpd_status_name(12345), "unknown status") == 0);
}

int main(void) {
  vbgpd_context* context = make_context();
  vbgpd_profile* profile = make_profile(context, 1);
  int64_t id = -1, n = 0;
  CHECK_OK(vbgpd_profile_add_boundary(profile, "base", 4, NULL, 16, 0, VBGPD_BOUNDARY_VELOCITY, &id));
  CHECK_OK(vbgpd_profile_add_load(profile, 0, 5, 10e3, 20e3, &id));
  table_is_sound(VBGPD_OBJECT_PROFILE, 8);
  table_is_sound(VBGPD_OBJECT_MATERIAL, 9);
  table_is_sound(VBGPD_OBJECT_LOAD, 4);
  table_is_sound(VBGPD_OBJECT_BOUNDARY, 2);
  table_is_sound(VBGPD_OBJECT_MODEL, 2);
  table_is_sound(VBGPD_OBJECT_JOB, 2);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_property_count(0, &n));
  set_get_forget(profile, VBGPD_OBJECT_PROFILE);
  set_get_forget(profile, VBGPD_OBJECT_MATERIAL);
  set_get_forget(profile, VBGPD_OBJECT_LOAD);
  set_get_forget(profile, VBGPD_OBJECT_BOUNDARY);
  texts(profile);
  layers_follow_their_material(profile);
  jobs_and_models(context);
  plan(context);
  unknown_names_are_answered_with_the_known_ones(context);
  seismic_coefficients_have_one_range(context);
  versions();
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
