/* Staged construction through the C face: a berm dug away and placed again, what is refused, what comes along. */
#include "slope.h"

/* A vertical cut of 10 m with a berm of 10 m by 4 m that holds its foot: layer 1, of the same soil. */
static vbgpd_profile* make_stages(vbgpd_context* context, int with_berm) {
  static const double all[] = {0, 0, 40, 0, 40, 6, 20, 6, 20, 10, 10, 10, 10, 16, 0, 16};
  static const double dug[] = {0, 0, 40, 0, 40, 6, 10, 6, 10, 16, 0, 16};
  static const double berm[] = {10, 6, 20, 6, 20, 10, 10, 10};
  vbgpd_profile* profile = make_profile(context, 1);
  CHECK_OK(vbgpd_profile_set_exterior(profile, with_berm ? all : dug, 16, with_berm ? 8 : 6));
  set_number(profile, VBGPD_OBJECT_MATERIAL, 0, "cohesion", 50e3);
  if (with_berm) CHECK_OK(vbgpd_profile_add_layer(profile, berm, 16, 4, 0, NULL));
  return profile;
}

static vbgpd_model* model_of(vbgpd_context* context, vbgpd_profile* profile) {
  vbgpd_model* model = NULL;
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  CHECK_OK(vbgpd_profile_destroy(profile));
  return model;
}

static uint64_t hash_of(const vbgpd_model* model) {
  uint64_t hash = 0;
  CHECK_OK(vbgpd_model_state_hash(model, &hash));
  return hash;
}

static double factor_of_safety(vbgpd_model* model) {
  vbgpd_job* job = NULL;
  double factor;
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  factor = job_number(job, "factor_of_safety");
  CHECK_OK(vbgpd_job_destroy(job));
  return factor;
}

/* Soil that was taken away has no particle in a run-out; the others are numbered without it. */
static void selects_what_runs_out(const vbgpd_model* flow) {
  vbgpd_selection layer;
  int64_t n = 0, all = 0, i, *ids;
  memset(&layer, 0, sizeof layer);
  layer.struct_size = sizeof layer, layer.kind = VBGPD_SELECT_LAYER, layer.object_id = 1;
  CHECK_OK(vbgpd_model_select(flow, &layer, NULL, 8, 0, &n));
  CHECK(n == 0);
  layer.object_id = 0;
  CHECK_OK(vbgpd_model_item_count(flow, VBGPD_AT_PARTICLE, &all));
  ids = (int64_t*)calloc((size_t)all, sizeof *ids);
  CHECK_OK(vbgpd_model_select(flow, &layer, ids, 8, all, &n));
  CHECK(n == all);
  for (i = 0; i < n; ++i) CHECK(ids[i] == i);
  free(ids);
}

static void refused(vbgpd_context* context) {
  vbgpd_model *model = model_of(context, make_stages(context, 1)), *flow = NULL;
  const uint64_t before = hash_of(model);
  vbgpd_error_info info;
  vbgpd_view view;
  char text[300];
  int32_t field;
  info.struct_size = sizeof info, view.struct_size = sizeof view;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_set_layer_active(model, 2, 0));
  CHECK_OK(vbgpd_model_error(model, &info, text, sizeof text, NULL));
  CHECK(info.argument == 2);
  CHECK_CONTAINS(text, "no layer 2");
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_set_layer_active(model, -1, 0));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_set_layer_active(model, 1, 2));
  CHECK_OK(vbgpd_model_error(model, &info, text, sizeof text, NULL));
  CHECK(info.argument == 3);
  CHECK_OK(vbgpd_field_find("displacement", VBGPD_STRLEN, &field));
  CHECK_OK(vbgpd_model_view_acquire(model, field, &view));
  CHECK_STATUS(VBGPD_E_LEASED, vbgpd_model_set_layer_active(model, 1, 0));
  CHECK_OK(vbgpd_model_view_release(model, view.lease));
  CHECK(hash_of(model) == before);
  CHECK_OK(vbgpd_model_set_layer_active(model, 1, 0));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_set_layer_active(model, 0, 0));
  CHECK_OK(vbgpd_model_error(model, &info, text, sizeof text, NULL));
  CHECK(info.object_kind == VBGPD_OBJECT_LAYER && info.object_id == 0);
  CHECK_CONTAINS(text, "no soil would be left");
  CHECK_OK(vbgpd_model_create_runout(model, &flow)); /* of the soil that is there */
  CHECK(model_number(flow, "particles") < model_number(model, "particles"));
  CHECK(fabs(model_number(flow, "total_mass") - model_number(model, "total_mass")) < 1e-9 * model_number(model, "total_mass"));
  CHECK_STATUS(VBGPD_E_UNSUPPORTED, vbgpd_model_set_layer_active(flow, 1, 1));
  selects_what_runs_out(flow);
  CHECK_OK(vbgpd_model_destroy(flow));
  CHECK_OK(vbgpd_model_set_layer_active(model, 1, 1));
  CHECK(hash_of(model) == before);
  CHECK_OK(vbgpd_model_destroy(model));
}

