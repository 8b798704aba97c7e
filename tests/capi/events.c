/* What happened to a model, polled. */
#include "slope.h"

static int64_t events_of(vbgpd_model* model, int64_t after, vbgpd_event* to, int64_t cap) {
  int64_t n = -1, dropped = -1;
  if (cap > 0) to->struct_size = sizeof *to;
  CHECK_OK(vbgpd_model_events_read(model, after, to, sizeof *to, cap, &n, &dropped));
  CHECK(dropped == 0);
  return n;
}

static void first_yield_is_told_once(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 1);
  vbgpd_event e[4];
  vbgpd_state* before = NULL;
  CHECK(events_of(model, 0, NULL, 0) == 0);
  CHECK_OK(vbgpd_model_step(model, 1, NULL));
  CHECK_OK(vbgpd_model_save_state(model, &before));
  CHECK_OK(vbgpd_model_step(model, 200, NULL));
  CHECK_OK(vbgpd_model_step(model, 200, NULL));
  CHECK(events_of(model, 0, e, 4) == 1);
  CHECK(e[0].struct_size == sizeof e[0] && e[0].kind == VBGPD_EVENT_FIRST_YIELD && e[0].sequence == 1);
  CHECK(e[0].step == 201 && e[0].id_a >= 0 && e[0].id_b >= 0 && e[0].value > 0);
  CHECK(e[0].x > 0 && e[0].x < 40 && e[0].y > -3 && e[0].y < 15);
  CHECK(events_of(model, 1, e, 4) == 0);
  CHECK_OK(vbgpd_model_restore_state(model, before)); /* it has not yielded yet: it may yield first again */
  CHECK_OK(vbgpd_model_step(model, 200, NULL));
  CHECK(events_of(model, 1, e, 4) == 1 && e[0].sequence == 2);
  CHECK_OK(vbgpd_state_destroy(before));
  CHECK_OK(vbgpd_model_destroy(model));
}

static void mechanisms_and_rest_are_told(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 2.5);
  vbgpd_job* job = NULL;
  vbgpd_event e[4];
  int64_t n, k, rest = 0;
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "levels", VBGPD_STRLEN, 1));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL)); /* over is over */
  CHECK(events_of(model, 0, e, 4) == 1 && e[0].kind == VBGPD_EVENT_MECHANISM);
  CHECK(e[0].value == model_number(model, "strength_reduction_factor"));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));

  model = make_model(context, 2.5);
  CHECK_OK(vbgpd_model_set_f64(model, "strength_reduction_factor", VBGPD_STRLEN, 0.5));
  CHECK_OK(vbgpd_model_set_f64(model, "damping", VBGPD_STRLEN, 0.7));
  CHECK_OK(vbgpd_model_step(model, 4000, NULL));
  CHECK_OK(vbgpd_model_step(model, 10, NULL));
  n = events_of(model, 0, e, 4);
  for (k = 0; k < n; ++k) rest += e[k].kind == VBGPD_EVENT_AT_REST && e[k].value < 1e-5;
  CHECK(rest == 1);
  CHECK_OK(vbgpd_model_destroy(model));
}

/* A host that steps one by one with steps too long hears of it before it is over, and why in words. */
static void divergence_is_announced(vbgpd_context* context) {
  vbgpd_profile* slope = make_profile(context, 1);
  vbgpd_model* model = NULL;
  vbgpd_event e[8];
  vbgpd_status status = VBGPD_OK;
  char text[300];
  int64_t n, k, near = -1, over = -1, steps = 0;
  CHECK_OK(vbgpd_profile_set_text(slope, VBGPD_OBJECT_MATERIAL, 0, "law", VBGPD_STRLEN, "elastic", VBGPD_STRLEN));
  CHECK_OK(vbgpd_model_create(context, slope, &model));
  CHECK_OK(vbgpd_model_step(model, 500, NULL));
  CHECK(events_of(model, 0, e, 8) == 0); /* nothing to tell of good steps */
  CHECK_OK(vbgpd_model_set_f64(model, "time_step_factor", VBGPD_STRLEN, 1.2));
  for (; status == VBGPD_OK && steps < 2000; ++steps) status = vbgpd_model_step(model, 1, NULL);
  CHECK_STATUS(VBGPD_E_DIVERGED, status);
  CHECK_OK(vbgpd_model_error(model, NULL, text, sizeof text, NULL));
  CHECK_CONTAINS(text, "a particle outran the waves");
  n = events_of(model, 0, e, 8);
  for (k = 0; k < n; ++k) {
    if (e[k].kind == VBGPD_EVENT_NEAR_DIVERGENCE) near = k;
    if (e[k].kind == VBGPD_EVENT_DIVERGED) over = k;
  }
  CHECK(near >= 0 && over > near && e[near].value > 0.2 && e[near].value <= 1);
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_profile_destroy(slope));
}

/* Small events of an older caller, far apart; wrong arguments. */
static void events_of_other_sizes(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 1);
  union {
    vbgpd_event first;
    unsigned char bytes[200];
  } room;
  int64_t n = -1, i;
  CHECK_OK(vbgpd_model_step(model, 300, NULL));
  memset(&room, 0x5a, sizeof room);
  room.first.struct_size = 16;
  CHECK_OK(vbgpd_model_events_read(model, -5, &room.first, 100, 2, &n, NULL));
  CHECK(n == 1 && room.first.struct_size == 16 && room.first.sequence == 1);
  for (i = 16; i < (int64_t)sizeof room; ++i) CHECK(room.bytes[i] == 0x5a);
  room.first.struct_size = 4;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_events_read(model, 0, &room.first, 100, 2, &n, NULL));
  room.first.struct_size = 64;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_events_read(model, 0, &room.first, 32, 2, &n, NULL));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_events_read(model, 0, NULL, 32, 2, &n, NULL));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_events_read(model, 0, NULL, 32, -2, &n, NULL));
  CHECK_OK(vbgpd_model_events_read(model, INT64_MAX, NULL, 0, 0, &n, &i));
  CHECK(n == 0 && i == 0);
  CHECK_OK(vbgpd_model_destroy(model));
}

int main(void) {
  vbgpd_context* context = make_context();
  first_yield_is_told_once(context);
  mechanisms_and_rest_are_told(context);
  divergence_is_announced(context);
  events_of_other_sizes(context);
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
