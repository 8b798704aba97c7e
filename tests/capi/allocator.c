/* Memory from the host: how much of it, from which thread, given back whole, and what happens when there is none. */
#include <pthread.h>

#include "slope.h"

enum { most = 4096 };
typedef struct {
  void* p;
  int64_t bytes, alignment;
} block;
static block blocks[most];
static int64_t live, count, calls, fail_at = -1, off_by;
static pthread_t caller;
static vbgpd_model* inside; /* a model whose call must be under way */
static int refused;

static void* VBGPD_CALL host_alloc(void* user, int64_t bytes, int64_t alignment) {
  void* p = NULL;
  CHECK(user == (void*)blocks && bytes > 0 && alignment > 0 && alignment <= 64 && (alignment & (alignment - 1)) == 0);
  CHECK(pthread_equal(caller, pthread_self()));
  if (inside != NULL) {
    double value;
    CHECK_STATUS(VBGPD_E_REENTRANT, vbgpd_model_get_f64(inside, "time", VBGPD_STRLEN, &value));
    ++refused;
  }
  if (fail_at >= 0 && calls++ >= fail_at) return NULL;
  CHECK(count < most && posix_memalign(&p, 128, (size_t)bytes + 64) == 0);
  p = (char*)p + off_by;
  blocks[count].p = p, blocks[count].bytes = bytes, blocks[count].alignment = alignment;
  ++count, live += bytes;
  return p;
}

static void VBGPD_CALL host_free(void* user, void* p, int64_t bytes, int64_t alignment) {
  int64_t k = 0;
  CHECK(user == (void*)blocks && p != NULL && pthread_equal(caller, pthread_self()));
  while (k < count && blocks[k].p != p) ++k;
  CHECK(k < count && blocks[k].bytes == bytes && blocks[k].alignment == alignment);
  blocks[k] = blocks[--count];
  live -= bytes;
  free((char*)p - off_by);
}

static vbgpd_context* hosted_context(int32_t threads) {
  vbgpd_context_desc desc;
  vbgpd_context* context = NULL;
  CHECK_OK(vbgpd_context_desc_init(&desc, sizeof desc));
  CHECK(desc.alloc == NULL && desc.free == NULL);
  desc.threads = threads;
  desc.alloc = host_alloc, desc.free = host_free, desc.alloc_user = blocks;
  CHECK_OK(vbgpd_context_create(&desc, &context));
  return context;
}

static uint64_t hash_of(const vbgpd_model* model) {
  uint64_t hash = 0;
  CHECK_OK(vbgpd_model_state_hash(model, &hash));
  return hash;
}

static int64_t bytes_of(const vbgpd_model* model) {
  vbgpd_memory memory;
  memory.struct_size = sizeof memory;
  CHECK_OK(vbgpd_model_memory(model, &memory));
  return memory.bytes + memory.saved;
}

static void both_or_none(void) {
  vbgpd_context_desc desc;
  vbgpd_context* context = NULL;
  CHECK_OK(vbgpd_context_desc_init(&desc, sizeof desc));
  desc.alloc = host_alloc;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_context_create(&desc, &context));
  desc.alloc = NULL, desc.free = host_free;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_context_create(&desc, &context));
  CHECK(context == NULL);
}

/* Nine bytes in ten and more, with the same results, and all of it given back in the wrong order. */
static void most_of_it_passes_through(void) {
  vbgpd_context *context = hosted_context(2), *plain = make_context();
  vbgpd_model *model = make_model(context, 0.2), *other = make_model(plain, 0.2), *flow = NULL;
  vbgpd_state* state = NULL;
  double share = (double)live / (double)bytes_of(model);
  CHECK(model_number(model, "particles") > 10000);
  printf("fresh: %lld bytes through the host, %.1f %% of the model\n", (long long)live, 100 * share);
  CHECK(share >= 0.9 && share <= 1);
  CHECK_OK(vbgpd_model_step(model, 3, NULL));
  CHECK_OK(vbgpd_model_step(other, 3, NULL));
  CHECK(hash_of(model) == hash_of(other));
  CHECK_OK(vbgpd_model_save_state(model, &state));
  share = (double)live / (double)bytes_of(model);
  printf("in use: %lld bytes through the host, %.1f %% of model and state\n", (long long)live, 100 * share);
  CHECK(share >= 0.9 && share <= 1);
  CHECK_OK(vbgpd_model_destroy(other));
  CHECK_OK(vbgpd_context_destroy(plain));
  {
    const int64_t before = live;
    CHECK_OK(vbgpd_model_create_runout(model, &flow));
    CHECK_OK(vbgpd_model_step(flow, 2, NULL));
    share = (double)(live - before) / (double)bytes_of(flow);
    printf("run-out: %.1f %%\n", 100 * share);
    CHECK(share >= 0.8 && share <= 1);
  }
  CHECK_OK(vbgpd_context_destroy(context));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK(live > 0);
  CHECK_OK(vbgpd_model_destroy(flow));
  CHECK(live > 0); /* the saved state */
  CHECK_OK(vbgpd_state_destroy(state));
  CHECK(live == 0 && count == 0);
}