/* Ids stay, the selection of the layer is what goes, and it reads 0. */
static void what_goes_is_the_layer(vbgpd_context* context) {
  vbgpd_model* model = model_of(context, make_stages(context, 1));
  const double mass = model_number(model, "total_mass");
  vbgpd_selection berm;
  int64_t n = 0, all = 0, still = 0, i, *active, off = 0;
  int32_t field;
  memset(&berm, 0, sizeof berm);
  berm.struct_size = sizeof berm, berm.kind = VBGPD_SELECT_LAYER, berm.object_id = 1;
  CHECK_OK(vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, &all));
  CHECK_OK(vbgpd_model_step(model, 50, NULL));
  CHECK_OK(vbgpd_model_set_layer_active(model, 1, 0));
  CHECK_OK(vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, &still));
  CHECK(still == all);
  CHECK(fabs(mass - model_number(model, "total_mass") - 10 * 4 * 20e3 / 9.81) < 1e-9 * mass);
  CHECK_OK(vbgpd_model_select(model, &berm, NULL, 8, 0, &n));
  CHECK(n == 40);
  active = (int64_t*)calloc((size_t)all, sizeof *active);
  CHECK_OK(vbgpd_field_find("active", VBGPD_STRLEN, &field));
  CHECK_OK(vbgpd_model_read_selected_i64(model, field, &berm, active, 0, 0, n, NULL));
  for (i = 0; i < n; ++i) CHECK(active[i] == 0);
  CHECK_OK(vbgpd_model_read_i64(model, field, active, 0, 0, all, NULL));
  for (i = 0; i < all; ++i) off += active[i] == 0;
  CHECK(off == n);
  free(active);
  CHECK_OK(vbgpd_model_destroy(model));
}

/* Checkpoints and jobs take the layers along; a berm holds the toe. */
static void comes_along(vbgpd_context* context) {
  vbgpd_model *dug = model_of(context, make_stages(context, 1)), *drawn = model_of(context, make_stages(context, 0)),
              *whole = model_of(context, make_stages(context, 1)), *other = NULL;
  double factor;
  unsigned char* bytes;
  int64_t size = 0;
  CHECK_OK(vbgpd_model_set_layer_active(dug, 1, 0));
#if WITH_FLATBUFFERS
  CHECK_OK(vbgpd_model_checkpoint(dug, NULL, 0, &size));
  bytes = (unsigned char*)malloc((size_t)size);
  CHECK_OK(vbgpd_model_checkpoint(dug, bytes, size, &size));
  CHECK_OK(vbgpd_model_create_from_checkpoint(context, bytes, size, &other));
  CHECK(hash_of(other) == hash_of(dug));
  CHECK_OK(vbgpd_model_step(other, 30, NULL));
  CHECK_OK(vbgpd_model_set_layer_active(other, 1, 1)); /* on a section that has moved */
  free(bytes);
  CHECK_OK(vbgpd_model_checkpoint(other, NULL, 0, &size));
  bytes = (unsigned char*)malloc((size_t)size);
  CHECK_OK(vbgpd_model_checkpoint(other, bytes, size, &size));
  CHECK_OK(vbgpd_model_step(other, 30, NULL));
  {
    const uint64_t later = hash_of(other);
    CHECK_OK(vbgpd_model_restore_checkpoint(other, bytes, size));
    CHECK_OK(vbgpd_model_step(other, 30, NULL));
    CHECK(hash_of(other) == later);
  }
  free(bytes);
  CHECK_OK(vbgpd_model_destroy(other));
#else
  (void)other, (void)bytes, (void)size;
#endif
  factor = factor_of_safety(drawn);
  CHECK(fabs(factor_of_safety(dug) - factor) < 1e-12 && factor_of_safety(whole) > 1.1 * factor);
  CHECK_OK(vbgpd_model_destroy(whole));
  CHECK_OK(vbgpd_model_destroy(dug));
  CHECK_OK(vbgpd_model_destroy(drawn));
}

int main(void) {
  vbgpd_context* context = make_context();
  refused(context);
  what_goes_is_the_layer(context);
  comes_along(context);
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
