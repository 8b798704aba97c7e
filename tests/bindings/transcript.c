/* The conformance transcript in C: what the other languages must print, byte by byte. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <vbgpd/vbgpd.h>

#define SIZE 4000

static const double outline[] = {0, 0, 40, 0, 40, 5, 25, 5, 15, 15, 0, 15};

static uint64_t bits(double value) {
  uint64_t b;
  memcpy(&b, &value, sizeof b);
  return b;
}

static const char* hex(double value) {
  static char texts[12][17];
  static int next = 0;
  char* text = texts[next = (next + 1) % 12];
  sprintf(text, "%016" PRIX64, bits(value));
  return text;
}

/* Rotate and exclusive or, over n words of 64 bits. */
static uint64_t checksum(const void* words, int64_t n) {
  const unsigned char* at = (const unsigned char*)words;
  uint64_t sum = 0, word;
  int64_t i;
  for (i = 0; i < n; ++i) {
    memcpy(&word, at + 8 * i, 8);
    sum = ((sum << 1) | (sum >> 63)) ^ word;
  }
  return sum;
}

static void say_info(const char* what, vbgpd_status s, const vbgpd_error_info* info, const char* text) {
  printf("%s %d: status %d kind %d id %" PRId64 " item %" PRId64 " at %s %s value %s: %s\n", what, s, info->status,
         info->object_kind, info->object_id, info->item, hex(info->x), hex(info->y), hex(info->value), text);
}

/* After a failure the text is on the object. */
typedef vbgpd_status(VBGPD_CALL* context_reader)(const vbgpd_context*, vbgpd_error_info*, char*, int64_t, int64_t*);
static void say_failure(vbgpd_status s, context_reader reader, const void* object) {
  vbgpd_error_info info = {.struct_size = sizeof info};
  char text[SIZE] = "";
  reader((const vbgpd_context*)object, &info, text, sizeof text, NULL);
  printf("argument %d of ", info.argument);
  say_info("failure", s, &info, text);
}
#define CONTEXT_FAILED(s) say_failure(s, vbgpd_context_error, context)
#define PROFILE_FAILED(s) say_failure(s, (context_reader)vbgpd_profile_error, profile)
#define MODEL_FAILED(s) say_failure(s, (context_reader)vbgpd_model_error, model)
#define JOB_FAILED(s) say_failure(s, (context_reader)vbgpd_job_error, job)

static void step_tables(void) {
  int64_t n, i;
  int32_t kind, found;
  printf("01 version %d %d %s\n", vbgpd_version_number(), vbgpd_abi_version(), vbgpd_version_string());
  {
    char text[SIZE] = "";
    vbgpd_status s = vbgpd_build_info("compiler", 8, text, sizeof text, &n);
    printf("   built %d %" PRId64 " %s\n", s, n, text);
  }
  printf("02 status %s %s %s\n", vbgpd_status_name(VBGPD_E_RANGE), vbgpd_status_name(VBGPD_NOT_CONVERGED),
         vbgpd_status_name(12345));
  for (kind = VBGPD_OBJECT_PROFILE; kind <= VBGPD_OBJECT_JOB; ++kind) {
    if (vbgpd_property_count(kind, &n) < 0) n = -1;
    printf("03 properties of kind %d: %" PRId64 "\n", kind, n);
    for (i = 0; i < n; ++i) {
      vbgpd_property_info p = {.struct_size = sizeof p};
      vbgpd_property_info_at(kind, i, &p);
      printf("   %s [%s] %d %s %s %s %d %d %s\n", p.name, p.unit, p.required, hex(p.default_value), hex(p.min_value),
             hex(p.max_value), p.min_open, p.max_open, p.doc);
    }
  }
  vbgpd_field_count(&n);
  for (i = 0; i < n; ++i) {
    vbgpd_field_info f = {.struct_size = sizeof f};
    vbgpd_field_info_at(i, &f);
    vbgpd_field_find(f.name, VBGPD_STRLEN, &found);
    printf("04 field %d %s [%s] type %d at %d of %d writable %d: %s\n", found, f.name, f.unit, f.type, f.location,
           f.components, f.writable, f.doc);
  }
}

