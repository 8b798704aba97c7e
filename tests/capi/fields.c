/* Selections, sampling, the ground surface, and views on loan. */
#include "slope.h"

static int32_t field_of(const char* name) {
  int32_t field = -1;
  CHECK_OK(vbgpd_field_find(name, VBGPD_STRLEN, &field));
  return field;
}

static int64_t count_of(const vbgpd_model* model, const vbgpd_selection* selection) {
  int64_t n = -1;
  CHECK_OK(vbgpd_model_select(model, selection, NULL, 8, 0, &n));
  return n;
}

static vbgpd_selection kind_of_selection(int32_t kind) {
  vbgpd_selection s;
  memset(&s, 0, sizeof s);
  s.struct_size = sizeof s;
  s.kind = kind;
  return s;
}

/* Every particle is soil of the one material, or of one of the three boundaries. */
static void selections_part_the_particles(const vbgpd_model* model) {
  vbgpd_selection s = kind_of_selection(VBGPD_SELECT_SOIL);
  int64_t all, soil, sum = 0, i;
  CHECK_OK(vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, &all));
  CHECK(count_of(model, NULL) == all);
  soil = count_of(model, &s);
  s.kind = VBGPD_SELECT_MATERIAL;
  CHECK(count_of(model, &s) == soil);
  s.kind = VBGPD_SELECT_LAYER;
  CHECK(count_of(model, &s) == soil);
  s.kind = VBGPD_SELECT_BOUNDARY;
  for (i = 0; i < 3; ++i) {
    s.object_id = i;
    CHECK(count_of(model, &s) > 0);
    sum += count_of(model, &s);
  }
  CHECK(soil + sum == all);
  s.object_id = 3;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_select(model, &s, NULL, 8, 0, NULL));
  s.kind = 8;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_select(model, &s, NULL, 8, 0, NULL));
  s.struct_size = 4;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_select(model, &s, NULL, 8, 0, NULL));
  s.kind = VBGPD_SELECT_SOIL;
  s.struct_size = 8; /* an old caller, who knows the kind and nothing else */
  CHECK(count_of(model, &s) == soil);
}

static void polygons_and_boxes_select_the_same(const vbgpd_model* model) {
  static const double corners[] = {3, 2, 0, 21, 2, 0, 21, 9, 0, 3, 9, 0};
  static const int64_t wanted[] = {5, 0, 3};
  vbgpd_selection box = kind_of_selection(VBGPD_SELECT_BOX), polygon = kind_of_selection(VBGPD_SELECT_POLYGON);
  vbgpd_selection ids = kind_of_selection(VBGPD_SELECT_IDS);
  int64_t of_box[2000], of_polygon[2000], n = 0, m = 0, i, read_ids[3];
  double xy[4000], values[3], all[8000];
  box.xmin = 3, box.ymin = 2, box.xmax = 21, box.ymax = 9;
  polygon.xy = corners, polygon.xy_stride = 24, polygon.n_points = 4;
  CHECK_OK(vbgpd_model_select(model, &box, of_box, 8, 2000, &n));
  CHECK_OK(vbgpd_model_select(model, &polygon, of_polygon, 8, 2000, &m));
  CHECK(n > 100 && n == m && memcmp(of_box, of_polygon, (size_t)n * 8) == 0);
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_model_select(model, &box, of_box, 8, n - 1, &n));
  CHECK_OK(vbgpd_model_read_selected_f64(model, field_of("position"), &box, xy, 0, 0, 2000, &m));
  CHECK(n == m);
  for (i = 0; i < n; ++i) CHECK(xy[2 * i] >= 3 && xy[2 * i] <= 21 && xy[2 * i + 1] >= 2 && xy[2 * i + 1] <= 9);
  ids.ids = wanted, ids.ids_stride = 8, ids.n_ids = 3;
  CHECK_OK(vbgpd_model_read_selected_i64(model, field_of("particle_id"), &ids, read_ids, 0, 0, 3, NULL));
  CHECK(memcmp(read_ids, wanted, sizeof wanted) == 0);
  CHECK_OK(vbgpd_model_read_f64(model, field_of("volume"), all, 0, 0, 8000, NULL));
  CHECK_OK(vbgpd_model_read_selected_f64(model, field_of("volume"), &ids, values, 0, 0, 3, NULL));
  CHECK(values[0] == all[5] && values[1] == all[0] && values[2] == all[3]);
  CHECK_STATUS(VBGPD_E_ARGUMENT,
               vbgpd_model_read_selected_f64(model, field_of("bond_stress"), &ids, values, 0, 0, 3, NULL));
  ids.n_ids = -1;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_select(model, &ids, of_box, 8, 2000, &n));
}

