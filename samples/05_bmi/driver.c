/* What a BMI framework does with a model it knows nothing about: loads the library, asks, sets, steps, saves, restores.
 * Usage: bmi_driver LIBRARY SCENE_FILE. The scene file is written here first; a framework would be given one. */
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <vbgpd/vbgpd.h>

#include "bmi.h"

#define MUST(condition)                                                         \
  do {                                                                          \
    if (!(condition)) {                                                         \
      fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #condition); \
      exit(1);                                                                  \
    }                                                                           \
  } while (0)

static void write_scene(const char* path) {
  static const double outline[] = {0, 0, 40, 0, 40, 5, 25, 5, 15, 15, 0, 15};
  static char bytes[4096];
  vbgpd_context* context = NULL;
  vbgpd_profile* profile = NULL;
  int64_t size = 0;
  FILE* file;
  MUST(vbgpd_context_create(NULL, &context) == VBGPD_OK && vbgpd_profile_create(context, &profile) == VBGPD_OK);
  vbgpd_profile_set_exterior(profile, outline, 16, 6);
  vbgpd_profile_add_material(profile, "soil", VBGPD_STRLEN, NULL);
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_MATERIAL, 0, "unit_weight", VBGPD_STRLEN, 20e3);
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_MATERIAL, 0, "cohesion", VBGPD_STRLEN, 20e3);
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_MATERIAL, 0, "friction_angle", VBGPD_STRLEN, 25);
  vbgpd_profile_add_layer(profile, NULL, 16, 0, 0, NULL);
  vbgpd_profile_set_f64(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", VBGPD_STRLEN, 1);
  MUST(vbgpd_profile_to_flatbuffer(profile, bytes, sizeof bytes, &size) == VBGPD_OK);
  file = fopen(path, "wb");
  MUST(file != NULL && fwrite(bytes, 1, (size_t)size, file) == (size_t)size && fclose(file) == 0);
  vbgpd_profile_destroy(profile);
  vbgpd_context_destroy(context);
}

static double scalar(Bmi* m, const char* name) {
  double value = NAN;
  MUST(m->get_value(m, name, &value) == BMI_SUCCESS);
  return value;
}

/* Names, units, sizes and grids fit together. */
static void ask_around(Bmi* m) {
  int (*const counts[2])(Bmi*, int*) = {m->get_input_item_count, m->get_output_item_count};
  int (*const lists[2])(Bmi*, char**) = {m->get_input_var_names, m->get_output_var_names};
  static char storage[16][BMI_MAX_VAR_NAME], unit[BMI_MAX_UNITS_NAME], type[BMI_MAX_TYPE_NAME];
  char* names[16];
  int side, n, k, grid, size, bytes, cells;
  for (k = 0; k < 16; ++k) names[k] = storage[k];
  for (side = 0; side < 2; ++side) {
    MUST(counts[side](m, &n) == BMI_SUCCESS && n > 0 && n <= 16 && lists[side](m, names) == BMI_SUCCESS);
    for (k = 0; k < n; ++k) {
      MUST(m->get_var_grid(m, names[k], &grid) == BMI_SUCCESS && m->get_grid_size(m, grid, &cells) == BMI_SUCCESS);
      MUST(m->get_var_itemsize(m, names[k], &size) == BMI_SUCCESS &&
           m->get_var_nbytes(m, names[k], &bytes) == BMI_SUCCESS);
      MUST(m->get_var_units(m, names[k], unit) == BMI_SUCCESS && m->get_var_type(m, names[k], type) == BMI_SUCCESS);
      MUST(bytes == size * cells && strcmp(type, "double") == 0 && unit[0] != 0);
      printf("%s %s [%s] on grid %d of %d\n", side ? "out" : "in ", names[k], unit, grid, cells);
    }
  }
  MUST(m->get_var_grid(m, "no such variable", &grid) == BMI_FAILURE);
}

