/* NULL, stale, foreign and wrong-kind handles, and overlapping use, for every function; check_names.cmake sees to it
 * that none is forgotten.
 */
#include <pthread.h>

#include "slope.h"

static double xy[2];
static char text[8];
static int64_t n, id;
static int32_t field;
static double value;
static uint64_t hash;
static void* out;
static vbgpd_error_info info;
static vbgpd_advance_result advance;
static vbgpd_feature feature;
static vbgpd_progress progress;
static vbgpd_trial trial;
static vbgpd_level level;
static vbgpd_view view;
static vbgpd_event event;
static vbgpd_log_line line;
static vbgpd_memory memory;

/* kind of handle, function, arguments with `h` as the handle */
#define FUNCTIONS_OF_HANDLES(X)                                                                  \
  X(CONTEXT, vbgpd_context_error, (h, &info, text, 8, &n))                                       \
  X(CONTEXT, vbgpd_context_destroy, (h))                                                         \
  X(CONTEXT, vbgpd_context_log_next, (h, 0, &line, text, 8, &n))                                 \
  X(CONTEXT, vbgpd_context_set_log, (h, NULL, NULL, VBGPD_LOG_INFO))                             \
  X(CONTEXT, vbgpd_profile_create, (h, (vbgpd_profile**)&out))                                   \
  X(CONTEXT, vbgpd_profile_create_from_flatbuffer, (h, "VBGP", 4, (vbgpd_profile**)&out))        \
  X(CONTEXT, vbgpd_model_create_from_checkpoint, (h, "VBGC", 4, (vbgpd_model**)&out))            \
  X(CONTEXT, vbgpd_model_create, (h, good_profile, (vbgpd_model**)&out))                         \
  X(PROFILE, vbgpd_profile_error, (h, &info, text, 8, &n))                                       \
  X(PROFILE, vbgpd_profile_destroy, (h))                                                         \
  X(PROFILE, vbgpd_profile_to_flatbuffer, (h, text, 0, &n))                                      \
  X(PROFILE, vbgpd_profile_set_exterior, (h, xy, 16, 1))                                         \
  X(PROFILE, vbgpd_profile_add_material, (h, "clay", VBGPD_STRLEN, &id))                         \
  X(PROFILE, vbgpd_profile_add_layer, (h, NULL, 16, 0, 0, &id))                                  \
  X(PROFILE, vbgpd_profile_add_boundary, (h, "base", 4, NULL, 16, 0, VBGPD_BOUNDARY_FIXED, &id)) \
  X(PROFILE, vbgpd_profile_add_load, (h, 0, 1, 2, 3, &id))                                       \
  X(PROFILE, vbgpd_profile_set_water_table, (h, xy, 16, 1))                                      \
  X(PROFILE, vbgpd_profile_water_table, (h, xy, 16, 0, &n))                                      \
  X(PROFILE, vbgpd_profile_set_f64, (h, VBGPD_OBJECT_PROFILE, 0, "kh", 2, 0.0))                  \
  X(PROFILE, vbgpd_profile_get_f64, (h, VBGPD_OBJECT_PROFILE, 0, "kh", 2, &value))               \
  X(PROFILE, vbgpd_profile_set_text, (h, VBGPD_OBJECT_PROFILE, 0, "name", 4, "x", 1))            \
  X(PROFILE, vbgpd_profile_get_text, (h, VBGPD_OBJECT_PROFILE, 0, "name", 4, text, 8, &n))       \
  X(PROFILE, vbgpd_profile_count, (h, VBGPD_OBJECT_LAYER, &n))                                   \
  X(PROFILE, vbgpd_profile_polygon, (h, VBGPD_OBJECT_PROFILE, 0, xy, 16, 1, &n))                 \
  X(PROFILE, vbgpd_profile_validate, (h, &n, &n))                                                \
  X(PROFILE, vbgpd_profile_issue, (h, 0, &info, text, 8, &n))                                    \
  X(MODEL, vbgpd_model_error, (h, &info, text, 8, &n))                                           \
  X(MODEL, vbgpd_model_destroy, (h))                                                             \
  X(MODEL, vbgpd_model_set_f64, (h, "damping", 7, 0.0))                                          \
  X(MODEL, vbgpd_model_get_f64, (h, "time", 4, &value))                                          \
  X(MODEL, vbgpd_model_step, (h, 1, &advance))                                                   \
  X(MODEL, vbgpd_model_plan, (h, 0, &feature))                                                   \
  X(MODEL, vbgpd_model_memory, (h, &memory))                                                     \
  X(MODEL, vbgpd_model_cancel, (h))                                                              \
  X(MODEL, vbgpd_job_create_equilibrium, (h, (vbgpd_job**)&out))                                 \
  X(MODEL, vbgpd_job_create_strength_reduction, (h, (vbgpd_job**)&out))                          \
  X(MODEL, vbgpd_model_create_runout, (h, (vbgpd_model**)&out))                                  \
  X(MODEL, vbgpd_job_create_runout, (h, (vbgpd_job**)&out))                                      \
  X(MODEL, vbgpd_model_item_count, (h, VBGPD_AT_BOND, &n))                                       \
  X(MODEL, vbgpd_model_read_f64, (h, 0, xy, 0, 0, 1, &n))                                        \
  X(MODEL, vbgpd_model_read_i64, (h, 0, &id, 0, 0, 1, &n))                                       \
  X(MODEL, vbgpd_model_state_hash, (h, &hash))                                                   \
  X(MODEL, vbgpd_model_advance_to, (h, 1e-6, 0, NULL, NULL, &advance))                           \
  X(MODEL, vbgpd_model_events_read, (h, 0, &event, sizeof event, 1, &n, &n))                     \
  X(MODEL, vbgpd_model_epoch, (h, &n))                                                           \
  X(MODEL, vbgpd_model_save_state, (h, (vbgpd_state**)&out))                                     \
  X(MODEL, vbgpd_model_restore_state, (h, good_state))                                           \
  X(MODEL, vbgpd_model_checkpoint, (h, text, 0, &n))                                             \
  X(MODEL, vbgpd_model_restore_checkpoint, (h, text, 8))                                         \
  X(MODEL, vbgpd_model_snapshot, (h, text, 0, &n))                                               \
  X(MODEL, vbgpd_model_select, (h, NULL, &id, 8, 1, &n))                                         \
  X(MODEL, vbgpd_model_read_selected_f64, (h, 0, NULL, xy, 0, 0, 1, &n))                         \
  X(MODEL, vbgpd_model_read_selected_i64, (h, 0, NULL, &id, 0, 0, 1, &n))                        \
  X(MODEL, vbgpd_model_sample_points, (h, 0, xy, 16, 1, xy, 0, 0, &id, 0))                       \
  X(MODEL, vbgpd_model_sample_line, (h, 0, 0, 0, 1, 1, 1, xy, 0, 0, &id, 0))                     \
  X(MODEL, vbgpd_model_sample_grid, (h, 0, 0, 0, 1, 1, 1, 1, xy, 0, 0, &id, 0))                  \
  X(MODEL, vbgpd_model_ground_surface, (h, xy, 16, 1, &n))                                       \
  X(MODEL, vbgpd_model_view_acquire, (h, 2, &view))                                              \
  X(MODEL, vbgpd_model_view_release, (h, 1))                                                     \
  X(MODEL, vbgpd_model_write_f64, (h, 0, NULL, xy, 0, 0, 1))                                     \
  X(MODEL, vbgpd_model_write_points, (h, 0, xy, 16, xy, 0, 0, 1))                                \
  X(MODEL, vbgpd_model_write_grid, (h, 0, 0, 0, 1, 1, 1, 1, xy, 0))                              \
  X(MODEL, vbgpd_model_set_load, (h, 0, 0, 0))                                                   \
  X(MODEL, vbgpd_model_set_boundary_velocity, (h, 0, 0, 0))                                      \
  X(MODEL, vbgpd_model_set_layer_active, (h, 0, 1))                                              \
  X(MODEL, vbgpd_model_boundary_reaction, (h, 0, &value, &value))                                \
  X(STATE, vbgpd_state_destroy, (h))                                                             \
  X(JOB, vbgpd_job_error, (h, &info, text, 8, &n))                                               \
  X(JOB, vbgpd_job_destroy, (h))                                                                 \
  X(JOB, vbgpd_job_set_f64, (h, "levels", 6, 1.0))                                               \
  X(JOB, vbgpd_job_run, (h, 0.01, NULL, NULL, &progress))                                        \
  X(JOB, vbgpd_job_cancel, (h))                                                                  \
  X(JOB, vbgpd_job_get_f64, (h, "levels", 6, &value))                                            \
  X(JOB, vbgpd_job_get_text, (h, "status", 6, text, 8, &n))                                      \
  X(JOB, vbgpd_job_trial, (h, 0, &trial))                                                        \
  X(JOB, vbgpd_job_level, (h, 0, &level))                                                        \
  X(JOB, vbgpd_job_slip_surface, (h, xy, 16, 1, &n))

