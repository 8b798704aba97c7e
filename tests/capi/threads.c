/* Cancel from another thread and from a callback, re-entry from a callback, overlapping use. No test waits for a clock:
 * the callback holds the job still until the other thread is done. */
#define _XOPEN_SOURCE 700 /* setitimer */
#include <pthread.h>
#include <signal.h>
#include <sys/time.h>

#include "slope.h"

typedef struct {
  pthread_mutex_t mutex;
  pthread_cond_t changed;
  int inside, finished; /* the callback is inside; the other thread has finished */
  vbgpd_model* model;
  vbgpd_job* job;
  int calls;
} stage;

static void begin(stage* s, vbgpd_context* context) {
  memset(s, 0, sizeof *s);
  CHECK(pthread_mutex_init(&s->mutex, NULL) == 0 && pthread_cond_init(&s->changed, NULL) == 0);
  s->model = make_model(context, 0.5);
  CHECK_OK(vbgpd_job_create_strength_reduction(s->model, &s->job));
}

static void end(stage* s) {
  CHECK_OK(vbgpd_job_destroy(s->job));
  CHECK_OK(vbgpd_model_destroy(s->model));
  pthread_cond_destroy(&s->changed);
  pthread_mutex_destroy(&s->mutex);
}

static void announce(stage* s, int* what) {
  pthread_mutex_lock(&s->mutex);
  *what = 1;
  pthread_cond_broadcast(&s->changed);
  pthread_mutex_unlock(&s->mutex);
}

static void await(stage* s, const int* what) {
  pthread_mutex_lock(&s->mutex);
  while (!*what) pthread_cond_wait(&s->changed, &s->mutex);
  pthread_mutex_unlock(&s->mutex);
}

static int32_t VBGPD_CALL hold_still(void* user, const vbgpd_progress* p) {
  stage* s = (stage*)user;
  CHECK(p->struct_size == sizeof *p);
  announce(s, &s->inside);
  await(s, &s->finished);
  ++s->calls;
  return 0;
}

static void* cancel_job(void* user) {
  stage* s = (stage*)user;
  await(s, &s->inside);
  CHECK_OK(vbgpd_job_cancel(s->job));
  announce(s, &s->finished);
  return NULL;
}

static void cancel_from_another_thread(vbgpd_context* context) {
  stage s;
  pthread_t other;
  vbgpd_progress progress;
  begin(&s, context);
  progress.struct_size = sizeof progress;
  CHECK(pthread_create(&other, NULL, cancel_job, &s) == 0);
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_job_run(s.job, 0, hold_still, &s, &progress));
  CHECK(pthread_join(other, NULL) == 0);
  CHECK(s.calls == 1 && progress.steps > 0);
  /* It can go on: the next slice ends by its time, not by the old request. */
  CHECK_STATUS(VBGPD_LIMIT_REACHED, vbgpd_job_run(s.job, 0.01, NULL, NULL, &progress));
  /* A request between two slices is obeyed by the next one, and by that one only. */
  CHECK_OK(vbgpd_job_cancel(s.job));
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_job_run(s.job, 0.01, NULL, NULL, &progress));
  CHECK_STATUS(VBGPD_LIMIT_REACHED, vbgpd_job_run(s.job, 0.01, NULL, NULL, &progress));
  end(&s);
}

static void* cancel_model(void* user) {
  CHECK_OK(vbgpd_model_cancel((vbgpd_model*)user));
  return NULL;
}

static void cancel_stepping(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 2.5);
  vbgpd_advance_result result;
  pthread_t other;
  result.struct_size = sizeof result;
  CHECK(pthread_create(&other, NULL, cancel_model, model) == 0);
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_model_step(model, INT64_C(1) << 50, &result)); /* early or late, it is not lost */
  CHECK(pthread_join(other, NULL) == 0);
  CHECK(result.steps >= 0 && result.steps < INT64_C(1) << 50);
  CHECK_OK(vbgpd_model_step(model, 2, &result));
  CHECK(result.steps == 2 && result.time > 0 && result.time_step > 0);
  CHECK_OK(vbgpd_model_destroy(model));
}

