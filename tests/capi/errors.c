/* Errors stay on the object and say which object, which vertex, which coordinates, which value. */
#include "slope.h"

static char text[4000];

static vbgpd_error_info profile_error(const vbgpd_profile* p) {
  vbgpd_error_info info;
  info.struct_size = sizeof info;
  CHECK_OK(vbgpd_profile_error(p, &info, text, sizeof text, NULL));
  CHECK(text[0] != 0);
  return info;
}

/* The issue about that kind of object that names the vertex or, with item -1, none. */
static vbgpd_error_info find_issue(const vbgpd_profile* p, int32_t kind, int64_t id, int64_t item) {
  vbgpd_error_info info;
  int64_t i;
  info.struct_size = sizeof info;
  for (i = 0; vbgpd_profile_issue(p, i, &info, text, sizeof text, NULL) == VBGPD_OK; ++i) {
    if (info.object_kind == kind && info.object_id == id && info.item == item) return info;
  }
  fprintf(stderr, "no issue about kind %d, id %d, item %d\n", (int)kind, (int)id, (int)item);
  exit(1);
}

static void nothing_yet(const vbgpd_profile* p) {
  vbgpd_error_info info;
  info.struct_size = sizeof info;
  CHECK_STATUS(VBGPD_END_OF_DATA, vbgpd_profile_error(p, &info, text, sizeof text, NULL));
  CHECK_STATUS(VBGPD_END_OF_DATA, vbgpd_profile_issue(p, 0, &info, text, sizeof text, NULL));
}

/* Failed calls change nothing, are kept until the next failure and are not disturbed by being read. */
static void records(vbgpd_profile* p) {
  vbgpd_error_info info;
  int64_t n = -1, needed = -1;
  double value = 0;
  char small[4] = "###";
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_add_layer(p, NULL, 16, 0, 7, &n));
  CHECK(n == -1);
  info = profile_error(p);
  CHECK(info.status == VBGPD_E_ARGUMENT && info.argument == 5);
  CHECK(info.object_kind == VBGPD_OBJECT_MATERIAL && info.object_id == 7);
  CHECK(isnan(info.x) && isnan(info.y) && isnan(info.value) && info.item == -1);
  CHECK_CONTAINS(text, "no material 7");
  CHECK_OK(vbgpd_profile_count(p, VBGPD_OBJECT_LAYER, &n)); /* a success leaves the record alone */
  CHECK(n == 1);
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_profile_error(p, NULL, small, sizeof small, &needed));
  CHECK(strcmp(small, "###") == 0 && needed > 4);
  CHECK_OK(vbgpd_profile_error(p, NULL, NULL, 0, NULL));
  CHECK(profile_error(p).status == VBGPD_E_ARGUMENT);
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME,
               vbgpd_profile_get_f64(p, VBGPD_OBJECT_MATERIAL, 0, "cohesoin", VBGPD_STRLEN, &value));
  info = profile_error(p);
  CHECK(info.status == VBGPD_E_UNKNOWN_NAME && info.argument == 4);
  CHECK_CONTAINS(text, "\"cohesoin\"");
  CHECK_CONTAINS(text, "\"cohesion\"");
}

static void wrong_arguments(vbgpd_profile* p) {
  double xy[6] = {0, 0, 1, 0, 1, 1};
  int64_t id = -1, n = 0;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_set_exterior(p, NULL, 16, 3));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_set_exterior(p, xy, 16, -3));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_set_exterior(p, xy, 15, 3));
  CHECK(profile_error(p).argument == 3);
  CHECK_STATUS(VBGPD_E_MEMORY, vbgpd_profile_set_exterior(p, xy, 16, INT64_MAX));
  CHECK_OK(vbgpd_profile_polygon(p, VBGPD_OBJECT_PROFILE, 0, NULL, 0, 0, &n));
  CHECK(n == 6); /* the old exterior is still there */
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_add_boundary(p, NULL, 0, NULL, 16, 0, VBGPD_BOUNDARY_FIXED, &id));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_add_boundary(p, "base", 4, xy, 16, 3, VBGPD_BOUNDARY_FIXED, &id));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_add_boundary(p, "base", 4, NULL, 16, 0, 17, &id));
  CHECK(profile_error(p).argument == 7);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_count(p, VBGPD_OBJECT_JOB, &n));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_issue(p, -1, NULL, NULL, 0, NULL));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_add_material(p, "", 0, &id));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_add_material(p, "soil", VBGPD_STRLEN, &id));
  CHECK_CONTAINS((profile_error(p), text), "already named \"soil\"");
  CHECK(id == -1);
  CHECK_OK(vbgpd_profile_count(p, VBGPD_OBJECT_BOUNDARY, &n));
  CHECK(n == 0);
}

/* A bow tie: edges 1 (from (10,10)) and 3 (from (10,0)) cross at (5,5). */
static void crossing_exterior(vbgpd_context* context) {
  static const double bow_tie[] = {0, 0, 10, 10, 10, 0, 0, 10};
  vbgpd_profile* p = make_profile(context, 1);
  vbgpd_model* model = NULL;
  vbgpd_error_info info;
  int64_t errors = 0, i, at = -1;
  CHECK_OK(vbgpd_profile_set_exterior(p, bow_tie, 16, 4));
  CHECK_OK(vbgpd_profile_validate(p, &errors, NULL));
  CHECK(errors > 0);
  info.struct_size = sizeof info;
  for (i = 0; vbgpd_profile_issue(p, i, &info, text, sizeof text, NULL) == VBGPD_OK; ++i) {
    if (info.status == VBGPD_E_GEOMETRY && fabs(info.x - 5) < 1e-9 && fabs(info.y - 5) < 1e-9) at = i;
  }
  CHECK(at >= 0);
  CHECK_OK(vbgpd_profile_issue(p, at, &info, text, sizeof text, NULL));
  CHECK(info.object_kind == VBGPD_OBJECT_PROFILE && info.item >= 0 && info.item < 4);
  CHECK_STATUS(VBGPD_E_GEOMETRY, vbgpd_model_create(context, p, &model));
  CHECK(model == NULL);
  info.struct_size = sizeof info;
  CHECK_OK(vbgpd_context_error(context, &info, text, sizeof text, NULL));
  CHECK(info.status == VBGPD_E_GEOMETRY && info.argument == 2);
  CHECK_OK(vbgpd_profile_destroy(p));
}