static void step_issues(vbgpd_profile* profile) {
  vbgpd_error_info info = {.struct_size = sizeof info};
  char text[SIZE];
  int64_t errors = -1, warnings = -1, i;
  printf("validate %d", vbgpd_profile_validate(profile, &errors, &warnings));
  printf(" errors %" PRId64 " warnings %" PRId64 "\n", errors, warnings);
  for (i = 0; vbgpd_profile_issue(profile, i, &info, text, sizeof text, NULL) == VBGPD_OK; ++i)
    say_info("   issue", 0, &info, text);
}

static void step_profile(vbgpd_context* context, vbgpd_profile* profile) {
  /* The third column of the bow tie is none of the profile's business. */
  const double bow_tie[] = {0, 0, -7, 10, 10, -7, 10, 0, -7, 0, 10, -7};
  double corners[3 * 7], value = 0;
  char text[SIZE] = "***";
  int64_t needed = -1, id = -1, n = -1, i;
  vbgpd_status s = vbgpd_profile_set_text(profile, VBGPD_OBJECT_PROFILE, 0, "name", 4,
                                          "B\xC3\xB6schung \xE6\x96\x9C\xE9\x9D\xA2", 16);
  vbgpd_profile_get_text(profile, VBGPD_OBJECT_PROFILE, 0, "name", 4, text, sizeof text, &needed);
  printf("06 name %d %" PRId64 " %s\n", s, needed, text);
  s = vbgpd_profile_set_exterior(profile, bow_tie, 24, 4);
  printf("07 bow tie %d ", s);
  step_issues(profile);
  s = vbgpd_profile_set_exterior(profile, outline + 10, -16, 6);
  for (i = 0; i < 21; ++i) corners[i] = 99;
  vbgpd_profile_polygon(profile, VBGPD_OBJECT_PROFILE, 0, corners, 24, 7, &n);
  printf("08 outline backwards %d: %" PRId64 " points, checksum %016" PRIX64 "\n", s, n, checksum(corners, 21));
  s = vbgpd_profile_set_water_table(profile, outline, 16, 2);
  vbgpd_profile_water_table(profile, NULL, 16, 0, &n);
  printf("08 water table %d: %" PRId64 " points, then", s, n);
  s = vbgpd_profile_set_water_table(profile, NULL, 16, 0);
  vbgpd_profile_water_table(profile, NULL, 16, 0, &n);
  printf(" %d: %" PRId64 "\n", s, n);
  s = vbgpd_profile_add_material(profile, "soil", 4, &id);
  printf("09 material %d id %" PRId64 ", again: ", s, id);
  PROFILE_FAILED(vbgpd_profile_add_material(profile, "soil", 4, &id));
  printf("10 unknown name: ");
  PROFILE_FAILED(vbgpd_profile_set_f64(profile, VBGPD_OBJECT_MATERIAL, 0, "cohesin", 7, 1));
  strcpy(text, "untouched");
  s = vbgpd_profile_get_text(profile, VBGPD_OBJECT_MATERIAL, 0, "law", 3, text, 3, &needed);
  printf("11 small buffer %d needed %" PRId64 " %s: ", s, needed, text);
  PROFILE_FAILED(s);
  {
    vbgpd_model* model = NULL;
    printf("12 model of half a profile: ");
    CONTEXT_FAILED(vbgpd_model_create(context, profile, &model));
  }
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_MATERIAL, 0, "unit_weight", 11, 20e3);
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_MATERIAL, 0, "cohesion", 8, 12e3);
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_MATERIAL, 0, "friction_angle", 14, 20);
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", 7, 1.25);
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_PROFILE, 0, "srf_tolerance", 13, 0.05);
  vbgpd_profile_get_f64(profile, VBGPD_OBJECT_MATERIAL, 0, "young_modulus", 13, &value);
  printf("13 numbers %s", hex(value));
  vbgpd_profile_get_f64(profile, VBGPD_OBJECT_MATERIAL, 0, "tension_cutoff", 14, &value);
  printf(" %s", hex(value));
  vbgpd_profile_get_f64(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", 7, &value);
  printf(" %s\n", hex(value));
}

