/* Setting a model from outside while it runs: pore pressure, forces, loads, coefficients, moved boundaries, reactions.
 */
#include "slope.h"

static const double water = 10e3; /* N/m3 */

/* 10 m x 10 m of soil of 20 kN/m3 on a fixed base between rollers; elastic, or too strong to yield. */
static vbgpd_profile* make_block(vbgpd_context* context) {
  static const double square[] = {0, 0, 10, 0, 10, 10, 0, 10};
  vbgpd_profile* profile = NULL;
  CHECK_OK(vbgpd_profile_create(context, &profile));
  CHECK_OK(vbgpd_profile_set_exterior(profile, square, 16, 4));
  CHECK_OK(vbgpd_profile_add_material(profile, "rock", VBGPD_STRLEN, NULL));
  CHECK_OK(vbgpd_profile_set_text(profile, VBGPD_OBJECT_MATERIAL, 0, "law", 3, "elastic", 7));
  set_number(profile, VBGPD_OBJECT_MATERIAL, 0, "unit_weight", 20e3);
  CHECK_OK(vbgpd_profile_add_layer(profile, NULL, 16, 0, 0, NULL));
  set_number(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", 1);
  return profile;
}

static vbgpd_model* block_model(vbgpd_context* context) {
  vbgpd_profile* profile = make_block(context);
  vbgpd_model* model = NULL;
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  CHECK_OK(vbgpd_profile_destroy(profile));
  return model;
}

static int32_t field_of(const char* name) {
  int32_t field = -1;
  CHECK_OK(vbgpd_field_find(name, VBGPD_STRLEN, &field));
  return field;
}

static void settle(vbgpd_model* model) {
  vbgpd_job* job = NULL;
  CHECK_OK(vbgpd_job_create_equilibrium(model, &job));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_job_destroy(job));
}

/* Water up to y = 10, from a raster of four corners. */
static void fill_with_water(vbgpd_model* model) {
  const double corners[4] = {10 * water, 10 * water, 0, 0};
  CHECK_OK(vbgpd_model_write_grid(model, field_of("pore_pressure"), 0, 0, 10, 10, 2, 2, corners, 0));
}

static void column_stress(const vbgpd_model* model, double y, double* vertical) {
  double stress[4];
  CHECK_OK(vbgpd_model_sample_line(model, field_of("stress"), 5, y, 5, y, 1, stress, 0, 0, NULL, 0));
  *vertical = stress[1];
}

static void reactions_bear_the_weight(const vbgpd_model* model) {
  double x = 0, y = 0, base = 0;
  int64_t side;
  for (side = 0; side < 3; ++side) {
    double fx = 0, fy = 0;
    CHECK_OK(vbgpd_model_boundary_reaction(model, side, &fx, &fy));
    x += fx, y += fy;
    if (side == 0) base = fy;
  }
  CHECK(fabs(x) < 1e-6 * y && fabs(y - 20e3 * 100) < 1e-5 * y && fabs(base - y) < 2e-3 * y);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_boundary_reaction(model, 3, &x, &y));
}

/* Cells of any size. */
static void reactions_on_other_lattices(vbgpd_context* context) {
  static const double spacings[] = {0.7, 1.3};
  int i;
  for (i = 0; i < 2; ++i) {
    vbgpd_profile* profile = make_block(context);
    vbgpd_model* model = NULL;
    double fx = 0, fy = 0, borne = 0;
    int64_t side;
    set_number(profile, VBGPD_OBJECT_PROFILE, 0, "spacing", spacings[i]);
    CHECK_OK(vbgpd_model_create(context, profile, &model));
    settle(model);
    for (side = 0; side < 3; ++side, borne += fy) CHECK_OK(vbgpd_model_boundary_reaction(model, side, &fx, &fy));
    CHECK(fabs(borne - 20e3 * 100) < 1e-5 * borne);
    CHECK_OK(vbgpd_profile_destroy(profile));
    CHECK_OK(vbgpd_model_destroy(model));
  }
}