static vbgpd_context* context;
static vbgpd_profile* profile;
static vbgpd_model *model, *made;
static vbgpd_state *state, *saved;

static vbgpd_status create(void) { return vbgpd_model_create(context, profile, &made); }
static vbgpd_status step(void) { return vbgpd_model_step(model, 2, NULL); }
static vbgpd_status save(void) { return vbgpd_model_save_state(model, &saved); }
static vbgpd_status dig(void) { return vbgpd_model_set_layer_active(model, 1, 0); }
static vbgpd_status run_out(void) { return vbgpd_model_create_runout(model, &made); }
static vbgpd_status soak(void) {
  static const double corners[4] = {20e3, 10e3, 0, -20e3};
  int32_t field = -1;
  CHECK_OK(vbgpd_field_find("pore_pressure", VBGPD_STRLEN, &field));
  return vbgpd_model_write_grid(model, field, 0, 0, 40, 15, 2, 2, corners, 0);
}

/* Every n-th allocation of a call fails once: VBGPD_E_MEMORY, the model as before, nothing left behind. */
static void survives(const char* name, vbgpd_status (*call)(void)) {
  const uint64_t before = hash_of(model);
  int64_t n;
  vbgpd_status s = VBGPD_E_MEMORY;
  for (n = 0; s != VBGPD_OK; ++n) {
    CHECK_OK(vbgpd_model_restore_state(model, state));
    CHECK(hash_of(model) == before);
    calls = 0, fail_at = n;
    s = call();
    fail_at = -1;
    CHECK(s == VBGPD_OK || s == VBGPD_E_MEMORY);
    if (s != VBGPD_OK) CHECK(hash_of(model) == before && made == NULL && saved == NULL);
  }
  printf("%s: %lld allocations\n", name, (long long)n - 1);
  CHECK(n > 1);
  CHECK_OK(vbgpd_model_destroy(made));
  CHECK_OK(vbgpd_state_destroy(saved));
  made = NULL, saved = NULL;
  CHECK_OK(vbgpd_model_restore_state(model, state));
}

static void without_memory(void) {
  static const double toe[] = {31, -1, 41, -1, 41, 6, 31, 6};
  context = hosted_context(1);
  profile = make_profile(context, 2);
  CHECK_OK(vbgpd_profile_add_layer(profile, toe, 16, 4, 0, NULL));
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  CHECK_OK(vbgpd_model_save_state(model, &state));
  survives("step", step); /* the first ones */
  survives("create", create);
  survives("save", save);
  survives("write", soak);
  survives("dig", dig);
  survives("run out", run_out);
  inside = model;
  CHECK_OK(dig());
  inside = NULL;
  CHECK(refused > 5);
  CHECK_OK(vbgpd_state_destroy(state));
  CHECK_OK(vbgpd_context_destroy(context));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK(live == 0 && count == 0);
}

static void crooked_memory_is_refused(void) {
  vbgpd_context* crooked = hosted_context(1);
  vbgpd_profile* slope = make_profile(crooked, 2);
  vbgpd_model* none = NULL;
  char text[300];
  off_by = 8;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_create(crooked, slope, &none));
  CHECK_OK(vbgpd_context_error(crooked, NULL, text, sizeof text, NULL));
  CHECK_CONTAINS(text, "not aligned");
  CHECK(live == 0 && count == 0 && none == NULL);
  off_by = 0;
  CHECK_OK(vbgpd_profile_destroy(slope));
  CHECK_OK(vbgpd_context_destroy(crooked));
}

int main(void) {
  caller = pthread_self();
  both_or_none();
  most_of_it_passes_through();
  without_memory();
  crooked_memory_is_refused();
  return 0;
}