/* functions without a handle; they must work, not fail */
#define FUNCTIONS_WITHOUT(X)                                                                                 \
  X(vbgpd_version_number, (vbgpd_version_number() == VBGPD_VERSION_NUMBER))                                  \
  X(vbgpd_abi_version, (vbgpd_abi_version() == VBGPD_ABI_VERSION))                                           \
  X(vbgpd_version_string, (vbgpd_version_string()[0] != 0))                                                  \
  X(vbgpd_status_name, (vbgpd_status_name(VBGPD_E_HANDLE)[0] != 0))                                          \
  X(vbgpd_build_info, (vbgpd_build_info("no such fact", VBGPD_STRLEN, text, 8, &n) == VBGPD_E_UNKNOWN_NAME)) \
  X(vbgpd_context_desc_init, (vbgpd_context_desc_init(NULL, 8) == VBGPD_E_ARGUMENT))                         \
  X(vbgpd_context_create, (vbgpd_context_create(NULL, NULL) == VBGPD_E_ARGUMENT))                            \
  X(vbgpd_context_desc_check, (vbgpd_context_desc_check(NULL, &info, text, 8, &n) == VBGPD_END_OF_DATA))      \
  X(vbgpd_property_count, (vbgpd_property_count(VBGPD_OBJECT_JOB, &n) == VBGPD_OK))                          \
  X(vbgpd_property_info_at, (vbgpd_property_info_at(VBGPD_OBJECT_JOB, 0, NULL) == VBGPD_E_ARGUMENT))         \
  X(vbgpd_field_count, (vbgpd_field_count(&n) == VBGPD_OK))                                                  \
  X(vbgpd_field_info_at, (vbgpd_field_info_at(0, NULL) == VBGPD_E_ARGUMENT))                                 \
  X(vbgpd_field_find, (vbgpd_field_find("no such field", VBGPD_STRLEN, &field) == VBGPD_E_UNKNOWN_NAME))