static void step_parts(vbgpd_profile* profile) {
  const double base[] = {0, 0, 40, 0};
  int64_t layer = -1, side = -1, line = -1, load = -1, n[4] = {-1, -1, -1, -1};
  int32_t i;
  vbgpd_status s[5];
  s[0] = vbgpd_profile_add_layer(profile, NULL, 16, 0, 0, &layer);
  s[1] = vbgpd_profile_add_boundary(profile, NULL, 0, base, 16, 2, VBGPD_BOUNDARY_FIXED, &line);
  s[2] = vbgpd_profile_add_boundary(profile, "left", 4, NULL, 16, 0, VBGPD_BOUNDARY_ROLLER, &side);
  s[3] = vbgpd_profile_add_boundary(profile, "right", 5, NULL, 16, 0, VBGPD_BOUNDARY_ROLLER, NULL);
  s[4] = vbgpd_profile_add_load(profile, 2, 8, 5e3, 5e3, &load);
  for (i = 0; i < 4; ++i) vbgpd_profile_count(profile, VBGPD_OBJECT_MATERIAL + i, &n[i]);
  printf("14 parts %d %d %d %d %d ids %" PRId64 " %" PRId64 " %" PRId64 " %" PRId64, s[0], s[1], s[2], s[3], s[4],
         layer, line, side, load);
  printf(" counts %" PRId64 " %" PRId64 " %" PRId64 " %" PRId64 " ", n[0], n[1], n[2], n[3]);
  step_issues(profile);
}

static void say_numbers(const vbgpd_model* model, const char* const* names, int n) {
  double value = 0;
  int i;
  for (i = 0; i < n; ++i) {
    vbgpd_model_get_f64(model, names[i], VBGPD_STRLEN, &value);
    printf(" %s", hex(value));
  }
}

static void say_job_numbers(const vbgpd_job* job, const char* const* names, int n) {
  double value = 0;
  int i;
  for (i = 0; i < n; ++i) {
    vbgpd_job_get_f64(job, names[i], VBGPD_STRLEN, &value);
    printf(" %s", hex(value));
  }
}

static void say_hash(const vbgpd_model* model) {
  uint64_t hash = 0;
  vbgpd_model_state_hash(model, &hash);
  printf(" hash %016" PRIX64 "\n", hash);
}

static vbgpd_status run_in_slices(vbgpd_job* job) {
  vbgpd_status s;
  do {
    s = vbgpd_job_run(job, 0.05, NULL, NULL, NULL);
  } while (s == VBGPD_LIMIT_REACHED);
  return s;
}

static void step_equilibrium(vbgpd_model* model) {
  static const char* const results[] = {"unbalanced_force_ratio", "max_displacement", "displacement_level", "steps"};
  vbgpd_job* job = NULL;
  int32_t created = vbgpd_job_create_equilibrium(model, &job);
  vbgpd_status s = run_in_slices(job);
  printf("16 equilibrium %d %d", created, s);
  say_job_numbers(job, results, 4);
  say_hash(model);
  vbgpd_job_destroy(job);
}

