/* Where the bytes of a model are, and the limit that refuses a model before it is built. */
#include "slope.h"

static vbgpd_memory memory_of(const vbgpd_model* model) {
  vbgpd_memory m;
  m.struct_size = sizeof m;
  CHECK_OK(vbgpd_model_memory(model, &m));
  CHECK(m.bytes == m.model + m.state + m.scratch + m.copies + m.outside);
  CHECK((double)m.bytes == model_number(model, "bytes"));
  return m;
}

static vbgpd_context* limited_context(int64_t max_bytes) {
  vbgpd_context_desc desc;
  vbgpd_context* made = NULL;
  CHECK_OK(vbgpd_context_desc_init(&desc, sizeof desc));
  desc.max_bytes = max_bytes;
  CHECK_OK(vbgpd_context_create(&desc, &made));
  return made;
}

/* Everything that takes memory later on. */
static void use_all(vbgpd_model* model) {
  vbgpd_job* job = NULL;
  double value;
  CHECK_OK(vbgpd_job_create_equilibrium(model, &job));
  CHECK(vbgpd_job_run(job, 0, NULL, NULL, NULL) >= 0);
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_step(model, 600, NULL));
  CHECK_OK(vbgpd_model_get_f64(model, "elastic_energy", VBGPD_STRLEN, &value));
}

static void parts_grow_with_use(void) {
  vbgpd_context* context = make_context();
  vbgpd_model* model = make_model(context, 1);
  vbgpd_state *state = NULL, *other = NULL;
  const double push[2] = {1, 0};
  const int64_t id = 3;
  vbgpd_selection one;
  int32_t force = -1;
  vbgpd_memory fresh = memory_of(model), used;
  CHECK(fresh.model > 0 && fresh.state > 0 && fresh.scratch > 0 && fresh.outside == 0 && fresh.saved == 0);
  memset(&one, 0, sizeof one);
  one.struct_size = sizeof one, one.kind = VBGPD_SELECT_IDS, one.ids = &id, one.ids_stride = 8, one.n_ids = 1;
  CHECK_OK(vbgpd_field_find("external_force", VBGPD_STRLEN, &force));
  CHECK_OK(vbgpd_model_write_f64(model, force, &one, push, 0, 0, 1));
  use_all(model);
  used = memory_of(model);
  CHECK(used.model == fresh.model && used.state == fresh.state);
  CHECK(used.scratch > fresh.scratch && used.copies >= used.state && used.outside > 0 && used.saved == 0);
  CHECK_OK(vbgpd_model_save_state(model, &state));
  CHECK(memory_of(model).saved == used.state + used.outside);
  CHECK_OK(vbgpd_model_save_state(model, &other));
  CHECK(memory_of(model).saved == 2 * (used.state + used.outside));
  CHECK_OK(vbgpd_model_save_state(model, &other)); /* in the place of the one before */
  CHECK(memory_of(model).saved == 2 * (used.state + used.outside));
  CHECK_OK(vbgpd_state_destroy(state));
  CHECK(memory_of(model).saved == used.state + used.outside && memory_of(model).bytes == used.bytes);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_memory(model, NULL));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_state_destroy(other)); /* outlives its model */
  CHECK_OK(vbgpd_context_destroy(context));
}

static void runouts_have_parts(void) {
  vbgpd_context* context = make_context();
  vbgpd_model *model = make_model(context, 2), *flow = NULL;
  vbgpd_state* state = NULL;
  CHECK_OK(vbgpd_model_create_runout(model, &flow));
  CHECK_OK(vbgpd_model_step(flow, 5, NULL));
  CHECK_OK(vbgpd_model_save_state(flow, &state));
  CHECK(memory_of(flow).saved == memory_of(flow).state && memory_of(flow).state > 0);
  CHECK_OK(vbgpd_state_destroy(state));
  CHECK(memory_of(flow).saved == 0);
  CHECK_OK(vbgpd_model_destroy(flow));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_context_destroy(context));
}

/* Refused with the bytes and a spacing; that spacing is then taken. Returns the bytes. */
static double refused(double spacing, int64_t max_bytes, double* fits) {
  vbgpd_context* context = limited_context(max_bytes);
  vbgpd_profile* slope = make_profile(context, spacing);
  vbgpd_model* model = NULL;
  vbgpd_error_info info;
  char text[500];
  const char* said;
  info.struct_size = sizeof info;
  CHECK_STATUS(VBGPD_E_LIMIT, vbgpd_model_create(context, slope, &model));
  CHECK(model == NULL);
  CHECK_OK(vbgpd_context_error(context, &info, text, sizeof text, NULL));
  CHECK(info.status == VBGPD_E_LIMIT && info.object_kind == VBGPD_OBJECT_CONTEXT && info.argument == 2);
  CHECK(info.value > (double)max_bytes);
  said = strstr(text, "a spacing of ");
  *fits = said ? strtod(said + strlen("a spacing of "), NULL) : 0;
  if (said) {
    set_number(slope, VBGPD_OBJECT_PROFILE, 0, "spacing", *fits);
    CHECK_OK(vbgpd_model_create(context, slope, &model));
    use_all(model);
    CHECK(memory_of(model).bytes <= max_bytes);
    CHECK_OK(vbgpd_model_destroy(model));
  } else {
    CHECK_CONTAINS(text, "no spacing would fit");
  }
  CHECK_OK(vbgpd_profile_destroy(slope));
  CHECK_OK(vbgpd_context_destroy(context));
  return info.value;
}