/* Bonds carry effective stress: in the middle of a soaked column the buoyant weight above. */
static void water_carries_its_share(vbgpd_context* context) {
  vbgpd_model *dry = block_model(context), *wet = block_model(context);
  double dry_stress, wet_stress, pressure;
  int64_t inside;
  settle(dry);
  fill_with_water(wet);
  settle(wet);
  column_stress(dry, 5, &dry_stress);
  column_stress(wet, 5, &wet_stress);
  CHECK(fabs(dry_stress + 20e3 * 5) < 0.02 * 20e3 * 5);
  CHECK(fabs(wet_stress + (20e3 - water) * 5) < 0.02 * 20e3 * 5);
  CHECK_OK(vbgpd_model_sample_line(wet, field_of("pore_pressure"), 5, 2.5, 5, 2.5, 1, &pressure, 0, 0, &inside, 0));
  CHECK(inside == 1 && fabs(pressure - 7.5 * water) < 0.02 * water); /* the place settled by millimetres */
  reactions_bear_the_weight(dry);
  reactions_bear_the_weight(wet); /* total stress does */
  CHECK_OK(vbgpd_model_destroy(dry));
  CHECK_OK(vbgpd_model_destroy(wet));
}

/* A pressure that is the same everywhere moves nothing inside; taken back, nothing is left of it. */
static void pressure_taken_back(vbgpd_context* context) {
  vbgpd_model *a = block_model(context), *b = block_model(context);
  const double xy[2] = {5, 5}, none = 0;
  uint64_t hash_a = 0, hash_b = 1;
  fill_with_water(a);
  CHECK_OK(vbgpd_model_write_points(a, field_of("pore_pressure"), xy, 16, &none, 0, 0, 1));
  CHECK_OK(vbgpd_model_step(a, 20, NULL));
  CHECK_OK(vbgpd_model_step(b, 20, NULL));
  CHECK_OK(vbgpd_model_state_hash(a, &hash_a));
  CHECK_OK(vbgpd_model_state_hash(b, &hash_b));
  CHECK(hash_a == hash_b);
  CHECK_OK(vbgpd_model_destroy(a));
  CHECK_OK(vbgpd_model_destroy(b));
}

/* An upward force as large as the weight on every particle leaves the slope floating. */
static void external_force_is_added(vbgpd_context* context) {
  vbgpd_model* model = block_model(context);
  int64_t n, i;
  double *force, *mass;
  CHECK_OK(vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, &n));
  force = (double*)calloc((size_t)(2 * n), sizeof(double));
  mass = (double*)calloc((size_t)n, sizeof(double));
  CHECK_OK(vbgpd_model_read_f64(model, field_of("mass"), mass, 0, 0, n, NULL));
  for (i = 0; i < n; ++i) force[2 * i + 1] = mass[i] * 9.81;
  CHECK_OK(vbgpd_model_write_f64(model, field_of("external_force"), NULL, force, 0, 0, n));
  CHECK_OK(vbgpd_model_step(model, 50, NULL));
  CHECK(model_number(model, "max_displacement") < 1e-12);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_write_f64(model, field_of("external_force"), NULL, force, 0, 0, n - 1));
  force[7] = NAN;
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_write_f64(model, field_of("external_force"), NULL, force, 0, 0, n));
  {
    vbgpd_error_info info;
    info.struct_size = sizeof info;
    CHECK_OK(vbgpd_model_error(model, &info, NULL, 0, NULL));
    CHECK(info.item == 3);
  }
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_model_write_f64(model, field_of("displacement"), NULL, force, 0, 0, n));
  free(force);
  free(mass);
  CHECK_OK(vbgpd_model_destroy(model));
}

