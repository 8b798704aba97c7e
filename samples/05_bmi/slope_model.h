/* A slope behind the arrays that a BMI framework sees: they stay where they are from initialize to finalize. */
#ifndef SLOPE_MODEL_H
#define SLOPE_MODEL_H
#include <stdint.h>
#include <vbgpd/vbgpd.h>

enum { error_size = 1024 };

typedef struct {
  vbgpd_context* context;
  vbgpd_model* model;
  /* the exchange raster over the section: row j, column i at (x0 + i*step, y0 + j*step) */
  double x0, y0, step;
  int nx, ny;
  double *pore_pressure, *plastic_fraction; /* Pa in; 1 out */
  /* nodes of the ground surface */
  int nodes;
  double *ground_x, *ground_y, *move_x, *move_y; /* m: where they were, how far they went */
  double kh, unbalanced, largest;                /* in; out; out */
  int pore_pressure_is_new;
  /* a checkpoint for the framework: its length in 8 bytes, then its bytes */
  char* saved;
  uint64_t saved_size;
  char error[error_size];
} slope_model;

slope_model* slope_open(const char* scene_file, char* error);
void slope_close(slope_model*);
/* 1 = done; 0 = failed, and `error` says why. */
int slope_advance(slope_model*, double time);
int slope_save(slope_model*);
int slope_restore(slope_model*, const char* saved);
double slope_number(slope_model*, const char* name);

#endif