static void step_fields(vbgpd_model* model) {
  int64_t fields = 0, i, k, n = -1, items = -1, *whole;
  double* real;
  int32_t stress = -1, volume = -1;
  vbgpd_status s;
  vbgpd_field_count(&fields);
  for (i = 0; i < fields; ++i) {
    vbgpd_field_info f = {.struct_size = sizeof f};
    vbgpd_field_info_at(i, &f);
    vbgpd_model_item_count(model, f.location, &items);
    whole = (int64_t*)malloc((size_t)(items * f.components) * 8);
    real = (double*)malloc((size_t)(items * f.components) * 8);
    if (f.type == VBGPD_TYPE_I64) s = vbgpd_model_read_i64(model, (int32_t)i, whole, 0, 0, items, &n);
    else s = vbgpd_model_read_f64(model, (int32_t)i, real, 0, 0, items, &n);
    printf("17 %s %d %" PRId64 " %016" PRIX64 "\n", f.name, s, n,
           checksum(f.type == VBGPD_TYPE_I64 ? (void*)whole : (void*)real, items * f.components));
    free(whole);
    free(real);
  }
  /* Every second row of six columns, stress in columns 1 to 4 backwards; the rest keeps its 7. */
  vbgpd_field_find("stress", 6, &stress);
  vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, &items);
  real = (double*)malloc((size_t)(items * 12) * 8);
  for (k = 0; k < items * 12; ++k) real[k] = 7;
  s = vbgpd_model_read_f64(model, stress, real + 4, 96, -8, items, &n);
  printf("18 strided stress %d %" PRId64 " %016" PRIX64 "\n", s, n, checksum(real, items * 12));
  free(real);
  vbgpd_field_find("volume", 6, &volume);
  whole = (int64_t*)malloc((size_t)items * 8);
  printf("19 whole numbers of a real field: ");
  MODEL_FAILED(vbgpd_model_read_i64(model, volume, whole, 0, 0, items, NULL));
  free(whole);
}

static void step_dynamics(vbgpd_model* model) {
  vbgpd_advance_result r = {.struct_size = sizeof r};
  vbgpd_status s;
  vbgpd_model_set_f64(model, "damping", 7, 0.25);
  s = vbgpd_model_step(model, 5, &r);
  printf("20 steps %d %" PRId64 " %s %s %s %s %s %s %" PRId64, s, r.steps, hex(r.time), hex(r.time_step),
         hex(r.kinetic_energy), hex(r.unbalanced_force_ratio), hex(r.max_displacement), hex(r.max_velocity),
         r.plastic_bonds);
  say_hash(model);
  s = vbgpd_model_cancel(model);
  printf("21 cancelled %d %d ", s, vbgpd_model_step(model, 5, &r));
  printf("%" PRId64 ", minus one step: ", r.steps);
  MODEL_FAILED(vbgpd_model_step(model, -1, NULL));
}

static void step_plan(vbgpd_model* model) {
  vbgpd_feature f = {.struct_size = sizeof f};
  for (int64_t i = 0; vbgpd_model_plan(model, i, &f) == VBGPD_OK; ++i) {
    printf("21 %d %s %" PRId64 " %s %s\n", f.used, f.name, f.bytes, hex(f.bytes_per_particle), hex(f.bytes_per_bond));
  }
}

static int32_t VBGPD_CALL stop_at_once(void* user, const vbgpd_progress* p) {
  *(int*)user += p->fraction >= 0 && p->fraction <= 1;
  return 1;
}

/* So fine a grid takes far longer than the tenth of a second after which the function is called. */
static void step_progress(vbgpd_context* context, vbgpd_profile* profile) {
  vbgpd_model* model = NULL;
  vbgpd_job* job = NULL;
  int calls = 0;
  vbgpd_status s;
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", 7, 0.25);
  vbgpd_model_create(context, profile, &model);
  vbgpd_job_create_strength_reduction(model, &job);
  s = vbgpd_job_run(job, 0, stop_at_once, &calls, NULL);
  printf("27 stopped by the progress function %d after %d, ", s, calls);
  vbgpd_job_cancel(job);
  printf("cancelled %d\n", vbgpd_job_run(job, 0, NULL, NULL, NULL));
  vbgpd_model_destroy(model);
  vbgpd_job_destroy(job);
}

