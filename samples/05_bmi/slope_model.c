#include "slope_model.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int done(slope_model* s, vbgpd_status status) {
  if (status >= 0) return 1;
  if (vbgpd_model_error(s->model, NULL, s->error, error_size, NULL) != VBGPD_OK)
    snprintf(s->error, error_size, "%s", vbgpd_status_name(status));
  return 0;
}

static int32_t field_of(const char* name) {
  int32_t field = -1;
  vbgpd_field_find(name, VBGPD_STRLEN, &field);
  return field;
}

double slope_number(slope_model* s, const char* name) {
  double value = NAN;
  vbgpd_model_get_f64(s->model, name, VBGPD_STRLEN, &value);
  return value;
}

/* Outputs after every advance. */
static int refresh(slope_model* s) {
  double* xy = malloc((size_t)s->nodes * 2 * sizeof(double));
  int64_t n = 0;
  int k, fine;
  if (xy == NULL) return 0;
  fine = done(s, vbgpd_model_ground_surface(s->model, xy, 16, s->nodes, &n)) &&
         done(s, vbgpd_model_sample_grid(s->model, field_of("plastic_bond_fraction"), s->x0, s->y0, s->step, s->step,
                                         s->nx, s->ny, s->plastic_fraction, 0, 0, NULL, 0));
  for (k = 0; fine && k < s->nodes; ++k) {
    s->move_x[k] = xy[2 * k] - s->ground_x[k];
    s->move_y[k] = xy[2 * k + 1] - s->ground_y[k];
  }
  free(xy);
  s->unbalanced = slope_number(s, "unbalanced_force_ratio");
  s->largest = slope_number(s, "max_displacement");
  return fine;
}

