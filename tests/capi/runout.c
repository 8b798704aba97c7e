/* A slope failed by its strength reduction factor runs out through the C face: hand-over, job, ground, refusals; and
 * everything a partner does with a model while it moves. */
#include "slope.h"

static void refusals(vbgpd_model* at_rest, vbgpd_model* moving) {
  vbgpd_job* job = NULL;
  vbgpd_model* model = NULL;
  double value = 0;
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_job_create_runout(at_rest, &job));
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_job_create_strength_reduction(moving, &job));
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_job_create_equilibrium(moving, &job));
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_model_create_runout(moving, &model));
  CHECK(job == NULL && model == NULL);
  /* numbers of the model at rest that a run-out has no use for are refused, not swallowed */
  CHECK_STATUS(VBGPD_E_UNSUPPORTED, vbgpd_model_set_f64(moving, "time_step_factor", VBGPD_STRLEN, 0.5));
  CHECK_STATUS(VBGPD_E_UNSUPPORTED, vbgpd_model_get_f64(moving, "time_step_factor", VBGPD_STRLEN, &value));
  CHECK_STATUS(VBGPD_E_UNSUPPORTED, vbgpd_model_get_f64(moving, "forecast_steps", VBGPD_STRLEN, &value));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_set_f64(moving, "damping", VBGPD_STRLEN, 2));
  CHECK_STATUS(VBGPD_E_UNSUPPORTED, vbgpd_model_set_layer_active(moving, 0, 0));
}

static void ground_of(const vbgpd_model* model, double* lowest, double* highest) {
  double xy[200];
  int64_t n = 0, i;
  CHECK_OK(vbgpd_model_ground_surface(model, NULL, 16, 0, &n));
  CHECK(n > 5 && n < 100);
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_model_ground_surface(model, xy, 16, n - 1, &n));
  CHECK_OK(vbgpd_model_ground_surface(model, xy, 16, 100, &n));
  *lowest = *highest = xy[1];
  for (i = 1; i < n; ++i) {
    CHECK(xy[2 * i] > xy[2 * i - 2]);
    if (xy[2 * i + 1] < *lowest) *lowest = xy[2 * i + 1];
    if (xy[2 * i + 1] > *highest) *highest = xy[2 * i + 1];
  }
}

static int32_t field_of(const char* name) {
  int32_t field = -1;
  CHECK_OK(vbgpd_field_find(name, VBGPD_STRLEN, &field));
  return field;
}

static uint64_t hash_of(const vbgpd_model* model) {
  uint64_t hash = 0;
  CHECK_OK(vbgpd_model_state_hash(model, &hash));
  return hash;
}

static double* doubles_of(const vbgpd_model* model, const char* name, int components, int64_t* n) {
  double* values;
  CHECK_OK(vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, n));
  values = (double*)calloc((size_t)(components * *n), sizeof(double));
  CHECK_OK(vbgpd_model_read_f64(model, field_of(name), values, 0, 0, *n, NULL));
  return values;
}

/* With a strip load of 10 kPa on 6 m of the crest, failed. */
static vbgpd_model* sliding_model(vbgpd_context* context) {
  vbgpd_profile* profile = make_profile(context, 1);
  vbgpd_model *at_rest = NULL, *moving = NULL;
  CHECK_OK(vbgpd_profile_add_load(profile, 2, 8, 10e3, 10e3, NULL));
  CHECK_OK(vbgpd_model_create(context, profile, &at_rest));
  CHECK_OK(vbgpd_model_set_f64(at_rest, "strength_reduction_factor", VBGPD_STRLEN, 3));
  CHECK_OK(vbgpd_model_create_runout(at_rest, &moving));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_model_destroy(at_rest));
  return moving;
}

static void ends_exactly_at_its_time_in_any_slices(vbgpd_context* context) {
  vbgpd_model *whole = sliding_model(context), *sliced = sliding_model(context);
  const double time = 0.7319;
  vbgpd_advance_result r;
  const clock_t start = clock();
  double slice;
  vbgpd_status s;
  int slices = 0;
  r.struct_size = sizeof r;
  CHECK_OK(vbgpd_model_advance_to(whole, time, 0, NULL, NULL, &r));
  slice = a_tenth_since(start);
  CHECK(r.time == time && model_number(whole, "time") == time);
  while ((s = vbgpd_model_advance_to(sliced, time, slice, NULL, NULL, NULL)) == VBGPD_LIMIT_REACHED) ++slices;
  CHECK_STATUS(VBGPD_OK, s);
  CHECK(slices > 1 && hash_of(whole) == hash_of(sliced));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_advance_to(whole, 0.5, 0, NULL, NULL, NULL));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_advance_to(whole, INFINITY, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_model_cancel(whole));
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_model_advance_to(whole, 2, 0, NULL, NULL, NULL));
  CHECK(model_number(whole, "time") == time);
  CHECK_OK(vbgpd_model_destroy(whole));
  CHECK_OK(vbgpd_model_destroy(sliced));
}

