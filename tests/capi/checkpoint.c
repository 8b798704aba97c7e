/* A model, at rest or sliding, goes on in another process as if nothing had happened: capi_checkpoint; capi_checkpoint
 * go_on FILE THREADS. */
#include <inttypes.h>

#include "slope.h"

enum { before = 200, after = 1000 };

static vbgpd_context* context_with(int32_t threads) {
  vbgpd_context_desc desc;
  vbgpd_context* context = NULL;
  CHECK_OK(vbgpd_context_desc_init(&desc, sizeof desc));
  desc.threads = threads;
  CHECK_OK(vbgpd_context_create(&desc, &context));
  return context;
}

/* Everything that can be set from outside is set. */
static vbgpd_model* driven_model(vbgpd_context* context) {
  static const double corners[4] = {40e3, 20e3, 0, -60e3};
  vbgpd_profile* profile = make_profile(context, 1);
  vbgpd_model* model = NULL;
  vbgpd_selection top;
  double push[2] = {-400, 100};
  const int64_t id = 7;
  int32_t field;
  CHECK_OK(vbgpd_profile_add_load(profile, 2, 8, 10e3, 10e3, NULL));
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_model_set_load(model, 0, 40e3, 50e3));
  CHECK_OK(vbgpd_model_set_f64(model, "kh", VBGPD_STRLEN, 0.05));
  CHECK_OK(vbgpd_model_set_f64(model, "damping", VBGPD_STRLEN, 0.1));
  CHECK_OK(vbgpd_model_set_f64(model, "time_step_factor", VBGPD_STRLEN, 0.5));
  CHECK_OK(vbgpd_model_set_f64(model, "strength_reduction_factor", VBGPD_STRLEN, 1.5));
  CHECK_OK(vbgpd_field_find("pore_pressure", VBGPD_STRLEN, &field));
  CHECK_OK(vbgpd_model_write_grid(model, field, 0, 0, 40, 15, 2, 2, corners, 0));
  memset(&top, 0, sizeof top);
  top.struct_size = sizeof top, top.kind = VBGPD_SELECT_IDS, top.ids = &id, top.n_ids = 1;
  CHECK_OK(vbgpd_field_find("external_force", VBGPD_STRLEN, &field));
  CHECK_OK(vbgpd_model_write_f64(model, field, &top, push, 0, 0, 1));
  CHECK_OK(vbgpd_model_step(model, before, NULL));
  CHECK(model_number(model, "plastic_bonds") > 100);
  return model;
}

/* The same slope with a third of its strength, in the middle of its slide. */
static vbgpd_model* sliding_model(vbgpd_context* context) {
  vbgpd_model *at_rest = driven_model(context), *sliding = NULL;
  vbgpd_selection top;
  double push[2] = {-900, 300};
  const int64_t id = 11;
  int32_t field;
  CHECK_OK(vbgpd_model_set_f64(at_rest, "strength_reduction_factor", VBGPD_STRLEN, 3));
  CHECK_OK(vbgpd_model_create_runout(at_rest, &sliding));
  CHECK_OK(vbgpd_model_destroy(at_rest));
  CHECK_OK(vbgpd_model_set_load(sliding, 0, 20e3, 30e3));
  CHECK_OK(vbgpd_model_set_f64(sliding, "kv", VBGPD_STRLEN, 0.1));
  memset(&top, 0, sizeof top);
  top.struct_size = sizeof top, top.kind = VBGPD_SELECT_IDS, top.ids = &id, top.n_ids = 1;
  CHECK_OK(vbgpd_field_find("external_force", VBGPD_STRLEN, &field));
  CHECK_OK(vbgpd_model_write_f64(sliding, field, &top, push, 0, 0, 1));
  CHECK_OK(vbgpd_model_advance_to(sliding, 1, 0, NULL, NULL, NULL));
  CHECK(model_number(sliding, "max_displacement") > 0.5 && model_number(sliding, "neighbour_searches") > 2);
  return sliding;
}

static uint64_t hash_of(const vbgpd_model* model) {
  uint64_t hash = 0;
  CHECK_OK(vbgpd_model_state_hash(model, &hash));
  return hash;
}