static void step_strength_reduction(vbgpd_model* model, vbgpd_job* job) {
  static const char* const results[] = {"factor_of_safety", "srf_stable", "srf_unstable", "displacement_level",
                                        "sliding_area",     "levels",     "trials",       "steps",
                                        "particles",        "bonds"};
  static const char* const texts[] = {"status", "reason", "scheme", "reduced", "flow_rule"};
  char text[SIZE];
  double xy[2 * SIZE];
  int64_t i, n = -1;
  vbgpd_status s, set = vbgpd_job_set_f64(job, "levels", 6, 1);
  printf("22 option %d, unknown: ", set);
  JOB_FAILED(vbgpd_job_set_f64(job, "level", 5, 1));
  s = run_in_slices(job);
  printf("23 strength reduction %d", s);
  say_job_numbers(job, results, 10);
  say_hash(model);
  for (i = 0; i < 5; ++i) {
    vbgpd_job_get_text(job, texts[i], VBGPD_STRLEN, text, sizeof text, NULL);
    printf("   %s: %s\n", texts[i], text);
  }
  for (i = 0;; ++i) {
    vbgpd_trial t = {.struct_size = sizeof t};
    s = vbgpd_job_trial(job, i, &t);
    if (s != VBGPD_OK) break;
    printf("24 trial %d %d %d %s %s %s %s %s %s %" PRId64 "\n", t.level, t.verdict, t.band_connected,
           hex(t.strength_reduction_factor), hex(t.unbalanced_force_ratio), hex(t.unbalanced_force_slope),
           hex(t.displacement_level), hex(t.displacement_growth), hex(t.power_ratio), t.steps);
  }
  printf("   then %d\n", s);
  for (i = 0;; ++i) {
    vbgpd_level l = {.struct_size = sizeof l};
    s = vbgpd_job_level(job, i, &l);
    if (s != VBGPD_OK) break;
    printf("25 level %s %s %" PRId64 " %" PRId64 " %" PRId64 " %" PRId64 " %s %s %s\n", hex(l.spacing_x),
           hex(l.spacing_y), l.particles, l.bonds, l.steps, l.trials, hex(l.srf_stable), hex(l.srf_unstable),
           hex(l.factor_of_safety));
  }
  printf("   then %d\n", s);
  s = vbgpd_job_slip_surface(job, xy, 16, SIZE, &n);
  printf("26 slip surface %d %" PRId64 " %016" PRIX64 "\n", s, n, checksum(xy, 2 * n));
}

static int32_t field_of(const char* name) {
  int32_t field = -1;
  vbgpd_field_find(name, VBGPD_STRLEN, &field);
  return field;
}

static void say_advance(const char* what, vbgpd_model* model, double time) {
  vbgpd_advance_result r = {.struct_size = sizeof r};
  vbgpd_status s = vbgpd_model_advance_to(model, time, 0, NULL, NULL, &r);
  printf("%s %d %" PRId64 " %s %s", what, s, r.steps, hex(r.time), hex(r.time_step));
  say_hash(model);
}

static void step_states(vbgpd_model* model) {
  /* 2 columns of 3 values, the water table at the level of the toe */
  const double water[] = {50e3, 50e3, 0, 0, -50e3, -50e3};
  vbgpd_state* state = NULL;
  int32_t pore = field_of("pore_pressure");
  int64_t epoch = -1;
  say_advance("28 advanced", model, 0.03125);
  printf("29 saved %d", vbgpd_model_save_state(model, &state));
  printf(" again %d, ", vbgpd_model_save_state(model, &state));
  printf("water %d\n", vbgpd_model_write_grid(model, pore, 0, 0, 40, 5, 2, 3, water, 0));
  say_advance("   with water", model, 0.0625);
  printf("   back %d", vbgpd_model_restore_state(model, state));
  say_hash(model);
  say_advance("   without", model, 0.0625);
  vbgpd_model_epoch(model, &epoch);
  printf("   epoch %" PRId64 ", destroyed %d, backwards: ", epoch, vbgpd_state_destroy(state));
  MODEL_FAILED(vbgpd_model_advance_to(model, 0, 0, NULL, NULL, NULL));
}

