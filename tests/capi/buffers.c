/* R7 and strides: text and arrays in buffers of the caller, in any layout, never a byte too far. */
#include "slope.h"

static vbgpd_status get_name(const vbgpd_profile* p, char* buf, int64_t cap, int64_t* needed) {
  return vbgpd_profile_get_text(p, VBGPD_OBJECT_PROFILE, 0, "name", 4, buf, cap, needed);
}

static vbgpd_status set_name(vbgpd_profile* p, const char* text, int64_t length) {
  return vbgpd_profile_set_text(p, VBGPD_OBJECT_PROFILE, 0, "name", 4, text, length);
}

static void text_buffers(vbgpd_profile* p) {
  const char* const name =
      "Hang bei K\xc3\xb6ln \xe2\x9b\xb0 \xf0\x9f\x8f\x94"; /* two, three and four byte sequences */
  const int64_t size = (int64_t)strlen(name);
  char buf[64];
  int64_t needed = -1;
  CHECK_OK(set_name(p, name, VBGPD_STRLEN));
  CHECK_OK(get_name(p, NULL, 0, &needed));
  CHECK(needed == size);
  memset(buf, '#', sizeof buf);
  needed = -1;
  CHECK_STATUS(VBGPD_E_BUFFER, get_name(p, buf, size, &needed));
  CHECK(needed == size && buf[0] == '#');
  CHECK_OK(get_name(p, buf, size + 1, NULL));
  CHECK(strcmp(buf, name) == 0 && buf[size + 1] == '#');
  CHECK_OK(set_name(p, "abcdef", 3));
  CHECK_OK(get_name(p, buf, sizeof buf, &needed));
  CHECK(needed == 3 && strcmp(buf, "abc") == 0);
  CHECK_OK(set_name(p, NULL, 0));
  CHECK_OK(get_name(p, buf, 1, &needed));
  CHECK(needed == 0 && buf[0] == 0);
  CHECK_STATUS(VBGPD_E_ARGUMENT, get_name(p, buf, -1, &needed));
  CHECK_STATUS(VBGPD_E_ARGUMENT, get_name(p, NULL, 8, &needed));
}

static void wrong_texts(vbgpd_profile* p) {
  static const char* const not_utf8[] = {"\xff", "\xc3", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                                         "a\x80"};
  char buf[16];
  size_t i;
  CHECK_OK(set_name(p, "kept", VBGPD_STRLEN));
  for (i = 0; i < sizeof not_utf8 / sizeof not_utf8[0]; ++i) {
    CHECK_STATUS(VBGPD_E_ARGUMENT, set_name(p, not_utf8[i], VBGPD_STRLEN));
  }
  CHECK_STATUS(VBGPD_E_ARGUMENT, set_name(p, "a\0b", 3));
  CHECK_STATUS(VBGPD_E_ARGUMENT, set_name(p, "abc", -2));
  CHECK_STATUS(VBGPD_E_ARGUMENT, set_name(p, NULL, VBGPD_STRLEN));
  CHECK_STATUS(VBGPD_E_ARGUMENT, set_name(p, NULL, 3));
  CHECK_OK(get_name(p, buf, sizeof buf, NULL));
  CHECK(strcmp(buf, "kept") == 0);
}

/* The same corners from packed pairs, from wide records, backwards and from unaligned bytes. */
static void polygon_strides(vbgpd_profile* p) {
  const int64_t corners = 6;
  double wide[6][5], packed[12], back[12];
  unsigned char unaligned[6 * 17 + 1];
  int64_t i, n = -1;
  for (i = 0; i < corners; ++i) {
    wide[i][0] = slope_exterior[2 * i];
    wide[i][1] = slope_exterior[2 * i + 1];
    wide[i][2] = wide[i][3] = wide[i][4] = NAN;
    memcpy(unaligned + 1 + 17 * i, slope_exterior + 2 * i, 16);
  }
  CHECK_OK(vbgpd_profile_set_exterior(p, &wide[0][0], sizeof wide[0], corners));
  CHECK_OK(vbgpd_profile_polygon(p, VBGPD_OBJECT_PROFILE, 0, packed, 16, corners, &n));
  CHECK(n == corners && memcmp(packed, slope_exterior, sizeof packed) == 0);
  CHECK_OK(vbgpd_profile_set_exterior(p, &wide[5][0], -(int64_t)sizeof wide[0], corners));
  CHECK_OK(vbgpd_profile_polygon(p, VBGPD_OBJECT_PROFILE, 0, back + 10, -16, corners, &n));
  CHECK(memcmp(back, slope_exterior, sizeof back) == 0);
  CHECK_OK(vbgpd_profile_set_exterior(p, (const double*)(void*)(unaligned + 1), 17, corners));
  CHECK_OK(vbgpd_profile_polygon(p, VBGPD_OBJECT_PROFILE, 0, packed, 16, corners, NULL));
  CHECK(memcmp(packed, slope_exterior, sizeof packed) == 0);
  CHECK_OK(vbgpd_profile_polygon(p, VBGPD_OBJECT_PROFILE, 0, NULL, 0, 0, &n));
  CHECK(n == corners);
  packed[0] = -77;
  n = -1;
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_profile_polygon(p, VBGPD_OBJECT_PROFILE, 0, packed, 16, 5, &n));
  CHECK(n == corners && packed[0] == -77);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_polygon(p, VBGPD_OBJECT_PROFILE, 0, packed, 8, corners, &n));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_polygon(p, VBGPD_OBJECT_PROFILE, 0, NULL, 16, corners, &n));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_polygon(p, VBGPD_OBJECT_LOAD, 0, packed, 16, corners, &n));
  CHECK_OK(vbgpd_profile_polygon(p, VBGPD_OBJECT_LAYER, 0, packed, 16, corners, &n));
  CHECK(n == 0);
}