static unsigned char* bytes_of(const vbgpd_model* model, int64_t* size) {
  unsigned char* bytes;
  CHECK_OK(vbgpd_model_checkpoint(model, NULL, 0, size));
  bytes = (unsigned char*)malloc((size_t)*size);
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_model_checkpoint(model, bytes, *size - 1, size));
  CHECK_OK(vbgpd_model_checkpoint(model, bytes, *size, size));
  return bytes;
}

static int go_on(const char* path, int32_t threads) {
  vbgpd_context* context = context_with(threads);
  vbgpd_model* model = NULL;
  FILE* file = fopen(path, "rb");
  unsigned char* bytes = (unsigned char*)malloc(1 << 24);
  size_t size;
  CHECK(file != NULL);
  size = fread(bytes, 1, 1 << 24, file);
  fclose(file);
  CHECK_OK(vbgpd_model_create_from_checkpoint(context, bytes, (int64_t)size, &model));
  free(bytes);
  CHECK_OK(vbgpd_model_step(model, after, NULL));
  printf("%016" PRIX64 "\n", hash_of(model));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}

/* What the other process printed must be the hash here. */
static void same_in_another_process(const char* program, const char* path, int threads, uint64_t expected) {
  char command[10000], line[64] = "";
  uint64_t there = 0;
  FILE* pipe;
  snprintf(command, sizeof command, "\"%s\" go_on \"%s\" %d", program, path, threads);
  pipe = popen(command, "r");
  CHECK(pipe != NULL && fgets(line, sizeof line, pipe) != NULL);
  CHECK(pclose(pipe) == 0);
  CHECK(sscanf(line, "%" SCNx64, &there) == 1);
  CHECK(there == expected);
}

/* Cut short or with a flipped bit it is refused, or what it says is still a model; nothing ever crashes. */
static void damaged_ones_are_refused(vbgpd_context* context, vbgpd_model* model, const unsigned char* bytes,
                                     int64_t size) {
  unsigned char* copy = (unsigned char*)malloc((size_t)size);
  const uint64_t hash = hash_of(model);
  int64_t cut, bit;
  vbgpd_model* made = NULL;
  for (cut = 0; cut < size; cut += 1 + cut / 8) {
    memcpy(copy, bytes, (size_t)cut);
    CHECK_STATUS(VBGPD_E_FORMAT, vbgpd_model_restore_checkpoint(model, copy, cut));
  }
  for (bit = 0; bit < 8 * 2048; bit += 53) {
    vbgpd_status s;
    memcpy(copy, bytes, (size_t)size);
    copy[bit / 8] ^= (unsigned char)(1 << bit % 8);
    s = vbgpd_model_restore_checkpoint(model, copy, size);
    CHECK(s == VBGPD_OK || s == VBGPD_E_FORMAT || s == VBGPD_E_VERSION);
  }
  CHECK_OK(vbgpd_model_restore_checkpoint(model, bytes, size));
  CHECK(hash_of(model) == hash);
  CHECK_STATUS(VBGPD_E_FORMAT, vbgpd_model_create_from_checkpoint(context, "VBGPVBGPVBGPVBGP", 16, &made));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_create_from_checkpoint(context, bytes, -1, &made));
  CHECK(made == NULL);
  {
    vbgpd_model* other = make_model(context, 2.5);
    CHECK_STATUS(VBGPD_E_FORMAT, vbgpd_model_restore_checkpoint(other, bytes, size));
    CHECK_OK(vbgpd_model_destroy(other));
  }
  free(copy);
}

static void limits_hold_for_checkpoints(const unsigned char* bytes, int64_t size) {
  vbgpd_context_desc desc;
  vbgpd_context* context = NULL;
  vbgpd_model* made = NULL;
  CHECK_OK(vbgpd_context_desc_init(&desc, sizeof desc));
  desc.max_particles = 100;
  CHECK_OK(vbgpd_context_create(&desc, &context));
  CHECK_STATUS(VBGPD_E_LIMIT, vbgpd_model_create_from_checkpoint(context, bytes, size, &made));
  CHECK_OK(vbgpd_context_destroy(context));
  desc.max_particles = 0, desc.max_bytes = 10000;
  CHECK_OK(vbgpd_context_create(&desc, &context));
  CHECK_STATUS(VBGPD_E_LIMIT, vbgpd_model_create_from_checkpoint(context, bytes, size, &made));
  CHECK(made == NULL);
  CHECK_OK(vbgpd_context_destroy(context));
}