/* Reactions of all boundaries, weight, load and what pushes from outside are mass times acceleration of the next step.
 */
static void forces_balance(vbgpd_model* model, double load, double push_x, double push_y) {
  const double kh = model_number(model, "kh"), kv = model_number(model, "kv");
  double x = push_x, y = push_y - load, weight = 0, *mass, *before, *after;
  int64_t n, i, side;
  vbgpd_advance_result r;
  r.struct_size = sizeof r;
  mass = doubles_of(model, "mass", 1, &n);
  before = doubles_of(model, "velocity", 2, &n);
  for (side = 0; side < 3; ++side) {
    double fx = 0, fy = 0;
    CHECK_OK(vbgpd_model_boundary_reaction(model, side, &fx, &fy));
    if (side > 0) CHECK(fabs(fy) <= 1e-6 * fabs(fx)); /* rollers bear nothing along themselves */
    x += fx, y += fy;
  }
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_boundary_reaction(model, 3, &x, &y));
  CHECK_OK(vbgpd_model_step(model, 1, &r));
  after = doubles_of(model, "velocity", 2, &n);
  for (i = 0; i < n; ++i) {
    const double step = model_number(model, "time_step");
    weight += mass[i] * 9.81;
    x += mass[i] * (9.81 * kh - (after[2 * i] - before[2 * i]) / step);
    y += mass[i] * (-9.81 * (1 + kv) - (after[2 * i + 1] - before[2 * i + 1]) / step);
  }
  CHECK(fabs(x) < 1e-9 * weight && fabs(y) < 1e-9 * weight);
  free(mass);
  free(before);
  free(after);
}

static void driven_while_it_moves(vbgpd_context* context) {
  vbgpd_model *moving = sliding_model(context), *calm = sliding_model(context);
  vbgpd_state* state = NULL;
  double *push, *read;
  int64_t n, i;
  uint64_t saved;
  forces_balance(moving, 60e3, 0, 0);
  CHECK_OK(vbgpd_model_advance_to(moving, 0.5, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_model_advance_to(calm, 0.5, 0, NULL, NULL, NULL));
  forces_balance(moving, 60e3, 0, 0);
  CHECK_OK(vbgpd_model_save_state(moving, &state));
  saved = hash_of(moving);
  CHECK_OK(vbgpd_model_set_f64(moving, "kh", VBGPD_STRLEN, 0.2));
  CHECK_OK(vbgpd_model_set_f64(moving, "kv", VBGPD_STRLEN, -0.1));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_set_f64(moving, "kh", VBGPD_STRLEN, 1.5));
  CHECK_OK(vbgpd_model_set_load(moving, 0, 40e3, 50e3));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_set_load(moving, 1, 0, 0));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_set_load(moving, 0, NAN, 0));
  CHECK_STATUS(VBGPD_E_STATE, vbgpd_model_set_boundary_velocity(moving, 0, 1, 0));
  push = doubles_of(moving, "external_force", 2, &n);
  for (i = 0; i < 2 * n; ++i) {
    CHECK(push[i] == 0);
    push[i] = i % 2 == 0 ? 100 : -7;
  }
  CHECK_OK(vbgpd_model_write_f64(moving, field_of("external_force"), NULL, push, 0, 0, n));
  read = doubles_of(moving, "external_force", 2, &n);
  CHECK(memcmp(read, push, (size_t)(2 * n) * sizeof(double)) == 0);
  free(read);
  forces_balance(moving, 270e3, 100.0 * (double)n, -7.0 * (double)n);
  CHECK_OK(vbgpd_model_advance_to(moving, 1, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_model_advance_to(calm, 1, 0, NULL, NULL, NULL));
  CHECK(model_number(moving, "max_velocity") > 1.02 * model_number(calm, "max_velocity"));
  CHECK(model_number(moving, "energy_residual") < 0.01);
  for (i = 0; i < n; ++i) push[i] = 1e3 + (double)i;
  CHECK_OK(vbgpd_model_write_f64(moving, field_of("pore_pressure"), NULL, push, 0, 0, n));
  read = doubles_of(moving, "pore_pressure", 1, &n);
  CHECK(memcmp(read, push, (size_t)n * sizeof(double)) == 0);
  free(read);
  push[3] = INFINITY;
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_model_write_f64(moving, field_of("external_force"), NULL, push, 0, 0, n));
  CHECK_OK(vbgpd_model_restore_state(moving, state)); /* takes coefficients, load and forces back as well */
  CHECK(hash_of(moving) == saved && model_number(moving, "kh") == 0 && model_number(moving, "kv") == 0);
  forces_balance(moving, 60e3, 0, 0);
  read = doubles_of(moving, "pore_pressure", 1, &n); /* the water goes as it came */
  for (i = 0; i < n; ++i) CHECK(read[i] == 0);
  free(read);
  free(push);
  CHECK_OK(vbgpd_state_destroy(state));
  CHECK_OK(vbgpd_model_destroy(moving));
  CHECK_OK(vbgpd_model_destroy(calm));
}