static void step_selections(vbgpd_model* model) {
  const double corners[] = {10, 2, 30, 2, 30, 8, 10, 8};
  vbgpd_selection soil = {.struct_size = sizeof soil, .kind = VBGPD_SELECT_SOIL};
  vbgpd_selection part = {
      .struct_size = sizeof part, .kind = VBGPD_SELECT_POLYGON, .xy = corners, .xy_stride = 16, .n_points = 4};
  int64_t n = -1, ids[SIZE];
  double values[2 * SIZE];
  vbgpd_status s = vbgpd_model_select(model, &soil, ids, 8, SIZE, &n);
  printf("30 soil %d %" PRId64 " %016" PRIX64, s, n, checksum(ids, n));
  s = vbgpd_model_select(model, &part, ids, 8, SIZE, &n);
  printf(" polygon %d %" PRId64 " %016" PRIX64, s, n, checksum(ids, n));
  s = vbgpd_model_read_selected_f64(model, field_of("displacement"), &part, values, 0, 0, SIZE, &n);
  printf(" displacement %d %" PRId64 " %016" PRIX64, s, n, checksum(values, 2 * n));
  s = vbgpd_model_read_selected_i64(model, field_of("material"), &part, ids, 0, 0, SIZE, &n);
  printf(" material %d %" PRId64 " %016" PRIX64 "\n", s, n, checksum(ids, n));
}

static void step_samples(vbgpd_model* model) {
  const double places[] = {5, 5, 20, 4, 20, 14};
  const int32_t stress = field_of("stress");
  double values[4 * 12], ground[2 * SIZE], worst = 0;
  int64_t inside[12], n = -1, i, c;
  vbgpd_view view = {.struct_size = sizeof view};
  vbgpd_status s = vbgpd_model_sample_points(model, stress, places, 16, 3, values, 0, 0, inside, 0);
  printf("31 points %d %016" PRIX64 " %016" PRIX64, s, checksum(values, 4 * 2), checksum(inside, 3));
  s = vbgpd_model_sample_line(model, stress, 2, 1, 12, 11, 6, values, 0, 0, inside, 0);
  printf(" line %d %016" PRIX64, s, checksum(values, 4 * 6));
  s = vbgpd_model_sample_grid(model, field_of("plastic_strain"), 1, 1, 3, 1, 4, 3, values, 0, 0, inside, 0);
  printf(" grid %d %016" PRIX64 " %016" PRIX64, s, checksum(values, 12), checksum(inside, 12));
  s = vbgpd_model_ground_surface(model, ground, 16, SIZE, &n);
  printf(" ground %d %" PRId64 " %016" PRIX64 "\n", s, n, checksum(ground, 2 * n));
  s = vbgpd_model_view_acquire(model, field_of("displacement"), &view);
  for (i = 0; i < view.count; ++i)
    for (c = 0; c < 2; ++c) {
      double u;
      memcpy(&u, (const char*)view.data + i * view.stride_item + c * view.stride_component, 8);
      if (u < worst) worst = u;
    }
  printf("   view %d %s, held: ", s, hex(worst));
  MODEL_FAILED(vbgpd_model_step(model, 1, NULL));
  printf("   released %d\n", vbgpd_model_view_release(model, view.lease));
}