/* The reference position is a linear field: sampled in the undeformed slope it says where it was asked. */
static void sampling_is_exact_for_linear_fields(const vbgpd_model* model) {
  static const double xy[] = {0.1, 0.1, 20, 7, 14.9, 14.9, 39.9, 4.9, 20, 12, -1, 5, 39, 5.1, 1e9, 1e9};
  static const int64_t expected[] = {1, 1, 1, 1, 0, 0, 0, 0};
  double values[2 * 8], line[2 * 5], grid[2 * 12], wide[12];
  int64_t inside[8], i, marks[12];
  const int32_t field = field_of("reference_position");
  CHECK_OK(vbgpd_model_sample_points(model, field, xy, 16, 8, values, 0, 0, inside, 0));
  for (i = 0; i < 8; ++i) {
    CHECK(inside[i] == expected[i]);
    if (inside[i]) CHECK(fabs(values[2 * i] - xy[2 * i]) < 1e-9 && fabs(values[2 * i + 1] - xy[2 * i + 1]) < 1e-9);
    else CHECK(isnan(values[2 * i]) && isnan(values[2 * i + 1]));
  }
  CHECK_OK(vbgpd_model_sample_line(model, field, 2, 1, 10, 9, 5, line, 0, 0, NULL, 0));
  for (i = 0; i < 5; ++i) CHECK(fabs(line[2 * i] - 2 - 2 * (double)i) < 1e-9);
  CHECK_OK(vbgpd_model_sample_grid(model, field, 1, 2, 3, 4, 4, 3, grid, 0, 0, marks, 0));
  for (i = 0; i < 12; ++i) {
    CHECK(marks[i] == 1);
    CHECK(fabs(grid[2 * i] - (double)(1 + 3 * (i % 4))) < 1e-9 &&
          fabs(grid[2 * i + 1] - (double)(2 + 4 * (i / 4))) < 1e-9);
  }
  for (i = 0; i < 12; ++i) wide[i] = -77;
  CHECK_OK(vbgpd_model_sample_points(model, field, xy, 16, 2, wide, 48, 16, NULL, 0));
  for (i = 0; i < 12; ++i) CHECK((wide[i] != -77) == (i == 0 || i == 2 || i == 6 || i == 8));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_sample_points(model, field, xy, 16, 2, wide, 4, 4, NULL, 0));
  CHECK_STATUS(VBGPD_E_ARGUMENT,
               vbgpd_model_sample_points(model, field_of("material"), xy, 16, 1, wide, 0, 0, NULL, 0));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_sample_line(model, field, 0, 0, 1, 1, -1, wide, 0, 0, NULL, 0));
}