static void profiles_come_back_from_their_bytes(vbgpd_context* context) {
  vbgpd_profile *profile = make_profile(context, 1), *again = NULL;
  unsigned char bytes[4096], bytes_again[4096];
  int64_t size = 0, size_again = 0;
  CHECK_OK(vbgpd_profile_to_flatbuffer(profile, bytes, sizeof bytes, &size));
  CHECK_OK(vbgpd_profile_create_from_flatbuffer(context, bytes, size, &again));
  CHECK_OK(vbgpd_profile_to_flatbuffer(again, bytes_again, sizeof bytes_again, &size_again));
  CHECK(size == size_again && memcmp(bytes, bytes_again, (size_t)size) == 0);
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_profile_to_flatbuffer(profile, bytes, size - 1, NULL));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_profile_destroy(again));
}

/* Nothing has yielded, no load stands: empty arrays lie anywhere among the bytes. */
static void fresh_models_come_back(vbgpd_context* context) {
  int64_t length;
  for (length = 0; length < 8; ++length) {
    vbgpd_profile* profile = make_profile(context, 2.5);
    vbgpd_model *model = NULL, *other = NULL;
    unsigned char* bytes;
    int64_t size = 0;
    CHECK_OK(vbgpd_profile_set_text(profile, VBGPD_OBJECT_PROFILE, 0, "name", 4, "hillside", length));
    CHECK_OK(vbgpd_profile_set_text(profile, VBGPD_OBJECT_MATERIAL, 0, "name", 4, "hillside", length + 1));
    CHECK_OK(vbgpd_model_create(context, profile, &model));
    bytes = bytes_of(model, &size);
    CHECK_OK(vbgpd_model_create_from_checkpoint(context, bytes, size, &other));
    CHECK(hash_of(model) == hash_of(other));
    free(bytes);
    CHECK_OK(vbgpd_profile_destroy(profile));
    CHECK_OK(vbgpd_model_destroy(model));
    CHECK_OK(vbgpd_model_destroy(other));
  }
}

/* Makes the shared slope another one with as many particles and bonds. */
typedef void (*another_fn)(vbgpd_profile* profile);
static void twice_as_large(vbgpd_profile* profile) {
  double outline[12];
  int i;
  for (i = 0; i < 12; ++i) outline[i] = 2 * slope_exterior[i];
  CHECK_OK(vbgpd_profile_set_exterior(profile, outline, 16, 6));
  set_number(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", 5);
}
static void elsewhere(vbgpd_profile* profile) {
  double outline[12];
  int i;
  for (i = 0; i < 12; ++i) outline[i] = slope_exterior[i] + (i % 2 == 0 ? 1000 : 50);
  CHECK_OK(vbgpd_profile_set_exterior(profile, outline, 16, 6));
}
static void stiffer(vbgpd_profile* profile) { set_number(profile, VBGPD_OBJECT_MATERIAL, 0, "young_modulus", 2e8); }
static void softer_law(vbgpd_profile* profile) {
  CHECK_OK(
      vbgpd_profile_set_text(profile, VBGPD_OBJECT_MATERIAL, 0, "law", VBGPD_STRLEN, "drucker_prager", VBGPD_STRLEN));
}
static void wet(vbgpd_profile* profile) {
  static const double table[4] = {0, 8, 40, 3};
  CHECK_OK(vbgpd_profile_set_water_table(profile, table, 16, 2));
}
static void held_otherwise(vbgpd_profile* profile) {
  CHECK_OK(vbgpd_profile_add_boundary(profile, "base", 4, NULL, 16, 0, VBGPD_BOUNDARY_FIXED, NULL));
}
static void lighter(vbgpd_profile* profile) { set_number(profile, VBGPD_OBJECT_PROFILE, 0, "gravity", 5); }
static void renamed_and_shaken(vbgpd_profile* profile) {
  CHECK_OK(vbgpd_profile_set_text(profile, VBGPD_OBJECT_MATERIAL, 0, "name", 4, "clay", 4));
  set_number(profile, VBGPD_OBJECT_PROFILE, 0, "kh", 0.2);
  set_number(profile, VBGPD_OBJECT_PROFILE, 0, "srf_max", 3);
}

static vbgpd_model* another_model(vbgpd_context* context, another_fn make_another) {
  vbgpd_profile* profile = make_profile(context, 2.5);
  vbgpd_model* model = NULL;
  make_another(profile);
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_model_step(model, 20, NULL));
  return model;
}