static void step_outside(vbgpd_model* model) {
  const double places[] = {0, 0, 40, 0, 0, 15}, pressures[] = {60e3, 20e3, -10e3}, push[] = {-1e3, 2e3};
  const int64_t id = 3;
  vbgpd_selection one = {.struct_size = sizeof one, .kind = VBGPD_SELECT_IDS, .ids = &id, .ids_stride = 8, .n_ids = 1};
  double fx = 0, fy = 0;
  int64_t b;
  vbgpd_status s[4];
  s[0] = vbgpd_model_write_points(model, field_of("pore_pressure"), places, 16, pressures, 0, 0, 3);
  s[1] = vbgpd_model_write_f64(model, field_of("external_force"), &one, push, 0, 0, 1);
  s[2] = vbgpd_model_set_load(model, 0, 7e3, 9e3);
  s[3] = vbgpd_model_set_f64(model, "kh", 2, 0.0625);
  printf("32 from outside %d %d %d %d, a fixed boundary: ", s[0], s[1], s[2], s[3]);
  MODEL_FAILED(vbgpd_model_set_boundary_velocity(model, 0, 1, 0));
  say_advance("   then", model, 0.09375);
  for (b = 0; b < 3; ++b) {
    s[0] = vbgpd_model_boundary_reaction(model, b, &fx, &fy);
    printf("   reaction %d %s %s\n", s[0], hex(fx), hex(fy));
  }
  s[0] = vbgpd_model_set_layer_active(model, 0, 1);
  printf("   layer on %d, the only one off: ", s[0]);
  MODEL_FAILED(vbgpd_model_set_layer_active(model, 0, 0));
}

static void step_events(vbgpd_model* model) {
  vbgpd_event e[8] = {{.struct_size = sizeof e[0]}};
  int64_t n = -1, i;
  vbgpd_status s = vbgpd_model_events_read(model, 0, e, sizeof e[0], 8, &n, NULL);
  printf("   events %d", s);
  for (i = 0; i < n; ++i)
    printf(" %d %" PRId64 " %" PRId64 " %s %" PRId64 " %" PRId64 " %s %s %s", e[i].kind, e[i].sequence, e[i].step,
           hex(e[i].time), e[i].id_a, e[i].id_b, hex(e[i].x), hex(e[i].y), hex(e[i].value));
  printf("\n");
}

static void step_checkpoint(vbgpd_context* context, vbgpd_profile* profile, vbgpd_model* model) {
  vbgpd_model* other = NULL;
  int64_t size = -1, scene = -1;
  char* bytes;
  vbgpd_status s;
  vbgpd_model_checkpoint(model, NULL, 0, &size);
  bytes = (char*)malloc((size_t)size);
  s = vbgpd_model_checkpoint(model, bytes, size, &size);
  printf("33 checkpoint %d %" PRId64, s, size);
  s = vbgpd_model_create_from_checkpoint(context, bytes, size, &other);
  printf(" made %d", s);
  say_hash(other);
  say_advance("   both", model, 0.125);
  say_advance("   both", other, 0.125);
  s = vbgpd_model_restore_checkpoint(model, bytes, size);
  printf("   back %d", s);
  say_hash(model);
  printf("   cut short: ");
  MODEL_FAILED(vbgpd_model_restore_checkpoint(model, bytes, size / 2));
  vbgpd_model_destroy(other);
  free(bytes);
  s = vbgpd_profile_to_flatbuffer(profile, NULL, 0, &scene);
  printf("   profile %d %" PRId64, s, scene);
  s = vbgpd_model_snapshot(model, NULL, 0, &size);
  printf(" snapshot %d %" PRId64 "\n", s, size);
}

static void step_coupling(vbgpd_context* context, vbgpd_profile* profile) {
  vbgpd_model* model = NULL;
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", 7, 1.25);
  vbgpd_model_create(context, profile, &model);
  step_states(model);
  step_selections(model);
  step_samples(model);
  step_outside(model);
  step_events(model);
  step_checkpoint(context, profile, model);
  vbgpd_model_destroy(model);
}

static void VBGPD_CALL hear(void* user, const vbgpd_log_line* line, const char* text) {
  ++*(int*)user;
  printf("   heard level %d: %s\n", line->level, text);
}

