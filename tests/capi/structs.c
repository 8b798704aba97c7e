/* R9: structs of older and newer callers are filled as far as they go and not one byte further. */
#include <stddef.h>

#include "slope.h"

enum { room = 512, guard = 0x5a };

typedef vbgpd_status (*fill_fn)(void* out);
static vbgpd_context* context;
static vbgpd_profile* profile;
static vbgpd_model* model;
static vbgpd_job* job;

static vbgpd_status fill_error(void* s) { return vbgpd_profile_error(profile, (vbgpd_error_info*)s, NULL, 0, NULL); }
static vbgpd_status fill_issue(void* s) { return vbgpd_profile_issue(profile, 0, (vbgpd_error_info*)s, NULL, 0, NULL); }
static vbgpd_status fill_property(void* s) {
  return vbgpd_property_info_at(VBGPD_OBJECT_MATERIAL, 0, (vbgpd_property_info*)s);
}
static vbgpd_status fill_field(void* s) { return vbgpd_field_info_at(0, (vbgpd_field_info*)s); }
static vbgpd_status fill_advance(void* s) { return vbgpd_model_step(model, 0, (vbgpd_advance_result*)s); }
static vbgpd_status fill_progress(void* s) { return vbgpd_job_run(job, 0, NULL, NULL, (vbgpd_progress*)s); }
static vbgpd_status fill_trial(void* s) { return vbgpd_job_trial(job, 0, (vbgpd_trial*)s); }
static vbgpd_status fill_feature(void* s) { return vbgpd_model_plan(model, 0, (vbgpd_feature*)s); }
static vbgpd_status fill_level(void* s) { return vbgpd_job_level(job, 0, (vbgpd_level*)s); }

static vbgpd_status fill_memory(void* s) { return vbgpd_model_memory(model, (vbgpd_memory*)s); }
static vbgpd_status fill_log_line(void* s) {
  return vbgpd_context_log_next(context, 0, (vbgpd_log_line*)s, NULL, 0, NULL);
}
static vbgpd_status fill_event(void* s) {
  return vbgpd_model_events_read(model, 0, (vbgpd_event*)s, room, 1, NULL, NULL);
}
/* Every view is another lease: that member is taken out of the comparison. */
static vbgpd_status fill_view(void* s) {
  vbgpd_view whole = {sizeof whole, 0, NULL, 0, 0, 0, 0, 0, 0};
  uint32_t size;
  vbgpd_status status;
  memcpy(&size, s, sizeof size);
  status = vbgpd_model_view_acquire(model, 2, (vbgpd_view*)s);
  if (status != VBGPD_OK) return status;
  CHECK_OK(vbgpd_model_view_acquire(model, 2, &whole));
  CHECK_OK(vbgpd_model_view_release(model, whole.lease));
  CHECK_OK(vbgpd_model_view_release(model, whole.lease - 1));
  if (size >= sizeof whole) memset((char*)s + offsetof(vbgpd_view, lease), 0, sizeof whole.lease);
  return status;
}

static void put_size(unsigned char* bytes, uint32_t size) {
  memset(bytes, guard, room);
  memcpy(bytes, &size, sizeof size);
}

/* Bytes of a struct of that size after a call that must succeed; the guard behind it must be whole. */
static void filled(fill_fn fill, uint32_t size, uint32_t whole, unsigned char* bytes) {
  uint32_t i, kept;
  put_size(bytes, size);
  CHECK_OK(fill(bytes));
  memcpy(&kept, bytes, sizeof kept);
  CHECK(kept == size);
  for (i = size < whole ? size : whole; i < room; ++i) CHECK(bytes[i] == guard);
}

static void check_struct(fill_fn fill, uint32_t whole) {
  static const uint32_t absurd[] = {0, 1, 3, 4, 7};
  union {
    double alignment;
    unsigned char bytes[room];
  } reference, other;
  uint32_t size, i;
  for (i = 0; i < sizeof absurd / sizeof absurd[0]; ++i) {
    put_size(other.bytes, absurd[i]);
    CHECK_STATUS(VBGPD_E_ARGUMENT, fill(other.bytes));
    for (size = 4; size < room; ++size) CHECK(other.bytes[size] == guard);
  }
  filled(fill, whole, whole, reference.bytes);
  for (size = 8; size <= whole + 64; size += 8) {
    const uint32_t common = size < whole ? size : whole;
    filled(fill, size, whole, other.bytes);
    CHECK(memcmp(reference.bytes + 4, other.bytes + 4, common - 4) == 0);
  }
}