/* Views lend the arrays in the order of the last neighbour search; particle_id tells which. */
static void lends_its_arrays(vbgpd_context* context) {
  static const char* const names[4] = {"velocity", "mass", "volume", "plastic_strain"};
  vbgpd_model* moving = sliding_model(context);
  vbgpd_view ids, view;
  int64_t first, epoch, n, i;
  int k, c;
  CHECK_OK(vbgpd_model_epoch(moving, &first));
  CHECK_OK(vbgpd_model_advance_to(moving, 1, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_model_epoch(moving, &epoch));
  CHECK(epoch > first);
  ids.struct_size = view.struct_size = sizeof view;
  CHECK_OK(vbgpd_model_view_acquire(moving, field_of("particle_id"), &ids));
  CHECK(ids.type == VBGPD_TYPE_I64 && ids.epoch == epoch);
  for (k = 0; k < 4; ++k) {
    double* const copy = doubles_of(moving, names[k], k == 0 ? 2 : 1, &n);
    CHECK_OK(vbgpd_model_view_acquire(moving, field_of(names[k]), &view));
    CHECK(view.count == n && ids.count == n && view.components == (k == 0 ? 2 : 1));
    for (i = 0; i < n; ++i)
      for (c = 0; c < view.components; ++c) {
        const int64_t id = *(const int64_t*)((const char*)ids.data + i * ids.stride_item);
        const double lent = *(const double*)((const char*)view.data + i * view.stride_item + c * view.stride_component);
        CHECK(lent == copy[id * view.components + c]);
      }
    CHECK_OK(vbgpd_model_view_release(moving, view.lease));
    free(copy);
  }
  CHECK_STATUS(VBGPD_E_UNSUPPORTED, vbgpd_model_view_acquire(moving, field_of("displacement"), &view));
  CHECK_STATUS(VBGPD_E_LEASED, vbgpd_model_step(moving, 1, NULL));
  CHECK_STATUS(VBGPD_E_LEASED, vbgpd_model_set_f64(moving, "kh", VBGPD_STRLEN, 0.1));
  CHECK_OK(vbgpd_model_view_release(moving, ids.lease));
  CHECK_OK(vbgpd_model_step(moving, 1, NULL));
  CHECK_OK(vbgpd_model_destroy(moving));
}

int main(void) {
  vbgpd_context* context = make_context();
  vbgpd_model *at_rest = make_model(context, 1), *moving = NULL;
  vbgpd_job* job = NULL;
  vbgpd_advance_result advance;
  uint64_t before = 0, after = 0;
  double low, high, value = 0;
  CHECK_OK(vbgpd_model_state_hash(at_rest, &before));
  CHECK_OK(vbgpd_model_set_f64(at_rest, "strength_reduction_factor", VBGPD_STRLEN, 3));
  CHECK_OK(vbgpd_model_create_runout(at_rest, &moving));
  refusals(at_rest, moving);
  CHECK_OK(vbgpd_model_get_f64(moving, "strength_reduction_factor", VBGPD_STRLEN, &value));
  CHECK(value == 3);
  CHECK_OK(vbgpd_job_create_runout(moving, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "end_time", VBGPD_STRLEN, 1.5));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK(job_number(job, "crest_settlement") > 0.1);
  CHECK(job_number(job, "moved_area") > 1);
  CHECK(job_number(job, "plastic_fraction") > 0.2);
  CHECK(job_number(job, "energy_residual") < 0.01);
  ground_of(moving, &low, &high);
  CHECK(high > 12 && high <= 15.5 && low > 4 && low < 6);
  advance.struct_size = sizeof advance;
  CHECK(model_number(moving, "time") == 1.5);
  CHECK_OK(vbgpd_model_step(moving, 10, &advance));
  CHECK(advance.steps == 10 && advance.time > 1.5 && advance.max_displacement > 0.1);
  CHECK_OK(vbgpd_model_state_hash(at_rest, &after));
  CHECK(before == after); /* the model it came from is not changed */
  CHECK_OK(vbgpd_model_destroy(moving));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(at_rest));
  ends_exactly_at_its_time_in_any_slices(context);
  driven_while_it_moves(context);
  lends_its_arrays(context);
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
