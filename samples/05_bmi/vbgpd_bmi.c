/* BMI 2.0 over vbgpd.h, as a library of its own with the one symbol register_bmi; conventions of NOAA's ngen: time in
 * seconds from 0, units in UDUNITS form, exchange on a fixed raster, serialization through variables. */
#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bmi.h"
#include "slope_model.h"

enum { scalar_grid, ground_grid, raster_grid, no_grid };
enum { is_input, is_output, is_hidden };

typedef struct {
  const char *name, *units, *type;
  int itemsize, grid, role;
} variable;

/* Names follow the pattern of the CSDMS standard names. Hidden ones are not listed, but known by name. */
static const variable variables[] = {
    {"soil_water__pressure", "Pa", "double", 8, raster_grid, is_input},
    {"soil__horizontal_seismic_coefficient", "1", "double", 8, scalar_grid, is_input},
    {"land_surface__horizontal_displacement", "m", "double", 8, ground_grid, is_output},
    {"land_surface__vertical_displacement", "m", "double", 8, ground_grid, is_output},
    {"soil__plastic_bond_fraction", "1", "double", 8, raster_grid, is_output},
    {"soil__max_displacement", "m", "double", 8, scalar_grid, is_output},
    {"soil__unbalanced_force_ratio", "1", "double", 8, scalar_grid, is_output},
    {"ngen::serialization_create", "1", "uint64_t", 8, no_grid, is_hidden},
    {"ngen::serialization_size", "1", "uint64_t", 8, no_grid, is_hidden},
    {"ngen::serialization_state", "1", "char", 1, no_grid, is_hidden},
    {"ngen::serialization_free", "1", "int", 4, no_grid, is_hidden},
    {"vbgpd::last_error", "1", "char", 1, no_grid, is_hidden},
};
enum {
  pressure,
  seismic,
  ground_x,
  ground_y,
  plastic,
  largest,
  unbalanced,
  create,
  size_of_saved,
  saved,
  free_saved,
  last_error,
  variable_count
};

static slope_model* of(Bmi* self) { return (slope_model*)self->data; }

static int find(const char* name) {
  int v;
  for (v = 0; v < variable_count; ++v)
    if (strcmp(variables[v].name, name) == 0) return v;
  return -1;
}

static int size_of_grid(slope_model* s, int grid) {
  if (grid == scalar_grid) return 1;
  if (grid == ground_grid) return s->nodes;
  return grid == raster_grid ? s->nx * s->ny : 0;
}

static void* address(slope_model* s, int v) {
  switch (v) {
    case pressure:
      return s->pore_pressure;
    case seismic:
      return &s->kh;
    case ground_x:
      return s->move_x;
    case ground_y:
      return s->move_y;
    case plastic:
      return s->plastic_fraction;
    case largest:
      return &s->largest;
    case unbalanced:
      return &s->unbalanced;
    case size_of_saved:
      return &s->saved_size;
    case saved:
      return s->saved;
    case last_error:
      return s->error;
    default:
      return NULL;
  }
}

static int bytes_of(slope_model* s, int v) {
  if (v == saved) return (int)s->saved_size;
  if (v == last_error) return error_size;
  if (variables[v].grid == no_grid) return variables[v].itemsize;
  return variables[v].itemsize * size_of_grid(s, variables[v].grid);
}

static int success(int fine) { return fine ? BMI_SUCCESS : BMI_FAILURE; }
static int text(char* to, const char* from) { return strcpy(to, from), BMI_SUCCESS; }

/* ---- life ---- */
static int initialize(Bmi* self, const char* config_file) {
  char error[error_size] = "";
  self->data = slope_open(config_file, error);
  if (self->data == NULL) fprintf(stderr, "vbgpd: %s\n", error); /* nowhere else to say it before there is a model */
  return success(self->data != NULL);
}
static int update_until(Bmi* self, double time) { return success(self->data && slope_advance(of(self), time)); }
static int update(Bmi* self) {
  return self->data ? update_until(self, slope_number(of(self), "time") + slope_number(of(self), "time_step"))
                    : BMI_FAILURE;
}
static int finalize(Bmi* self) {
  if (self->data) slope_close(of(self));
  self->data = NULL;
  return BMI_SUCCESS;
}