static void predictions_hold(void) {
  static const double spacings[] = {0.5, 0.25};
  vbgpd_context* free_context = make_context();
  size_t i;
  for (i = 0; i < sizeof spacings / sizeof spacings[0]; ++i) {
    vbgpd_model* model = make_model(free_context, spacings[i]);
    double fits = 0, predicted, bytes;
    use_all(model);
    bytes = (double)memory_of(model).bytes;
    predicted = refused(spacings[i], (int64_t)(bytes / 2), &fits);
    printf("spacing %g: %.0f bytes, predicted %.0f (%+.1f %%), half of it at %g m\n", spacings[i], bytes, predicted,
           100 * (predicted / bytes - 1), fits);
    CHECK(bytes <= predicted && predicted <= 1.25 * bytes && fits > spacings[i] && fits < 2 * spacings[i]);
    CHECK_OK(vbgpd_model_destroy(model));
  }
  {
    double fits = -1;
    refused(1, 10, &fits);
    CHECK(fits == 0);
  }
  CHECK_OK(vbgpd_context_destroy(free_context));
}

/* Finer grids of a job and run-outs are models, too. */
static void limits_reach_what_is_made_later(void) {
  vbgpd_context* context = limited_context(1000000);
  vbgpd_model *model = make_model(context, 2), *flow = NULL;
  vbgpd_job* job = NULL;
  char reason[1000];
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "target_error", VBGPD_STRLEN, 1e-4));
  CHECK_STATUS(VBGPD_NOT_CONVERGED, vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_job_get_text(job, "reason", VBGPD_STRLEN, reason, sizeof reason, NULL));
  CHECK_CONTAINS(reason, "1000000 allowed");
  CHECK(memory_of(model).saved == 0 || memory_of(model).saved % memory_of(model).state == 0);
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK(memory_of(model).saved == 0);
  CHECK_OK(vbgpd_model_create_runout(model, &flow));
  CHECK_OK(vbgpd_model_destroy(flow));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_context_destroy(context));
}

/* One count, walls included, whichever particles are too many; and the spacing it names fits. */
static void a_limit_of_particles_names_a_spacing_that_fits(void) {
  vbgpd_context* free_one = make_context();
  vbgpd_model* whole = make_model(free_one, 1);
  const int64_t n = (int64_t)model_number(whole, "particles");
  const int64_t limits[4] = {n - 1, n - n / 4, n / 3, n / 8};
  int k;
  for (k = 0; k < 4; ++k) {
    vbgpd_context_desc desc;
    vbgpd_context* context = NULL;
    vbgpd_profile* profile;
    vbgpd_model* model = NULL;
    vbgpd_error_info info;
    char text[400], count[80];
    const char* fits;
    CHECK_OK(vbgpd_context_desc_init(&desc, sizeof desc));
    desc.max_particles = limits[k];
    CHECK_OK(vbgpd_context_create(&desc, &context));
    profile = make_profile(context, 1);
    CHECK_STATUS(VBGPD_E_LIMIT, vbgpd_model_create(context, profile, &model));
    info.struct_size = sizeof info;
    CHECK_OK(vbgpd_context_error(context, &info, text, sizeof text, NULL));
    snprintf(count, sizeof count, "need %d particles (walls included), more than the %d", (int)n, (int)limits[k]);
    CHECK_CONTAINS(text, count);
    CHECK(info.value == (double)n);
    fits = strstr(text, "a spacing of ");
    CHECK(fits != NULL);
    set_number(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", strtod(fits + 13, NULL));
    CHECK_OK(vbgpd_model_create(context, profile, &model));
    CHECK(model_number(model, "particles") <= (double)limits[k]);
    CHECK_OK(vbgpd_model_destroy(model));
    CHECK_OK(vbgpd_profile_destroy(profile));
    CHECK_OK(vbgpd_context_destroy(context));
  }
  CHECK_OK(vbgpd_model_destroy(whole));
  CHECK_OK(vbgpd_context_destroy(free_one));
}

int main(void) {
  parts_grow_with_use();
  runouts_have_parts();
  predictions_hold();
  limits_reach_what_is_made_later();
  a_limit_of_particles_names_a_spacing_that_fits();
  return 0;
}