/* Loads and coefficients set while it runs do what those of a profile do. */
static void driven_as_by_the_profile(vbgpd_context* context) {
  vbgpd_profile* profile = make_block(context);
  vbgpd_model *early = NULL, *late = NULL;
  uint64_t hash_early = 0, hash_late = 1;
  CHECK_OK(vbgpd_profile_add_load(profile, 2, 8, 0, 0, NULL));
  CHECK_OK(vbgpd_model_create(context, profile, &late));
  set_number(profile, VBGPD_OBJECT_LOAD, 0, "pressure", 30e3);
  set_number(profile, VBGPD_OBJECT_LOAD, 0, "pressure_end", 60e3);
  set_number(profile, VBGPD_OBJECT_PROFILE, 0, "kh", -0.1);
  CHECK_OK(vbgpd_model_create(context, profile, &early));
  CHECK_OK(vbgpd_model_set_load(late, 0, 30e3, 60e3));
  CHECK_OK(vbgpd_model_set_f64(late, "kh", VBGPD_STRLEN, -0.1));
  CHECK(model_number(late, "kh") == -0.1);
  CHECK_OK(vbgpd_model_step(early, 30, NULL));
  CHECK_OK(vbgpd_model_step(late, 30, NULL));
  CHECK_OK(vbgpd_model_state_hash(early, &hash_early));
  CHECK_OK(vbgpd_model_state_hash(late, &hash_late));
  CHECK(hash_early == hash_late);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_set_load(late, 1, 0, 0));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_set_load(late, 0, INFINITY, 0));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_set_f64(late, "kv", VBGPD_STRLEN, 1));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_model_destroy(early));
  CHECK_OK(vbgpd_model_destroy(late));
}

/* A wall pushed into the soil at constant speed is pushed back. */
static void moved_wall(vbgpd_context* context) {
  vbgpd_profile* profile = make_block(context);
  vbgpd_model* model = NULL;
  double fx = 0, fy = 0, before = 0;
  CHECK_OK(vbgpd_profile_add_boundary(profile, "base", 4, NULL, 16, 0, VBGPD_BOUNDARY_FIXED, NULL));
  CHECK_OK(vbgpd_profile_add_boundary(profile, "left", 4, NULL, 16, 0, VBGPD_BOUNDARY_VELOCITY, NULL));
  CHECK_OK(vbgpd_profile_add_boundary(profile, "right", 5, NULL, 16, 0, VBGPD_BOUNDARY_ROLLER, NULL));
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  settle(model);
  CHECK_OK(vbgpd_model_boundary_reaction(model, 1, &before, &fy));
  CHECK_OK(vbgpd_model_set_boundary_velocity(model, 1, 0.01, 0));
  CHECK_OK(vbgpd_model_set_f64(model, "damping", VBGPD_STRLEN, 0.5));
  CHECK_OK(vbgpd_model_advance_to(model, 0.2, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_model_boundary_reaction(model, 1, &fx, &fy));
  /* 2 mm over 10 m of E = 100 MPa over a height of 10 m: at least 0.15 MN more than before */
  CHECK(fx > before + 0.15e6 && fx < before + 0.4e6);
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_model_set_boundary_velocity(model, 0, 0.01, 0));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_set_boundary_velocity(model, 9, 0.01, 0));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_model_destroy(model));
}

/* A raster without a value somewhere leaves what it has no value for. */
static void raster_with_gaps(vbgpd_context* context) {
  vbgpd_model* model = block_model(context);
  const double half[6] = {5, NAN, NAN, 5, NAN, NAN};
  double value[2];
  CHECK_OK(vbgpd_model_write_grid(model, field_of("pore_pressure"), 0, 0, 10, 10, 1, 1, half, 0));
  CHECK_OK(vbgpd_model_sample_line(model, field_of("pore_pressure"), 2, 2, 8, 8, 2, value, 0, 0, NULL, 0));
  CHECK(fabs(value[0] - 5) < 1e-9 && fabs(value[1] - 5) < 1e-9);
  CHECK_OK(vbgpd_model_write_grid(model, field_of("pore_pressure"), 0, 0, 6, 10, 3, 2, half, 0));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_write_grid(model, field_of("velocity"), 0, 0, 6, 10, 3, 2, half, 0));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_write_grid(model, field_of("pore_pressure"), 0, 0, 0, 10, 3, 2, half, 0));
  CHECK_OK(vbgpd_model_destroy(model));
}

static void refused_at(vbgpd_model* model, vbgpd_status status, int32_t argument, int64_t item, const char* part) {
  vbgpd_error_info info;
  char text[400];
  info.struct_size = sizeof info;
  CHECK(status == VBGPD_E_RANGE);
  CHECK_OK(vbgpd_model_error(model, &info, text, sizeof text, NULL));
  CHECK(info.status == status && info.argument == argument && info.item == item);
  CHECK_CONTAINS(text, part);
}