static void step_log(vbgpd_context* context, vbgpd_model* model) {
  vbgpd_model* other = NULL;
  int64_t size = 0;
  int lines = 0;
  char* bytes;
  vbgpd_status s[3];
  vbgpd_model_checkpoint(model, NULL, 0, &size);
  bytes = (char*)malloc((size_t)size);
  vbgpd_model_checkpoint(model, bytes, size, &size);
  s[0] = vbgpd_context_set_log(context, hear, &lines, VBGPD_LOG_INFO);
  s[1] = vbgpd_model_create_from_checkpoint(context, bytes, size, &other);
  s[2] = vbgpd_context_set_log(context, NULL, NULL, VBGPD_LOG_INFO);
  printf("   told %d %d %d, %d lines\n", s[0], s[1], s[2], lines);
  vbgpd_model_destroy(other);
  free(bytes);
}

static void step_memory(vbgpd_context* context, vbgpd_model* model) {
  vbgpd_log_line line = {.struct_size = sizeof line};
  vbgpd_memory m = {.struct_size = sizeof m};
  char text[248] = "";
  vbgpd_status s = vbgpd_context_log_next(context, 0, &line, text, sizeof text, NULL);
  printf("   log %d level %d sequence %" PRId64 ": %s", s, line.level, line.sequence, text);
  printf(" then %d\n", vbgpd_context_log_next(context, SIZE, &line, text, sizeof text, NULL));
  s = vbgpd_model_memory(model, &m);
  printf("   memory %d %" PRId64 " %" PRId64 " %" PRId64 " %" PRId64 " %" PRId64 " %" PRId64 " %" PRId64 "\n", s,
         m.bytes, m.model, m.state, m.scratch, m.copies, m.outside, m.saved);
}

int main(void) {
  static const char* const sizes[] = {"particles", "bonds", "area", "height", "total_mass", "spacing_x", "spacing_y"};
  vbgpd_context_desc desc;
  vbgpd_context *context = NULL, *other = NULL;
  vbgpd_profile* profile = NULL;
  vbgpd_model* model = NULL;
  vbgpd_job* job = NULL;
  int64_t n = -1;
  double value = 0;
  vbgpd_status s, t;
  step_tables();
  vbgpd_context_desc_init(&desc, sizeof desc);
  desc.abi_version = 99;
  s = vbgpd_context_create(&desc, &other);
  desc.abi_version = VBGPD_ABI_VERSION;
  desc.max_particles = 100000;
  t = vbgpd_context_create(&desc, &context);
  printf("05 context %d %d %d\n", s, t, vbgpd_context_error(context, NULL, NULL, 0, NULL));
  vbgpd_profile_create(context, &profile);
  step_profile(context, profile);
  step_parts(profile);
  s = vbgpd_model_create(context, profile, &model);
  printf("15 model %d", s);
  say_numbers(model, sizes, 7);
  say_hash(model);
  step_memory(context, model);
  step_log(context, model);
  step_equilibrium(model);
  step_fields(model);
  step_dynamics(model);
  step_plan(model);
  vbgpd_model_destroy(model);
  vbgpd_model_create(context, profile, &model);
  vbgpd_job_create_strength_reduction(model, &job);
  step_strength_reduction(model, job);
  step_progress(context, profile);
  step_coupling(context, profile);
  /* Parents first; the job still answers. A destroyed handle is known as such, NULL may be destroyed. */
  s = vbgpd_profile_destroy(profile);
  printf("34 destroyed %d %d", s, vbgpd_profile_count(profile, VBGPD_OBJECT_LAYER, &n));
  printf(" NULL %d %d %d", vbgpd_model_item_count(NULL, VBGPD_AT_BOND, &n), vbgpd_job_get_f64(NULL, "steps", 5, &value),
         vbgpd_profile_destroy(NULL));
  printf(" foreign %d\n", vbgpd_model_item_count((vbgpd_model*)context, VBGPD_AT_BOND, &n));
  s = vbgpd_context_destroy(context);
  t = vbgpd_model_destroy(model);
  printf("35 destroyed %d %d, job still has", s, t);
  {
    const char* const left[] = {"factor_of_safety"};
    say_job_numbers(job, left, 1);
  }
  printf(" %d\n", vbgpd_job_destroy(job));
  return 0;
}