/* ---- what is exchanged ---- */
static int component_name(Bmi* self, char* name) { return (void)self, text(name, "vbgpd slope"); }
static int count_of(int role) {
  int v, n = 0;
  for (v = 0; v < variable_count; ++v) n += variables[v].role == role;
  return n;
}
static int input_count(Bmi* self, int* n) { return (void)self, *n = count_of(is_input), BMI_SUCCESS; }
static int output_count(Bmi* self, int* n) { return (void)self, *n = count_of(is_output), BMI_SUCCESS; }
static int names_of(int role, char** names) {
  int v;
  for (v = 0; v < variable_count; ++v)
    if (variables[v].role == role) strcpy(*names++, variables[v].name);
  return BMI_SUCCESS;
}
static int input_names(Bmi* self, char** names) { return (void)self, names_of(is_input, names); }
static int output_names(Bmi* self, char** names) { return (void)self, names_of(is_output, names); }

/* ---- variables ---- */
static int var_grid(Bmi* self, const char* name, int* grid) {
  const int v = find(name);
  if (v < 0 || variables[v].grid == no_grid) return BMI_FAILURE;
  return (void)self, *grid = variables[v].grid, BMI_SUCCESS;
}
static int var_type(Bmi* self, const char* name, char* type) {
  const int v = find(name);
  return (void)self, v < 0 ? BMI_FAILURE : text(type, variables[v].type);
}
static int var_units(Bmi* self, const char* name, char* units) {
  const int v = find(name);
  return (void)self, v < 0 ? BMI_FAILURE : text(units, variables[v].units);
}
static int var_itemsize(Bmi* self, const char* name, int* size) {
  const int v = find(name);
  return (void)self, v < 0 ? BMI_FAILURE : (*size = variables[v].itemsize, BMI_SUCCESS);
}
static int var_nbytes(Bmi* self, const char* name, int* bytes) {
  const int v = find(name);
  return v < 0 || !self->data ? BMI_FAILURE : (*bytes = bytes_of(of(self), v), BMI_SUCCESS);
}
static int var_location(Bmi* self, const char* name, char* location) {
  return (void)self, find(name) < 0 ? BMI_FAILURE : text(location, "node");
}

/* ---- time ---- */
static int current_time(Bmi* self, double* t) {
  return self->data ? (*t = slope_number(of(self), "time"), BMI_SUCCESS) : BMI_FAILURE;
}
static int start_time(Bmi* self, double* t) { return (void)self, *t = 0, BMI_SUCCESS; }
static int end_time(Bmi* self, double* t) { return (void)self, *t = DBL_MAX, BMI_SUCCESS; }
static int time_units(Bmi* self, char* units) { return (void)self, text(units, "s"); }
static int time_step(Bmi* self, double* step) {
  return self->data ? (*step = slope_number(of(self), "time_step"), BMI_SUCCESS) : BMI_FAILURE;
}

/* ---- values ---- */
static int get_value_ptr(Bmi* self, const char* name, void** at) {
  const int v = find(name);
  *at = v < 0 || !self->data ? NULL : address(of(self), v);
  return success(*at != NULL);
}
static int get_value(Bmi* self, const char* name, void* to) {
  void* at = NULL;
  if (get_value_ptr(self, name, &at) != BMI_SUCCESS) return BMI_FAILURE;
  return memcpy(to, at, (size_t)bytes_of(of(self), find(name))), BMI_SUCCESS;
}
static int at_indices(Bmi* self, const char* name, void* host, const int* indices, int count, int into_model) {
  const int v = find(name), size = v < 0 ? 0 : variables[v].itemsize;
  char* at = v < 0 || !self->data ? NULL : address(of(self), v);
  int k;
  if (at == NULL || (into_model && variables[v].role != is_input)) return BMI_FAILURE;
  for (k = 0; k < count; ++k)
    if (indices[k] < 0 || indices[k] >= bytes_of(of(self), v) / size) return BMI_FAILURE;
  for (k = 0; k < count; ++k) {
    char *there = at + (size_t)indices[k] * (size_t)size, *here = (char*)host + (size_t)k * (size_t)size;
    if (into_model) memcpy(there, here, (size_t)size);
    else memcpy(here, there, (size_t)size);
  }
  if (into_model && v == pressure) of(self)->pore_pressure_is_new = 1;
  return BMI_SUCCESS;
}
static int get_value_at_indices(Bmi* self, const char* name, void* to, int* indices, int count) {
  return at_indices(self, name, to, indices, count, 0);
}
static int set_value_at_indices(Bmi* self, const char* name, int* indices, int count, void* from) {
  return at_indices(self, name, from, indices, count, 1);
}
static int set_value(Bmi* self, const char* name, void* from) {
  const int v = find(name);
  slope_model* s = of(self);
  if (v < 0 || s == NULL) return BMI_FAILURE;
  if (v == create) return success(slope_save(s));
  if (v == saved) return success(slope_restore(s, from));
  if (v == free_saved) return free(s->saved), s->saved = NULL, s->saved_size = 0, BMI_SUCCESS;
  if (variables[v].role != is_input) return BMI_FAILURE;
  memcpy(address(s, v), from, (size_t)bytes_of(s, v));
  if (v == pressure) s->pore_pressure_is_new = 1;
  return BMI_SUCCESS;
}