static vbgpd_profile* good_profile;
static vbgpd_state* good_state;

#define DEFINE_CALL(kind, name, arguments) \
  static vbgpd_status call_##name(void* h) { return name arguments; }
FUNCTIONS_OF_HANDLES(DEFINE_CALL)

typedef struct {
  const char* name;
  int32_t kind;
  vbgpd_status (*call)(void*);
} entry;
#define ENTRY(kind, name, arguments) {#name, VBGPD_OBJECT_##kind, call_##name},
static const entry table[] = {FUNCTIONS_OF_HANDLES(ENTRY)};
enum { functions = sizeof table / sizeof table[0] };

static int destroys(const entry* e) { return strstr(e->name, "_destroy") != NULL; }

static void refuse_everywhere(int32_t but_not_kind, void* handle, const char* what) {
  int i;
  for (i = 0; i < functions; ++i) {
    vbgpd_status status;
    if (table[i].kind == but_not_kind || (handle == NULL && destroys(&table[i]))) continue;
    status = table[i].call(handle);
    if (status != VBGPD_E_HANDLE) {
      fprintf(stderr, "%s says %s to a %s handle\n", table[i].name, vbgpd_status_name(status), what);
      exit(1);
    }
  }
}

static void null_handles(void) {
  refuse_everywhere(0, NULL, "NULL");
  CHECK_OK(vbgpd_context_destroy(NULL));
  CHECK_OK(vbgpd_profile_destroy(NULL));
  CHECK_OK(vbgpd_model_destroy(NULL));
  CHECK_OK(vbgpd_job_destroy(NULL));
  CHECK_OK(vbgpd_state_destroy(NULL));
}

static void foreign_handles(void* live) {
  static double storage[64];
  double local[64];
  char* heap = (char*)malloc(64);
  int bit;
  memset(local, 0xff, sizeof local);
  memset(heap, 0xa5, 64);
  refuse_everywhere(0, storage, "static storage");
  refuse_everywhere(0, local, "stack");
  refuse_everywhere(0, heap, "heap");
  refuse_everywhere(0, heap + 1, "odd heap");
  refuse_everywhere(0, (void*)(uintptr_t)1, "small");
  refuse_everywhere(0, (void*)UINTPTR_MAX, "all ones");
  /* Bits 1 to 16 are the slot: damaged there, a handle may be that of another object. */
  for (bit = 0; bit < (int)(8 * sizeof(void*)); bit = bit == 0 ? 17 : bit + 1) {
    refuse_everywhere(0, (void*)((uintptr_t)live ^ (uintptr_t)1 << bit), "damaged");
  }
  free(heap);
}

static void functions_without_handles(void) {
#define CHECK_FREE(name, condition) CHECK(condition);
  FUNCTIONS_WITHOUT(CHECK_FREE)
}