static vbgpd_model* model_to_stop; /* a signal handler has no other way to know it */

static void on_alarm(int number) {
  (void)number;
  vbgpd_model_cancel(model_to_stop);
}

/* The handler interrupts the very thread that is inside the model. */
static void cancel_from_a_signal_handler(vbgpd_context* context) {
  struct sigaction action, before;
  struct itimerval soon;
  model_to_stop = make_model(context, 2.5);
  memset(&action, 0, sizeof action);
  memset(&soon, 0, sizeof soon);
  action.sa_handler = on_alarm;
  soon.it_value.tv_usec = 20000;
  CHECK(sigaction(SIGALRM, &action, &before) == 0);
  CHECK(setitimer(ITIMER_REAL, &soon, NULL) == 0);
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_model_step(model_to_stop, INT64_C(1) << 50, NULL));
  CHECK(sigaction(SIGALRM, &before, NULL) == 0);
  CHECK_OK(vbgpd_model_destroy(model_to_stop));
}

static int32_t VBGPD_CALL stop(void* user, const vbgpd_progress* p) {
  (void)p;
  ++*(int*)user;
  return 1;
}

static int32_t VBGPD_CALL cancel_inside(void* user, const vbgpd_progress* p) {
  (void)p;
  CHECK_OK(vbgpd_job_cancel((vbgpd_job*)user));
  return 0;
}

static void cancel_from_a_callback(vbgpd_context* context) {
  stage s;
  int calls = 0;
  begin(&s, context);
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_job_run(s.job, 0, stop, &calls, NULL));
  CHECK(calls == 1);
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_job_run(s.job, 0, cancel_inside, s.job, NULL));
  end(&s);
}

/* Everything that enters the job or its model must give `expected` while a slice runs. */
static void closed(stage* s, vbgpd_status expected) {
  vbgpd_job* job = NULL;
  double value;
  int64_t n;
  CHECK_STATUS(expected, vbgpd_job_run(s->job, 0.1, NULL, NULL, NULL));
  CHECK_STATUS(expected, vbgpd_job_get_f64(s->job, "steps", 5, &value));
  CHECK_STATUS(expected, vbgpd_job_set_f64(s->job, "levels", 6, 1));
  CHECK_STATUS(expected, vbgpd_job_slip_surface(s->job, NULL, 16, 0, &n));
  CHECK_STATUS(expected, vbgpd_job_error(s->job, NULL, NULL, 0, NULL));
  CHECK_STATUS(expected, vbgpd_job_destroy(s->job));
  CHECK_STATUS(expected, vbgpd_model_step(s->model, 1, NULL));
  CHECK_STATUS(expected, vbgpd_model_get_f64(s->model, "time", 4, &value));
  CHECK_STATUS(expected, vbgpd_model_item_count(s->model, VBGPD_AT_PARTICLE, &n));
  CHECK_STATUS(expected, vbgpd_job_create_equilibrium(s->model, &job));
  CHECK_STATUS(expected, vbgpd_model_error(s->model, NULL, NULL, 0, NULL));
  CHECK_STATUS(expected, vbgpd_model_destroy(s->model));
}

static int32_t VBGPD_CALL call_back_in(void* user, const vbgpd_progress* p) {
  (void)p;
  closed((stage*)user, VBGPD_E_REENTRANT);
  return 1;
}

static void reentry_from_a_callback(vbgpd_context* context) {
  stage s;
  begin(&s, context);
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_job_run(s.job, 0, call_back_in, &s, NULL));
  end(&s);
}

static void* overlap(void* user) {
  stage* s = (stage*)user;
  vbgpd_context* context = NULL;
  vbgpd_model* model;
  await(s, &s->inside);
  closed(s, VBGPD_E_BUSY);
  context = make_context(); /* other objects are free */
  model = make_model(context, 2.5);
  CHECK_OK(vbgpd_model_step(model, 1, NULL));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_context_destroy(context));
  CHECK_OK(vbgpd_job_cancel(s->job));
  announce(s, &s->finished);
  return NULL;
}