static void short_context_desc(void) {
  vbgpd_context_desc desc;
  vbgpd_context* made = NULL;
  memset(&desc, guard, sizeof desc);
  CHECK_OK(vbgpd_context_desc_init(&desc, 12));
  CHECK(desc.struct_size == 12 && desc.abi_version == VBGPD_ABI_VERSION && desc.threads == 1);
  CHECK(desc.reserved == 0x5a5a5a5a); /* beyond the caller's struct */
  CHECK_OK(vbgpd_context_create(&desc, &made));
  CHECK_OK(vbgpd_context_destroy(made));
  CHECK_OK(vbgpd_context_desc_init(&desc, sizeof desc));
  CHECK(desc.reserved == 0 && desc.max_particles == 0 && desc.max_bytes == 0);
  desc.struct_size = sizeof desc + 16; /* a newer caller; the library reads what it knows */
  CHECK_OK(vbgpd_context_create(&desc, &made));
  CHECK_OK(vbgpd_context_destroy(made));
  desc.struct_size = 4;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_context_create(&desc, &made));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_context_desc_init(&desc, 4));
}

static void told_what_is_wrong(vbgpd_context_desc desc) {
  vbgpd_error_info info = {.struct_size = sizeof info};
  char text[400];
  int64_t needed = 0;
  CHECK_STATUS(VBGPD_END_OF_DATA, vbgpd_context_desc_check(&desc, &info, text, sizeof text, &needed));
  CHECK_STATUS(VBGPD_END_OF_DATA, vbgpd_context_desc_check(NULL, NULL, NULL, 0, NULL));
  desc.threads = -3, desc.max_bytes = -7;
  CHECK_OK(vbgpd_context_desc_check(&desc, &info, text, sizeof text, &needed));
  CHECK(info.status == VBGPD_E_RANGE && info.object_kind == VBGPD_OBJECT_CONTEXT && info.argument == 1);
  CHECK(info.value == -3);
  CHECK(strstr(text, "threads is -3;") != NULL && strstr(text, "max_bytes is -7;") != NULL);
  CHECK(needed == (int64_t)strlen(text));
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_context_desc_check(&desc, NULL, text, 5, &needed));
  desc.struct_size = 2;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_context_desc_check(&desc, &info, text, sizeof text, &needed));
}

static void wrong_context_desc(void) {
  vbgpd_context_desc desc;
  vbgpd_context* made = NULL;
  CHECK_OK(vbgpd_context_desc_init(&desc, sizeof desc));
  told_what_is_wrong(desc);
  desc.abi_version = VBGPD_ABI_VERSION + 1;
  CHECK_STATUS(VBGPD_E_VERSION, vbgpd_context_create(&desc, &made));
  desc.abi_version = VBGPD_ABI_VERSION;
  desc.threads = 1025;
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_context_create(&desc, &made));
  desc.threads = -1;
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_context_create(&desc, &made));
  desc.threads = 0;
  desc.max_particles = -5;
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_context_create(&desc, &made));
  desc.max_particles = 0;
  desc.max_bytes = -1;
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_context_create(&desc, &made));
  desc.max_bytes = 0;
  desc.reserved = 1;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_context_create(&desc, &made));
  CHECK(made == NULL);
  desc.reserved = 0;
  desc.max_particles = 3; /* far too few for any slope */
  CHECK_OK(vbgpd_context_create(&desc, &made));
  {
    vbgpd_profile* slope = make_profile(made, 1);
    vbgpd_model* too_large = NULL;
    CHECK_STATUS(VBGPD_E_LIMIT, vbgpd_model_create(made, slope, &too_large));
    CHECK(too_large == NULL);
    CHECK_OK(vbgpd_profile_destroy(slope));
  }
  CHECK_OK(vbgpd_context_destroy(made));
}

int main(void) {
  int64_t errors = 0;
  context = make_context();
  model = make_model(context, 2.5);
  CHECK_OK(vbgpd_profile_create(context, &profile));
  CHECK_OK(vbgpd_profile_validate(profile, &errors, NULL));
  CHECK(errors > 0);
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_profile_count(profile, 99, &errors));
  check_struct(fill_error, sizeof(vbgpd_error_info));
  check_struct(fill_issue, sizeof(vbgpd_error_info));
  check_struct(fill_property, sizeof(vbgpd_property_info));
  check_struct(fill_field, sizeof(vbgpd_field_info));
  check_struct(fill_advance, sizeof(vbgpd_advance_result));
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "levels", VBGPD_STRLEN, 1));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  check_struct(fill_progress, sizeof(vbgpd_progress)); /* a finished job repeats its outcome */
  check_struct(fill_trial, sizeof(vbgpd_trial));
  check_struct(fill_level, sizeof(vbgpd_level));
  check_struct(fill_feature, sizeof(vbgpd_feature));
  check_struct(fill_memory, sizeof(vbgpd_memory));
  check_struct(fill_log_line, sizeof(vbgpd_log_line));
  check_struct(fill_event, sizeof(vbgpd_event));
  check_struct(fill_view, sizeof(vbgpd_view));
  short_context_desc();
  wrong_context_desc();
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