/* As the caller numbers them, not by the particle that would have got a value from there. */
static void bad_values_are_named_by_their_place(vbgpd_context* context) {
  vbgpd_model* model = block_model(context);
  const int32_t pressure = field_of("pore_pressure");
  double xy[8] = {0, 0, 10, 0, 10, 10, 0, 10}, at[4] = {1, 2, NAN, 4};
  refused_at(model, vbgpd_model_write_points(model, pressure, xy, 16, at, 0, 0, 4), 5, 2, "place 2 is not a finite");
  at[2] = NAN, at[3] = INFINITY; /* no value at 2 is no fault of a raster */
  refused_at(model, vbgpd_model_write_grid(model, pressure, 0, 0, 10, 10, 2, 2, at, 0), 9, 3,
             "place 3 is not a finite");
  at[2] = at[3] = 5, xy[3] = 1e200;
  refused_at(model, vbgpd_model_write_points(model, pressure, xy, 16, at, 0, 0, 4), 3, 1, "Place 1 is at (10, 1e+200)");
  refused_at(model, vbgpd_model_write_grid(model, pressure, 1e200, 0, 1, 1, 2, 2, at, 0), 3, -1, "1e+12");
  CHECK_OK(vbgpd_model_destroy(model));
}

/* Energies of these are no numbers that a checkpoint could hold. */
static void velocities_beyond_all_bounds_are_refused(vbgpd_context* context) {
  vbgpd_model *model = block_model(context), *runout = NULL;
  vbgpd_model* both[2];
  double velocity[2] = {0, -1e148};
  const int64_t id = 3;
  vbgpd_selection one;
  int k;
  memset(&one, 0, sizeof one);
  one.struct_size = sizeof one, one.kind = VBGPD_SELECT_IDS, one.ids = &id, one.n_ids = 1;
  CHECK_OK(vbgpd_model_create_runout(model, &runout));
  both[0] = model, both[1] = runout;
  for (k = 0; k < 2; ++k) {
    const int32_t field = field_of("velocity");
    velocity[1] = -1e148;
    refused_at(both[k], vbgpd_model_write_f64(both[k], field, &one, velocity, 0, 0, 1), 0, 3,
               "velocity of particle 3 is -1e+148 m/s; it must be between -1e+09 and 1e+09 m/s");
    CHECK(model_number(both[k], "external_work") == 0 && model_number(both[k], "kinetic_energy") == 0);
    velocity[1] = -1e9;
    CHECK_OK(vbgpd_model_write_f64(both[k], field, &one, velocity, 0, 0, 1));
  }
  CHECK_OK(vbgpd_model_destroy(runout));
  CHECK_OK(vbgpd_model_destroy(model));
}

/* The factor of safety counts water in, on both grids. */
static void water_lowers_the_factor_of_safety(vbgpd_context* context) {
  double factor[2];
  int soaked;
  for (soaked = 0; soaked < 2; ++soaked) {
    vbgpd_model* model = make_model(context, 1);
    vbgpd_job* job = NULL;
    if (soaked) {
      /* the pore pressure ratio 0.2 below the crest, fading to nothing at the toe's level */
      const double corners[4] = {0.2 * 20e3 * 15, 0.2 * 20e3 * 5, 0, -0.2 * 20e3 * 10};
      CHECK_OK(vbgpd_model_write_grid(model, field_of("pore_pressure"), 0, 0, 40, 15, 2, 2, corners, 0));
    }
    CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
    CHECK_OK(vbgpd_job_set_f64(job, "srf_tolerance", VBGPD_STRLEN, 0.02));
    CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
    factor[soaked] = job_number(job, "factor_of_safety");
    CHECK(job_number(job, "levels") == 2);
    CHECK_OK(vbgpd_job_destroy(job));
    CHECK_OK(vbgpd_model_destroy(model));
  }
  CHECK(factor[1] < 0.97 * factor[0]);
}

int main(void) {
  vbgpd_context* context = make_context();
  reactions_on_other_lattices(context);
  water_carries_its_share(context);
  pressure_taken_back(context);
  external_force_is_added(context);
  driven_as_by_the_profile(context);
  moved_wall(context);
  raster_with_gaps(context);
  bad_values_are_named_by_their_place(context);
  velocities_beyond_all_bounds_are_refused(context);
  water_lowers_the_factor_of_safety(context);
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