static int make_raster(slope_model* s, vbgpd_profile* profile) {
  double *xy, x1, y1;
  int64_t n = 0, k;
  if (vbgpd_profile_polygon(profile, VBGPD_OBJECT_PROFILE, 0, NULL, 16, 0, &n) != VBGPD_OK) return 0;
  xy = malloc((size_t)n * 2 * sizeof(double));
  if (xy == NULL) return 0;
  if (vbgpd_profile_polygon(profile, VBGPD_OBJECT_PROFILE, 0, xy, 16, n, &n) != VBGPD_OK) return free(xy), 0;
  s->x0 = x1 = xy[0], s->y0 = y1 = xy[1];
  for (k = 1; k < n; ++k) {
    s->x0 = fmin(s->x0, xy[2 * k]), x1 = fmax(x1, xy[2 * k]);
    s->y0 = fmin(s->y0, xy[2 * k + 1]), y1 = fmax(y1, xy[2 * k + 1]);
  }
  free(xy);
  vbgpd_profile_get_f64(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", VBGPD_STRLEN, &s->step);
  s->nx = (int)ceil((x1 - s->x0) / s->step - 1e-9) + 1;
  s->ny = (int)ceil((y1 - s->y0) / s->step - 1e-9) + 1;
  s->pore_pressure = calloc((size_t)s->nx * (size_t)s->ny, sizeof(double));
  s->plastic_fraction = calloc((size_t)s->nx * (size_t)s->ny, sizeof(double));
  return s->pore_pressure != NULL && s->plastic_fraction != NULL;
}

static int make_ground(slope_model* s) {
  double* xy;
  int64_t n = 0;
  int k;
  if (!done(s, vbgpd_model_ground_surface(s->model, NULL, 16, 0, &n))) return 0;
  s->nodes = (int)n;
  xy = malloc((size_t)n * 2 * sizeof(double));
  s->ground_x = calloc((size_t)n, sizeof(double)), s->ground_y = calloc((size_t)n, sizeof(double));
  s->move_x = calloc((size_t)n, sizeof(double)), s->move_y = calloc((size_t)n, sizeof(double));
  if (!xy || !s->ground_x || !s->ground_y || !s->move_x || !s->move_y) return 0;
  if (!done(s, vbgpd_model_ground_surface(s->model, xy, 16, n, &n))) return 0;
  for (k = 0; k < s->nodes; ++k) s->ground_x[k] = xy[2 * k], s->ground_y[k] = xy[2 * k + 1];
  free(xy);
  return 1;
}

static char* read_file(const char* path, long* size) {
  FILE* file = fopen(path, "rb");
  char* bytes = NULL;
  if (file == NULL) return NULL;
  if (fseek(file, 0, SEEK_END) == 0 && (*size = ftell(file)) >= 0 && fseek(file, 0, SEEK_SET) == 0) {
    bytes = malloc((size_t)*size + 1);
    if (bytes != NULL && fread(bytes, 1, (size_t)*size, file) != (size_t)*size) free(bytes), bytes = NULL;
  }
  fclose(file);
  return bytes;
}

slope_model* slope_open(const char* scene_file, char* error) {
  slope_model* s = calloc(1, sizeof *s);
  vbgpd_profile* profile = NULL;
  long size = 0;
  char* bytes = read_file(scene_file, &size);
  int fine = s != NULL && bytes != NULL && vbgpd_context_create(NULL, &s->context) == VBGPD_OK;
  if (fine && (vbgpd_profile_create_from_flatbuffer(s->context, bytes, size, &profile) < 0 ||
               vbgpd_model_create(s->context, profile, &s->model) < 0)) {
    vbgpd_context_error(s->context, NULL, error, error_size, NULL);
    fine = 0;
  } else if (!fine) {
    snprintf(error, error_size, "%s cannot be read", scene_file);
  }
  if (fine) {
    fine = make_raster(s, profile) && make_ground(s) && refresh(s);
    if (!fine) snprintf(error, error_size, "not enough memory for the exchange arrays");
    s->kh = slope_number(s, "kh");
  }
  vbgpd_profile_destroy(profile);
  free(bytes);
  if (fine) return s;
  if (s != NULL) slope_close(s);
  return NULL;
}

void slope_close(slope_model* s) {
  vbgpd_model_destroy(s->model);
  vbgpd_context_destroy(s->context);
  free(s->pore_pressure), free(s->plastic_fraction);
  free(s->ground_x), free(s->ground_y), free(s->move_x), free(s->move_y);
  free(s->saved);
  free(s);
}

int slope_advance(slope_model* s, double time) {
  if (s->pore_pressure_is_new && !done(s, vbgpd_model_write_grid(s->model, field_of("pore_pressure"), s->x0, s->y0,
                                                                 s->step, s->step, s->nx, s->ny, s->pore_pressure, 0)))
    return 0;
  s->pore_pressure_is_new = 0;
  return done(s, vbgpd_model_set_f64(s->model, "kh", VBGPD_STRLEN, s->kh)) &&
         done(s, vbgpd_model_advance_to(s->model, time, 0, NULL, NULL, NULL)) && refresh(s);
}

static size_t raster_bytes(const slope_model* s) { return (size_t)s->nx * (size_t)s->ny * sizeof(double); }

/* size of the checkpoint, checkpoint, pressures last set, whether they wait for the next advance */
int slope_save(slope_model* s) {
  int64_t size = 0;
  char* next;
  if (!done(s, vbgpd_model_checkpoint(s->model, NULL, 0, &size))) return 0;
  free(s->saved);
  s->saved_size = (uint64_t)size + 8 + raster_bytes(s) + sizeof s->pore_pressure_is_new;
  s->saved = s->saved_size <= INT_MAX ? malloc((size_t)s->saved_size) : NULL; /* BMI counts bytes in int */
  if (s->saved == NULL) return s->saved_size = 0, 0;
  memcpy(s->saved, &size, 8);
  if (!done(s, vbgpd_model_checkpoint(s->model, s->saved + 8, size, &size))) return 0;
  next = s->saved + 8 + size;
  memcpy(next, s->pore_pressure, raster_bytes(s));
  memcpy(next + raster_bytes(s), &s->pore_pressure_is_new, sizeof s->pore_pressure_is_new);
  return 1;
}

int slope_restore(slope_model* s, const char* saved) {
  const char* next;
  int64_t size;
  memcpy(&size, saved, 8);
  if (!done(s, vbgpd_model_restore_checkpoint(s->model, saved + 8, size))) return 0;
  next = saved + 8 + size;
  memcpy(s->pore_pressure, next, raster_bytes(s));
  memcpy(&s->pore_pressure_is_new, next + raster_bytes(s), sizeof s->pore_pressure_is_new);
  s->kh = slope_number(s, "kh");
  return refresh(s);
}