static void overlapping_use(vbgpd_context* context) {
  stage s;
  pthread_t other;
  begin(&s, context);
  CHECK(pthread_create(&other, NULL, overlap, &s) == 0);
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_job_run(s.job, 0, hold_still, &s, NULL));
  CHECK(pthread_join(other, NULL) == 0);
  end(&s);
}

/* Two jobs of one model share it: while one runs, the other cannot. */
static int32_t VBGPD_CALL run_the_other(void* user, const vbgpd_progress* p) {
  vbgpd_error_info info;
  (void)p;
  info.struct_size = sizeof info;
  CHECK_STATUS(VBGPD_E_REENTRANT, vbgpd_job_run((vbgpd_job*)user, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_job_error((vbgpd_job*)user, &info, NULL, 0, NULL));
  CHECK(info.status == VBGPD_E_REENTRANT);
  return 1;
}

static void two_jobs_of_one_model(vbgpd_context* context) {
  stage s;
  vbgpd_job* other = NULL;
  begin(&s, context);
  CHECK_OK(vbgpd_job_create_equilibrium(s.model, &other));
  CHECK_STATUS(VBGPD_CANCELLED, vbgpd_job_run(s.job, 0, run_the_other, other, NULL));
  CHECK_OK(vbgpd_job_destroy(other));
  end(&s);
}

enum { rounds = 300 };

static void* hammer_cancel(void* user) {
  int i;
  for (i = 0; i < 100 * rounds; ++i) {
    const vbgpd_status status = vbgpd_model_cancel((vbgpd_model*)user);
    CHECK(status == VBGPD_OK || status == VBGPD_E_HANDLE);
    if (status == VBGPD_E_HANDLE) break;
  }
  return NULL;
}

static void* hammer_read(void* user) {
  int64_t n;
  vbgpd_status status = VBGPD_OK;
  int i;
  for (i = 0; i < 100 * rounds && status != VBGPD_E_HANDLE; ++i) {
    status = vbgpd_model_item_count((vbgpd_model*)user, VBGPD_AT_BOND, &n);
    CHECK(status == VBGPD_OK || status == VBGPD_E_BUSY || status == VBGPD_E_HANDLE);
  }
  return NULL;
}

/* Destroying an object others cancel and read at that moment is safe: they get OK, BUSY or HANDLE. */
static void destroy_under_fire(vbgpd_context* context) {
  int i;
  for (i = 0; i < 20; ++i) {
    vbgpd_model* model = make_model(context, 2.5);
    pthread_t threads[2];
    vbgpd_status status;
    CHECK(pthread_create(&threads[0], NULL, hammer_cancel, model) == 0);
    CHECK(pthread_create(&threads[1], NULL, hammer_read, model) == 0);
    do {
      status = vbgpd_model_destroy(model);
    } while (status == VBGPD_E_BUSY);
    CHECK_STATUS(VBGPD_OK, status);
    CHECK(pthread_join(threads[0], NULL) == 0 && pthread_join(threads[1], NULL) == 0);
  }
}

static void* create_and_destroy(void* unused) {
  int i;
  (void)unused;
  for (i = 0; i < rounds; ++i) {
    vbgpd_context* context = make_context();
    vbgpd_profile* profile = make_profile(context, 1);
    CHECK_OK(vbgpd_context_destroy(context));
    CHECK_OK(vbgpd_profile_destroy(profile));
  }
  return NULL;
}

static void handles_from_many_threads(void) {
  pthread_t threads[4];
  int i;
  for (i = 0; i < 4; ++i) CHECK(pthread_create(&threads[i], NULL, create_and_destroy, NULL) == 0);
  for (i = 0; i < 4; ++i) CHECK(pthread_join(threads[i], NULL) == 0);
}

int main(void) {
  vbgpd_context* context = make_context();
  cancel_from_another_thread(context);
  cancel_stepping(context);
  cancel_from_a_signal_handler(context);
  cancel_from_a_callback(context);
  reentry_from_a_callback(context);
  overlapping_use(context);
  two_jobs_of_one_model(context);
  destroy_under_fire(context);
  handles_from_many_threads();
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