/* Handles never come back to life, however often their slot is used again. */
static void stale_handles(vbgpd_context* context, vbgpd_model* model) {
  vbgpd_context* old_context = make_context();
  vbgpd_profile* old_profile = make_profile(context, 1);
  vbgpd_model* old_model = make_model(context, 2.5);
  vbgpd_job* old_job = NULL;
  vbgpd_state* old_state = NULL;
  int i;
  CHECK_OK(vbgpd_model_save_state(model, &old_state));
  CHECK_OK(vbgpd_state_destroy(old_state));
  CHECK_OK(vbgpd_job_create_equilibrium(model, &old_job));
  CHECK_OK(vbgpd_context_destroy(old_context));
  CHECK_OK(vbgpd_profile_destroy(old_profile));
  CHECK_OK(vbgpd_model_destroy(old_model));
  CHECK_OK(vbgpd_job_destroy(old_job));
  for (i = 0; i < 1000; ++i) {
    vbgpd_context* next = make_context();
    vbgpd_profile* next_profile = NULL;
    CHECK_OK(vbgpd_profile_create(next, &next_profile));
    CHECK((void*)next != (void*)old_context && (void*)next_profile != (void*)old_profile);
    if (i % 100 == 0) {
      refuse_everywhere(0, old_context, "stale context");
      refuse_everywhere(0, old_profile, "stale profile");
      refuse_everywhere(0, old_model, "stale model");
      refuse_everywhere(0, old_job, "stale job");
      refuse_everywhere(0, old_state, "stale state");
    }
    CHECK_OK(vbgpd_profile_destroy(next_profile));
    CHECK_OK(vbgpd_context_destroy(next));
  }
}

/* Whoever is inside an object is alone: its own callback is told so (R5), and so is every other thread (R4). */
typedef struct {
  int32_t kind;
  void* handle;
  vbgpd_status expected;
  int calls;
} visit;

static int may_overlap(const entry* e) { return strstr(e->name, "_cancel") != NULL; }

static void* refused_everywhere(void* user) {
  const visit* v = (const visit*)user;
  int i;
  for (i = 0; i < functions; ++i) {
    vbgpd_status status;
    if (table[i].kind != v->kind || may_overlap(&table[i])) continue;
    status = table[i].call(v->handle);
    if (status != v->expected) {
      fprintf(stderr, "%s says %s, not %s, inside a call\n", table[i].name, vbgpd_status_name(status),
              vbgpd_status_name(v->expected));
      exit(1);
    }
  }
  return NULL;
}

static int32_t VBGPD_CALL let_in_nobody(void* user, const vbgpd_progress* p) {
  visit* v = (visit*)user;
  pthread_t other;
  (void)p;
  ++v->calls;
  v->expected = VBGPD_E_REENTRANT;
  refused_everywhere(v);
  v->expected = VBGPD_E_BUSY;
  CHECK(pthread_create(&other, NULL, refused_everywhere, v) == 0);
  CHECK(pthread_join(other, NULL) == 0);
  return 1;
}

static void overlapping_use(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 0.5);
  vbgpd_job* job = NULL;
  visit of_model = {VBGPD_OBJECT_MODEL, NULL, 0, 0}, of_job = {VBGPD_OBJECT_JOB, NULL, 0, 0};
  of_model.handle = model;
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_model_advance_to(model, 1e6, 0, let_in_nobody, &of_model, NULL));
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  of_job.handle = job;
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_job_run(job, 0, let_in_nobody, &of_job, NULL));
  CHECK(of_model.calls == 1 && of_job.calls == 1);
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
}

static void profiles_that_are_none(vbgpd_context* context, vbgpd_model* model) {
  vbgpd_model* made = NULL;
  CHECK_STATUS(VBGPD_E_HANDLE, vbgpd_model_create(context, NULL, &made));
  CHECK_STATUS(VBGPD_E_HANDLE, vbgpd_model_create(context, (const vbgpd_profile*)(void*)model, &made));
  CHECK(made == NULL);
  info.struct_size = sizeof info;
  CHECK_OK(vbgpd_context_error(context, &info, NULL, 0, NULL));
  CHECK(info.status == VBGPD_E_HANDLE && info.argument == 2);
}

int main(void) {
  vbgpd_context* context = make_context();
  vbgpd_model* model = make_model(context, 2.5);
  vbgpd_job* job = NULL;
  good_profile = make_profile(context, 2.5);
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_model_save_state(model, &good_state));
  null_handles();
  foreign_handles(context);
  refuse_everywhere(VBGPD_OBJECT_CONTEXT, context, "context");
  refuse_everywhere(VBGPD_OBJECT_PROFILE, good_profile, "profile");
  refuse_everywhere(VBGPD_OBJECT_MODEL, model, "model");
  refuse_everywhere(VBGPD_OBJECT_JOB, job, "job");
  refuse_everywhere(VBGPD_OBJECT_STATE, good_state, "state");
  stale_handles(context, model);
  profiles_that_are_none(context, model);
  overlapping_use(context);
  functions_without_handles();
  CHECK(out == NULL);
  CHECK_OK(vbgpd_profile_destroy(good_profile));
  CHECK_OK(vbgpd_state_destroy(good_state));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