/* Several faults at once: all are issues, all are in the text of the failed model_create. */
static void many_faults(vbgpd_context* context) {
  static const double with_hole[] = {0, 0, 40, 0, 40, NAN, 25, 5, 15, 15, 0, 15};
  vbgpd_profile* p = make_profile(context, 1);
  vbgpd_model* model = NULL;
  vbgpd_error_info info;
  int64_t errors = 0, warnings = 0, i = 0;
  CHECK_OK(vbgpd_profile_set_exterior(p, with_hole, 16, 6));
  set_number(p, VBGPD_OBJECT_MATERIAL, 0, "friction_angle", 95);
  set_number(p, VBGPD_OBJECT_MATERIAL, 0, "unit_weight", 20); /* kN/m3 taken for N/m3: a warning */
  CHECK_OK(vbgpd_profile_validate(p, &errors, &warnings));
  CHECK(errors >= 2 && warnings >= 1);
  info = find_issue(p, VBGPD_OBJECT_PROFILE, -1, 2);
  CHECK(info.x == 40 && isnan(info.y) && info.status == VBGPD_E_RANGE);
  info = find_issue(p, VBGPD_OBJECT_MATERIAL, 0, -1);
  CHECK(info.value == 95);
  CHECK_CONTAINS(text, "friction_angle");
  for (i = 0; vbgpd_profile_issue(p, i, &info, NULL, 0, NULL) == VBGPD_OK; ++i) {
    errors -= info.status != VBGPD_OK;
    warnings -= info.status == VBGPD_OK;
  }
  CHECK(errors == 0 && warnings == 0);
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_create(context, p, &model));
  CHECK_OK(vbgpd_context_error(context, &info, text, sizeof text, NULL));
  CHECK(info.object_kind == VBGPD_OBJECT_PROFILE && info.item == 2 && info.x == 40);
  CHECK_CONTAINS(text, "friction_angle");
  CHECK_CONTAINS(text, "exterior");
  CHECK_OK(vbgpd_profile_destroy(p));
}

static void models_and_jobs(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 2.5);
  vbgpd_job* job = NULL;
  vbgpd_error_info info;
  double value = -3;
  info.struct_size = sizeof info;
  CHECK_STATUS(VBGPD_END_OF_DATA, vbgpd_model_error(model, &info, NULL, 0, NULL));
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_model_get_f64(model, "tiem", VBGPD_STRLEN, &value));
  CHECK(value == -3);
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_set_f64(model, "damping", VBGPD_STRLEN, 1.5));
  CHECK_OK(vbgpd_model_error(model, &info, text, sizeof text, NULL));
  CHECK(info.status == VBGPD_E_RANGE);
  CHECK_CONTAINS(text, "damping");
  CHECK(model_number(model, "damping") == 0);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_step(model, -1, NULL));
  CHECK_OK(vbgpd_job_create_equilibrium(model, &job));
  CHECK_STATUS(VBGPD_END_OF_DATA, vbgpd_job_error(job, NULL, NULL, 0, NULL));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_job_run(job, NAN, NULL, NULL, NULL));
  CHECK_STATUS(VBGPD_E_UNKNOWN_NAME, vbgpd_job_get_text(job, "stauts", VBGPD_STRLEN, NULL, 0, NULL));
  CHECK_OK(vbgpd_job_error(job, &info, text, sizeof text, NULL));
  CHECK(info.status == VBGPD_E_UNKNOWN_NAME && info.argument == 2);
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
}

static void bytes_that_are_no_scene(vbgpd_context* context) {
  static const unsigned char noise[64] = {16, 0, 0, 0, 'V', 'B', 'G', 'P', 255, 255, 255, 127};
  vbgpd_profile* p = NULL;
  vbgpd_error_info info;
  CHECK_STATUS(STATUS_OF_NOISE, vbgpd_profile_create_from_flatbuffer(context, noise, sizeof noise, &p));
  CHECK_STATUS(STATUS_OF_NOISE, vbgpd_profile_create_from_flatbuffer(context, noise, 0, &p));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_create_from_flatbuffer(context, noise, -1, &p));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_create_from_flatbuffer(context, NULL, 9, &p));
  CHECK(p == NULL);
  info.struct_size = sizeof info;
  CHECK_OK(vbgpd_context_error(context, &info, NULL, 0, NULL));
  CHECK(info.argument == 2);
}

int main(void) {
  vbgpd_context* context = make_context();
  vbgpd_profile* profile = make_profile(context, 1);
  nothing_yet(profile);
  records(profile);
  wrong_arguments(profile);
  CHECK_OK(vbgpd_profile_destroy(profile));
  crossing_exterior(context);
  many_faults(context);
  models_and_jobs(context);
  bytes_that_are_no_scene(context);
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