/* Every field in rows, in columns and with holes between rows: the same numbers, the guards untouched. */
static void field_layouts(const vbgpd_model* m, int32_t field, const vbgpd_field_info* info) {
  const int64_t c = info->components;
  int64_t n = -1, i, k;
  double *rows, *columns, *holes;
  CHECK_OK(vbgpd_model_read_f64(m, field, NULL, 0, 0, 0, &n));
  CHECK(n > 1);
  rows = (double*)malloc((size_t)(n * c) * sizeof *rows);
  columns = (double*)malloc((size_t)(n * c) * sizeof *columns);
  holes = (double*)malloc((size_t)(n * (c + 1)) * sizeof *holes);
  CHECK(rows && columns && holes);
  for (i = 0; i < n * (c + 1); ++i) holes[i] = -12345;
  CHECK_OK(vbgpd_model_read_f64(m, field, rows, 0, 0, n, NULL));
  CHECK_OK(vbgpd_model_read_f64(m, field, columns, 8, 8 * n, n, NULL));
  CHECK_OK(vbgpd_model_read_f64(m, field, holes, 8 * (c + 1), 0, n, NULL));
  for (i = 0; i < n; ++i) {
    for (k = 0; k < c; ++k) {
      CHECK(memcmp(&rows[i * c + k], &columns[k * n + i], 8) == 0);
      CHECK(memcmp(&rows[i * c + k], &holes[i * (c + 1) + k], 8) == 0);
    }
    CHECK(holes[i * (c + 1) + c] == -12345);
  }
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_model_read_f64(m, field, rows, 0, 0, n - 1, &i));
  CHECK(i == n);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_read_f64(m, field, rows, 4, 0, n, NULL));
  if (c > 1) CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_read_f64(m, field, rows, 8, 8, n, NULL));
  if (info->type == VBGPD_TYPE_I64) {
    int64_t* whole = (int64_t*)malloc((size_t)(n * c) * sizeof *whole);
    CHECK(whole != NULL);
    CHECK_OK(vbgpd_model_read_i64(m, field, whole, 0, 0, n, NULL));
    for (i = 0; i < n * c; ++i) CHECK((double)whole[i] == rows[i]);
    free(whole);
  } else {
    CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_read_i64(m, field, (int64_t*)(void*)rows, 0, 0, n, NULL));
  }
  free(rows);
  free(columns);
  free(holes);
}

static void fields(const vbgpd_model* m) {
  vbgpd_field_info info;
  int64_t i, n = 0;
  CHECK_OK(vbgpd_field_count(&n));
  info.struct_size = sizeof info;
  for (i = 0; i < n; ++i) {
    CHECK_OK(vbgpd_field_info_at(i, &info));
    field_layouts(m, (int32_t)i, &info);
  }
  CHECK_STATUS(VBGPD_END_OF_DATA, vbgpd_field_info_at(n, &info));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_field_info_at(-1, &info));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_read_f64(m, (int32_t)n, NULL, 0, 0, 0, &i));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_read_f64(m, -1, NULL, 0, 0, 0, &i));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_read_f64(m, 0, NULL, 0, 0, 1000000, &i));
}

int main(void) {
  vbgpd_context* context = make_context();
  vbgpd_profile* profile = make_profile(context, 2.5);
  vbgpd_model* model = make_model(context, 2.5);
  text_buffers(profile);
  wrong_texts(profile);
  polygon_strides(profile);
  CHECK_OK(vbgpd_model_step(model, 3, NULL));
  fields(model);
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