/* ---- grids: a scalar, the nodes of the ground, the raster (rows first, as BMI has it) ---- */
static int grid_rank(Bmi* self, int grid, int* rank) {
  return (void)self, *rank = grid == scalar_grid ? 0 : 2, success(grid >= 0 && grid < no_grid);
}
static int grid_size(Bmi* self, int grid, int* size) {
  return *size = self->data ? size_of_grid(of(self), grid) : 0, success(*size > 0);
}
static int grid_type(Bmi* self, int grid, char* type) {
  static const char* const types[] = {"scalar", "points", "uniform_rectilinear"};
  return (void)self, grid < 0 || grid >= no_grid ? BMI_FAILURE : text(type, types[grid]);
}
static int grid_shape(Bmi* self, int grid, int* shape) {
  if (grid != raster_grid || !self->data) return BMI_FAILURE;
  return shape[0] = of(self)->ny, shape[1] = of(self)->nx, BMI_SUCCESS;
}
static int grid_spacing(Bmi* self, int grid, double* spacing) {
  if (grid != raster_grid || !self->data) return BMI_FAILURE;
  return spacing[0] = spacing[1] = of(self)->step, BMI_SUCCESS;
}
static int grid_origin(Bmi* self, int grid, double* origin) {
  if (grid != raster_grid || !self->data) return BMI_FAILURE;
  return origin[0] = of(self)->y0, origin[1] = of(self)->x0, BMI_SUCCESS;
}
static int grid_nodes(Bmi* self, int grid, double* to, int y) {
  if (grid != ground_grid || !self->data) return BMI_FAILURE;
  memcpy(to, y ? of(self)->ground_y : of(self)->ground_x, (size_t)of(self)->nodes * sizeof(double));
  return BMI_SUCCESS;
}
static int grid_x(Bmi* self, int grid, double* x) { return grid_nodes(self, grid, x, 0); }
static int grid_y(Bmi* self, int grid, double* y) { return grid_nodes(self, grid, y, 1); }
static int grid_z(Bmi* self, int grid, double* z) { return (void)self, (void)grid, (void)z, BMI_FAILURE; }
static int node_count(Bmi* self, int grid, int* count) {
  if (grid != ground_grid || !self->data) return BMI_FAILURE;
  return *count = of(self)->nodes, BMI_SUCCESS;
}
static int no_elements(Bmi* self, int grid, int* count) { return (void)self, (void)grid, *count = 0, BMI_FAILURE; }

__attribute__((visibility("default"))) Bmi* register_bmi(Bmi* model) {
  const Bmi filled = {
      NULL,         initialize,           update,      update_until, finalize,      component_name,
      input_count,  output_count,         input_names, output_names, var_grid,      var_type,
      var_units,    var_itemsize,         var_nbytes,  var_location, current_time,  start_time,
      end_time,     time_units,           time_step,   get_value,    get_value_ptr, get_value_at_indices,
      set_value,    set_value_at_indices, grid_rank,   grid_size,    grid_type,     grid_shape,
      grid_spacing, grid_origin,          grid_x,      grid_y,       grid_z,        node_count,
      no_elements,  no_elements,          no_elements, no_elements,  no_elements,   no_elements};
  if (model != NULL) *model = filled;
  return model;
}