static void those_of_other_profiles_are_refused_with_the_difference(vbgpd_context* context) {
  static const struct {
    another_fn make;
    const char* told;
  } others[] = {{twice_as_large, "exterior"},
                {elsewhere, "exterior"},
                {stiffer, "material 0 has young_modulus 200000000 there, 100000000 here"},
                {softer_law, "law of material 0"},
                {wet, "water table"},
                {held_otherwise, "1 boundaries"},
                {lighter, "gravity 5 there"}};
  vbgpd_model* model = make_model(context, 2.5);
  const uint64_t hash = hash_of(model);
  vbgpd_model* same;
  unsigned char* bytes;
  int64_t size;
  size_t k;
  char text[400];
  for (k = 0; k < sizeof others / sizeof *others; ++k) {
    vbgpd_model* other = another_model(context, others[k].make);
    vbgpd_error_info info = {sizeof info, 0, 0, 0, 0, 0, 0, 0, 0};
    bytes = bytes_of(other, &size);
    CHECK_STATUS(VBGPD_E_FORMAT, vbgpd_model_restore_checkpoint(model, bytes, size));
    CHECK_OK(vbgpd_model_error(model, &info, text, sizeof text, NULL));
    CHECK_CONTAINS(text, others[k].told);
    CHECK(info.argument == 2 && hash_of(model) == hash);
    free(bytes);
    CHECK_OK(vbgpd_model_destroy(other));
  }
  same = another_model(context, renamed_and_shaken);
  bytes = bytes_of(same, &size);
  CHECK_OK(vbgpd_model_restore_checkpoint(model, bytes, size));
  CHECK(hash_of(model) == hash_of(same) && model_number(model, "kh") == 0.2);
  free(bytes);
  CHECK_OK(vbgpd_model_destroy(same));
  CHECK_OK(vbgpd_model_destroy(model));
}

static void goes_on_in_another_process(const char* program, vbgpd_context* context, vbgpd_model* model) {
  int64_t size = 0;
  unsigned char* bytes = bytes_of(model, &size);
  char path[4200];
  FILE* file;
  int threads;
  uint64_t expected;
  double residual;
  snprintf(path, sizeof path, "%s.vbgc", program);
  file = fopen(path, "wb");
  CHECK(file != NULL && fwrite(bytes, 1, (size_t)size, file) == (size_t)size && fclose(file) == 0);
  damaged_ones_are_refused(context, model, bytes, size);
  limits_hold_for_checkpoints(bytes, size);
  CHECK_OK(vbgpd_model_step(model, after, NULL));
  expected = hash_of(model), residual = model_number(model, "energy_residual");
  for (threads = 1; threads <= 3; ++threads) same_in_another_process(program, path, threads, expected);
  remove(path);
  CHECK_OK(vbgpd_model_restore_checkpoint(model, bytes, size));
  CHECK_OK(vbgpd_model_step(model, after, NULL));
  CHECK(hash_of(model) == expected && model_number(model, "energy_residual") == residual);
  free(bytes);
}

/* One kind is not taken for the other. */
static void kinds_are_told_apart(vbgpd_model* at_rest, vbgpd_model* sliding) {
  int64_t size = 0;
  unsigned char* bytes = bytes_of(at_rest, &size);
  CHECK_STATUS(VBGPD_E_FORMAT, vbgpd_model_restore_checkpoint(sliding, bytes, size));
  free(bytes);
  bytes = bytes_of(sliding, &size);
  CHECK_STATUS(VBGPD_E_FORMAT, vbgpd_model_restore_checkpoint(at_rest, bytes, size));
  free(bytes);
}

int main(int argc, char** argv) {
  if (argc == 4) return go_on(argv[2], (int32_t)atoi(argv[3]));
  vbgpd_context* context = context_with(2);
  vbgpd_model *at_rest = driven_model(context), *sliding = sliding_model(context);
  kinds_are_told_apart(at_rest, sliding);
  goes_on_in_another_process(argv[0], context, at_rest);
  goes_on_in_another_process(argv[0], context, sliding);
  profiles_come_back_from_their_bytes(context);
  fresh_models_come_back(context);
  those_of_other_profiles_are_refused_with_the_difference(context);
  CHECK_OK(vbgpd_model_destroy(at_rest));
  CHECK_OK(vbgpd_model_destroy(sliding));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
