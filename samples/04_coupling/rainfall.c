/* Rain raises the water in a slope until it fails: an external seepage model coupled to the engine, step by step.
 *
 * Per hour: the seepage model says where the water stands, the pore pressures go into the model, the slope is brought
 * to equilibrium. A step that ends in failure is taken back (vbgpd_model_restore_state) and tried again at half its
 * length, until the hour of failure is known to a quarter of an hour. Then the slope is let go and its ground is read
 * back. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <vbgpd/vbgpd.h>

enum { columns = 81, rows = 31, most_points = 400 };
static const double width = 40, toe_x = 25, toe_level = 5, crest_level = 15, water_weight = 9.81e3;

static void check(vbgpd_status s, const char* what) {
  if (s >= 0) return;
  fprintf(stderr, "%s: %s\n", what, vbgpd_status_name(s));
  exit(1);
}

/* The partner: unconfined flow from the hillside at x = 0 to the toe (Dupuit), fed so that the head at the hillside
 * rises by 0.25 m an hour. Pressure in Pa on a raster over the whole section; 0 above the water. */
static double water_level(double hours, double x) {
  const double head = fmin(6 + 0.25 * hours, crest_level - 0.5);
  const double along = fmin(x / toe_x, 1);
  return sqrt(head * head - (head * head - toe_level * toe_level) * along);
}

static void seepage(double hours, double* pressure) {
  int i, j;
  for (j = 0; j < rows; ++j)
    for (i = 0; i < columns; ++i) {
      const double x = width * i / (columns - 1), y = crest_level * j / (rows - 1);
      pressure[j * columns + i] = fmax(0, water_weight * (water_level(hours, x) - y));
    }
}

static vbgpd_model* make_slope(vbgpd_context* context) {
  static const double outline[] = {0, 0, 40, 0, 40, 5, 25, 5, 10, 15, 0, 15};
  static const struct {
    const char* name;
    double value;
  } soil[] = {{"unit_weight", 19e3}, {"cohesion", 6e3}, {"friction_angle", 28}, {"young_modulus", 20e6}};
  vbgpd_profile* profile = NULL;
  vbgpd_model* model = NULL;
  int i;
  check(vbgpd_profile_create(context, &profile), "profile");
  check(vbgpd_profile_set_exterior(profile, outline, 16, 6), "outline");
  check(vbgpd_profile_add_material(profile, "silty sand", VBGPD_STRLEN, NULL), "material");
  for (i = 0; i < 4; ++i)
    check(vbgpd_profile_set_f64(profile, VBGPD_OBJECT_MATERIAL, 0, soil[i].name, VBGPD_STRLEN, soil[i].value),
          soil[i].name);
  check(vbgpd_profile_add_layer(profile, NULL, 16, 0, 0, NULL), "layer");
  check(vbgpd_profile_set_f64(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", VBGPD_STRLEN, 1), "spacing");
  check(vbgpd_model_create(context, profile, &model), "model");
  check(vbgpd_profile_destroy(profile), "profile");
  return model;
}

/* VBGPD_OK: the slope stands; VBGPD_UNSTABLE: it fails. */
static vbgpd_status settle(vbgpd_model* model) {
  vbgpd_job* job = NULL;
  vbgpd_status s;
  check(vbgpd_job_create_equilibrium(model, &job), "equilibrium");
  do {
    s = vbgpd_job_run(job, 0.1, NULL, NULL, NULL); /* in slices: here a program would draw and listen to its user */
  } while (s == VBGPD_LIMIT_REACHED);
  check(s, "equilibrium");
  check(vbgpd_job_destroy(job), "equilibrium");
  return s;
}

static vbgpd_status rain_until(vbgpd_model* model, int32_t pore_pressure, double hours) {
  static double pressure[rows * columns];
  seepage(hours, pressure);
  check(vbgpd_model_write_grid(model, pore_pressure, 0, 0, width / (columns - 1), crest_level / (rows - 1), columns,
                               rows, pressure, 0),
        "pore pressure");
  return settle(model);
}

/* How far the ground above has come down and the slope forward since `before`. */
static void tell_ground(vbgpd_model* model, const double* before, int64_t n) {
  double xy[2 * most_points], down = -1, forward = 0;
  int64_t i;
  check(vbgpd_model_ground_surface(model, xy, 16, most_points, &n), "ground");
  for (i = 0; i < n; ++i) {
    if (before[2 * i] <= 10) down = fmax(down, before[2 * i + 1] - xy[2 * i + 1]);
    else forward = fmax(forward, xy[2 * i] - before[2 * i]);
  }
  printf("crest %.0f mm down, slope %.0f mm forward\n", 1e3 * down, 1e3 * forward);
}

int main(void) {
  vbgpd_context* context = NULL;
  vbgpd_model* model;
  vbgpd_state* standing = NULL;
  double ground[2 * most_points], hours = 0, step = 2;
  int64_t n = 0;
  int32_t pore_pressure = -1;
  check(vbgpd_context_create(NULL, &context), "context");
  model = make_slope(context);
  check(vbgpd_field_find("pore_pressure", VBGPD_STRLEN, &pore_pressure), "field");
  if (rain_until(model, pore_pressure, hours) != VBGPD_OK) return 1;
  check(vbgpd_model_ground_surface(model, ground, 16, most_points, &n), "ground");
  while (step >= 0.25 && hours < 48) {
    check(vbgpd_model_save_state(model, &standing), "save");
    if (rain_until(model, pore_pressure, hours + step) == VBGPD_OK) {
      hours += step;
      printf("%5.2f h: water at the hillside at %.2f m, stands; ", hours, water_level(hours, 0));
      tell_ground(model, ground, n);
    } else {
      check(vbgpd_model_restore_state(model, standing), "restore"); /* the pressures, too, are those of before */
      printf("%5.2f h: fails; back to %.2f h\n", hours + step, hours);
      step /= 2;
    }
  }
  printf("the slope fails between %.2f h and %.2f h of rain\n", hours, hours + 2 * step);
  /* let go: the failing pressures, and two seconds of motion */
  rain_until(model, pore_pressure, hours + 2 * step);
  check(vbgpd_model_set_f64(model, "damping", VBGPD_STRLEN, 0.05), "damping");
  {
    double now = 0;
    check(vbgpd_model_get_f64(model, "time", VBGPD_STRLEN, &now), "time");
    check(vbgpd_model_advance_to(model, now + 2, 0, NULL, NULL, NULL), "advance");
  }
  printf("two seconds later: ");
  tell_ground(model, ground, n);
  check(vbgpd_state_destroy(standing), "state");
  check(vbgpd_model_destroy(model), "model");
  check(vbgpd_context_destroy(context), "context");
  return 0;
}