static void ground_follows_the_soil(vbgpd_model* model) {
  double before[400], after[400];
  int64_t n = 0, m = 0, i;
  double lowest = 0;
  CHECK_OK(vbgpd_model_ground_surface(model, before, 16, 200, &n));
  CHECK(n > 30 && n < 200);
  CHECK(before[0] == 0 && before[1] == 15 && before[2 * n - 2] == 40 && before[2 * n - 1] == 5);
  CHECK_OK(vbgpd_model_advance_to(model, 0.3, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_model_ground_surface(model, after, 16, 200, &m));
  CHECK(m == n);
  for (i = 0; i < n; ++i) lowest = fmin(lowest, after[2 * i + 1] - before[2 * i + 1]);
  CHECK(lowest < -1e-3 && -lowest <= 1.2 * model_number(model, "max_displacement"));
}

static void views_hold_the_model_still(vbgpd_model* model) {
  double seconds;
  vbgpd_view u, ids;
  int64_t n, i, seen = 0;
  double* copy;
  const char* at;
  u.struct_size = sizeof u, ids.struct_size = sizeof ids;
  CHECK_OK(vbgpd_model_view_acquire(model, field_of("displacement"), &u));
  CHECK_OK(vbgpd_model_view_acquire(model, field_of("particle_id"), &ids));
  CHECK(u.count == ids.count && u.components == 2 && ids.components == 1 && u.lease != ids.lease);
  CHECK_OK(vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, &n));
  copy = (double*)malloc((size_t)(2 * n) * sizeof(double));
  CHECK_OK(vbgpd_model_read_f64(model, field_of("displacement"), copy, 0, 0, n, NULL));
  at = (const char*)u.data;
  for (i = 0; i < u.count; ++i) {
    int64_t id, c;
    memcpy(&id, (const char*)ids.data + i * ids.stride_item, 8);
    if (id < 0) continue;
    ++seen;
    for (c = 0; c < 2; ++c)
      CHECK(memcmp(at + i * u.stride_item + c * u.stride_component, copy + 2 * id + c, sizeof(double)) == 0);
  }
  CHECK(seen == n);
  free(copy);
  CHECK_STATUS(VBGPD_E_LEASED, vbgpd_model_step(model, 1, NULL));
  CHECK_STATUS(VBGPD_E_LEASED, vbgpd_model_set_f64(model, "damping", VBGPD_STRLEN, 0.1));
  CHECK_STATUS(VBGPD_E_LEASED, vbgpd_model_get_f64(model, "forecast_seconds", VBGPD_STRLEN, &seconds));
  CHECK_OK(vbgpd_model_view_release(model, u.lease));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_view_release(model, u.lease));
  CHECK_STATUS(VBGPD_E_LEASED, vbgpd_model_advance_to(model, 1, 0, NULL, NULL, NULL));
  {
    vbgpd_job* job = NULL;
    CHECK_OK(vbgpd_job_create_equilibrium(model, &job));
    CHECK_STATUS(VBGPD_E_LEASED, vbgpd_job_run(job, 0, NULL, NULL, NULL));
    CHECK_OK(vbgpd_job_destroy(job));
  }
  CHECK_OK(vbgpd_model_view_release(model, ids.lease));
  CHECK_OK(vbgpd_model_step(model, 1, NULL));
  CHECK_STATUS(VBGPD_E_UNSUPPORTED, vbgpd_model_view_acquire(model, field_of("stress"), &u));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_view_acquire(model, 1000, &u));
}

/* The end of a model is the end of its leases: a job that outlives it can run. */
static void leases_end_with_their_model(vbgpd_model* model) {
  vbgpd_job* job = NULL;
  vbgpd_view u;
  u.struct_size = sizeof u;
  CHECK_OK(vbgpd_job_create_equilibrium(model, &job));
  CHECK_OK(vbgpd_model_view_acquire(model, field_of("velocity"), &u));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_job_destroy(job));
}

int main(void) {
  vbgpd_context* context = make_context();
  vbgpd_model* model = make_model(context, 1);
  selections_part_the_particles(model);
  polygons_and_boxes_select_the_same(model);
  sampling_is_exact_for_linear_fields(model);
  ground_follows_the_soil(model);
  views_hold_the_model_still(model);
  leases_end_with_their_model(model);
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