/* Water over the whole section up to a level, on the raster of the model. */
static void soak(Bmi* m, double level) {
  int grid, shape[2], i, j;
  double spacing[2], origin[2], *pressure;
  MUST(m->get_var_grid(m, "soil_water__pressure", &grid) == BMI_SUCCESS &&
       m->get_grid_shape(m, grid, shape) == BMI_SUCCESS);
  MUST(m->get_grid_spacing(m, grid, spacing) == BMI_SUCCESS && m->get_grid_origin(m, grid, origin) == BMI_SUCCESS);
  pressure = malloc((size_t)shape[0] * (size_t)shape[1] * sizeof(double));
  for (j = 0; j < shape[0]; ++j)
    for (i = 0; i < shape[1]; ++i) pressure[j * shape[1] + i] = fmax(0, 9.81e3 * (level - origin[0] - j * spacing[0]));
  MUST(m->set_value(m, "soil_water__pressure", pressure) == BMI_SUCCESS);
  free(pressure);
}

int main(int argc, char** argv) {
  Bmi model, *m = &model;
  Bmi* (*register_model)(Bmi*);
  void *library, *kept, *state = NULL, *size = NULL;
  double now = -1, before, first, *row = NULL;
  uint64_t one = 1;
  char* copy;
  MUST(argc == 3);
  write_scene(argv[2]);
  library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) fprintf(stderr, "%s\n", dlerror());
  MUST(library != NULL);
  kept = dlsym(library, "register_bmi");
  MUST(kept != NULL);
  memcpy(&register_model, &kept, sizeof kept); /* ISO C has no cast from an object to a function pointer */
  memset(m, 0, sizeof *m);
  register_model(m);
  MUST(m->initialize(m, "no such file") == BMI_FAILURE);
  MUST(m->initialize(m, argv[2]) == BMI_SUCCESS);
  ask_around(m);
  MUST(m->get_current_time(m, &now) == BMI_SUCCESS && now == 0.0);
  MUST(m->get_value_ptr(m, "land_surface__vertical_displacement", (void**)&row) == BMI_SUCCESS);

  MUST(m->update(m) == BMI_SUCCESS && m->get_current_time(m, &now) == BMI_SUCCESS && now > 0);
  MUST(m->update_until(m, 0.25) == BMI_SUCCESS && m->get_current_time(m, &now) == BMI_SUCCESS && now == 0.25);
  MUST(m->update_until(m, 0.125) == BMI_FAILURE); /* never backwards */
  MUST(m->get_value_ptr(m, "vbgpd::last_error", &kept) == BMI_SUCCESS && strstr(kept, "0.25") != NULL);
  MUST(row[1] < 0); /* the crest has settled, and the array is where it was */
  before = scalar(m, "soil__max_displacement");

  /* saved, tried with water, taken back, tried again */
  MUST(m->set_value(m, "ngen::serialization_create", &one) == BMI_SUCCESS);
  MUST(m->get_value_ptr(m, "ngen::serialization_size", &size) == BMI_SUCCESS);
  MUST(m->get_value_ptr(m, "ngen::serialization_state", &state) == BMI_SUCCESS);
  copy = malloc((size_t) * (uint64_t*)size);
  memcpy(copy, state, (size_t) * (uint64_t*)size);
  MUST(m->set_value(m, "ngen::serialization_free", &one) == BMI_SUCCESS);
  soak(m, 12);
  MUST(m->update_until(m, 0.5) == BMI_SUCCESS);
  first = scalar(m, "soil__max_displacement");
  MUST(m->set_value(m, "ngen::serialization_state", copy) == BMI_SUCCESS);
  MUST(m->get_current_time(m, &now) == BMI_SUCCESS && now == 0.25 && scalar(m, "soil__max_displacement") == before);
  soak(m, 12);
  MUST(m->update_until(m, 0.5) == BMI_SUCCESS && scalar(m, "soil__max_displacement") == first);
  MUST(m->set_value(m, "soil__max_displacement", &first) == BMI_FAILURE);
  printf("largest displacement %.1f mm, saved state of %d kB\n", 1e3 * first, (int)(*(int64_t*)copy / 1000));
  free(copy);
  MUST(m->finalize(m) == BMI_SUCCESS && m->update(m) == BMI_FAILURE);
  MUST(dlclose(library) == 0);
  remove(argv[2]);
  return 0;
}
