/* The log of a context: what is said, in what order, and that reading takes nothing away. */
#include <pthread.h>

#include "slope.h"

static vbgpd_log_line line;
static char text[248];

static vbgpd_status next_line(vbgpd_context* context, int64_t after) {
  line.struct_size = sizeof line;
  return vbgpd_context_log_next(context, after, &line, text, sizeof text, NULL);
}

/* How many lines of a level hold a part; level 0 = any. */
static int lines_with(vbgpd_context* context, int32_t level, const char* part) {
  int found = 0;
  int64_t after = 0;
  double seconds = 0;
  while (next_line(context, after) == VBGPD_OK) {
    CHECK(line.sequence > after && line.seconds >= seconds && line.level >= 1 && line.level <= 3 && text[0] != 0);
    after = line.sequence, seconds = line.seconds;
    found += (level == 0 || line.level == level) && strstr(text, part) != NULL;
  }
  return found;
}

static void models_and_jobs_speak(void) {
  vbgpd_context *context = make_context(), *other = make_context();
  vbgpd_model* model;
  vbgpd_job* job = NULL;
  char isa[50];
  int64_t needed = -1, trials;
  double levels;
  CHECK_STATUS(VBGPD_END_OF_DATA, next_line(context, 0));
  model = make_model(context, 1);
  CHECK_OK(next_line(context, 0));
  CHECK(line.level == VBGPD_LOG_INFO && line.sequence == 1);
  CHECK_OK(vbgpd_build_info("instruction_set", VBGPD_STRLEN, isa, sizeof isa, NULL));
  CHECK_CONTAINS(text, isa);
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "levels", VBGPD_STRLEN, 2));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  trials = (int64_t)job_number(job, "trials"), levels = job_number(job, "levels");
  CHECK(lines_with(context, VBGPD_LOG_INFO, "Model of") == 2); /* its own grid and the coarse one */
  CHECK(lines_with(context, 0, "the slope stands at factor") + lines_with(context, 0, "the slope fails at factor") +
            lines_with(context, VBGPD_LOG_WARNING, "the slope is undecided at factor") ==
        trials);
  CHECK(lines_with(context, VBGPD_LOG_INFO, "the slope stands at") == (int)levels);
  CHECK(lines_with(context, VBGPD_LOG_DETAIL, "slip surface") == (int)levels);
  CHECK(lines_with(context, VBGPD_LOG_INFO, "The job ended: OK, factor of safety") == 1);
  CHECK_STATUS(VBGPD_END_OF_DATA, next_line(other, 0)); /* what happens in one context is no business of another */
  /* a job that is asked once more has nothing new to say */
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK(lines_with(context, 0, "The job ended") == 1);
  /* buffers as everywhere */
  text[0] = '*';
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_context_log_next(context, 0, &line, text, 5, &needed));
  CHECK(text[0] == '*' && needed > 5 && needed <= 247);
  CHECK_OK(vbgpd_context_log_next(context, 0, NULL, NULL, 0, &needed));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_context_log_next(context, 0, &line, text, -1, &needed));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_context_destroy(context));
  CHECK_OK(vbgpd_model_step(model, 1, NULL)); /* the model goes on without anybody who could listen */
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_context_destroy(other));
}

static void warnings_are_heard(void) {
  vbgpd_context* context = make_context();
  vbgpd_profile* profile = make_profile(context, 2.5);
  static const double buried[] = {1, 1, 3, 1, 3, 2, 1, 2};
  vbgpd_model* model = NULL;
  vbgpd_job* job = NULL;
  int64_t hidden = -1, warnings = 0;
  CHECK_OK(vbgpd_profile_add_layer(profile, buried, 16, 4, 0, &hidden));
  CHECK_OK(vbgpd_profile_add_layer(profile, NULL, 16, 0, 0, &hidden)); /* paints over it */
  CHECK_OK(vbgpd_profile_validate(profile, NULL, &warnings));
  CHECK(warnings > 0);
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  CHECK(lines_with(context, VBGPD_LOG_WARNING, "") >= (int)warnings);
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "srf_max", VBGPD_STRLEN, 0.2));
  CHECK_STATUS(VBGPD_NOT_CONVERGED, vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK(lines_with(context, VBGPD_LOG_WARNING, "The job ended: ABOVE_MAX") == 1);
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_context_destroy(context));
}

/* Of more lines than are kept the last ones stay, and the gap shows in the sequence. */
static void old_lines_give_way(void) {
  vbgpd_context* context = make_context();
  vbgpd_profile* profile = make_profile(context, 5);
  int i, kept = 0;
  int64_t after;
  for (i = 0; i < 300; ++i) {
    vbgpd_model* model = NULL;
    CHECK_OK(vbgpd_model_create(context, profile, &model));
    CHECK_OK(vbgpd_model_destroy(model));
  }
  CHECK_OK(next_line(context, 0));
  CHECK(line.sequence > 1);
  for (after = 0; next_line(context, after) == VBGPD_OK; after = line.sequence) ++kept;
  CHECK(kept == 256 && after >= 300);
  CHECK_STATUS(VBGPD_END_OF_DATA, next_line(context, after));
  CHECK_STATUS(VBGPD_END_OF_DATA, next_line(context, INT64_MAX));
  CHECK_OK(next_line(context, INT64_MIN));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_context_destroy(context));
}

static void* run_to_the_end(void* job) {
  CHECK(vbgpd_job_run((vbgpd_job*)job, 0, NULL, NULL, NULL) >= 0);
  return NULL;
}

/* Jobs on several threads speak to one context while another thread reads: every line is whole and has its own number.
 */
static void many_threads_speak_at_once(void) {
  enum { speakers = 3 };
  vbgpd_context* context = make_context();
  vbgpd_model* models[speakers];
  vbgpd_job* jobs[speakers];
  pthread_t threads[speakers];
  int i, ended = 0;
  int64_t after = 0;
  for (i = 0; i < speakers; ++i) {
    models[i] = make_model(context, 2.5);
    jobs[i] = NULL;
    CHECK_OK(vbgpd_job_create_strength_reduction(models[i], &jobs[i]));
  }
  for (i = 0; i < speakers; ++i) CHECK(pthread_create(&threads[i], NULL, run_to_the_end, jobs[i]) == 0);
  while (ended < speakers) {
    if (next_line(context, after) != VBGPD_OK) continue;
    CHECK(line.sequence == after + 1 &&
          (line.level == VBGPD_LOG_WARNING || text[strlen(text) - 1] == '.' || strlen(text) == 247));
    after = line.sequence;
    ended += strstr(text, "The job ended") != NULL;
  }
  for (i = 0; i < speakers; ++i) {
    CHECK(pthread_join(threads[i], NULL) == 0);
    CHECK_OK(vbgpd_job_destroy(jobs[i]));
    CHECK_OK(vbgpd_model_destroy(models[i]));
  }
  CHECK_OK(vbgpd_context_destroy(context));
}

/* Lines told as they are said are those that can be polled, on the thread inside the call; who listens may read, not
 * change. */
typedef struct {
  vbgpd_context* context;
  vbgpd_job* job;
  pthread_t thread;
  int64_t last;
  int lines, nested, busy;
} ear;

static void* change_from_elsewhere(void* context) {
  CHECK_STATUS(VBGPD_E_BUSY, vbgpd_context_set_log((vbgpd_context*)context, NULL, NULL, VBGPD_LOG_INFO));
  return NULL;
}

static void VBGPD_CALL hear(void* user, const vbgpd_log_line* told, const char* words) {
  ear* e = (ear*)user;
  ++e->lines;
  CHECK(pthread_equal(e->thread, pthread_self()));
  CHECK(told->struct_size == sizeof *told && told->sequence > e->last && told->level <= VBGPD_LOG_INFO);
  e->last = told->sequence;
  if (e->job == NULL) return; /* a model is being made: the context is inside a call */
  CHECK_OK(next_line(e->context, told->sequence - 1));
  CHECK(line.sequence == told->sequence && line.level == told->level && strcmp(text, words) == 0);
  CHECK_STATUS(VBGPD_E_REENTRANT, vbgpd_context_set_log(e->context, NULL, NULL, VBGPD_LOG_INFO));
  CHECK_STATUS(VBGPD_E_REENTRANT, vbgpd_job_run(e->job, 0, NULL, NULL, NULL));
  if (e->busy++ == 0) {
    vbgpd_model* nested = make_model(e->context, 5); /* says something of its own, which is kept only */
    pthread_t other;
    CHECK_OK(vbgpd_model_destroy(nested));
    while (next_line(e->context, e->last) == VBGPD_OK) e->last = line.sequence, ++e->nested;
    CHECK(e->nested > 0);
    CHECK(pthread_create(&other, NULL, change_from_elsewhere, e->context) == 0);
    CHECK(pthread_join(other, NULL) == 0);
  }
}

static void told_as_they_are_said(void) {
  vbgpd_context* context = make_context();
  vbgpd_model* model;
  vbgpd_job* job = NULL;
  ear e;
  int kept;
  memset(&e, 0, sizeof e);
  e.context = context, e.thread = pthread_self();
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_context_set_log(context, hear, &e, 0));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_context_set_log(context, hear, &e, 4));
  CHECK_OK(vbgpd_context_set_log(context, hear, &e, VBGPD_LOG_INFO));
  model = make_model(context, 1);
  CHECK(e.lines == 2); /* its size, and a warning that key lines lie off the cell edges */
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  e.job = job;
  CHECK(vbgpd_job_run(job, 0, NULL, NULL, NULL) >= 0);
  kept = lines_with(context, VBGPD_LOG_INFO, "") + lines_with(context, VBGPD_LOG_WARNING, "");
  CHECK(e.lines > 4 && e.lines == kept - e.nested);
  kept = e.lines;
  CHECK_OK(vbgpd_context_set_log(context, hear, &e, VBGPD_LOG_WARNING));
  e.job = NULL;
  CHECK_OK(vbgpd_model_destroy(make_model(context, 1)));
  CHECK(e.lines == kept + 1);
  kept = e.lines;
  CHECK_OK(vbgpd_context_set_log(context, NULL, NULL, 0)); /* ends it, at whatever level */
  CHECK_OK(vbgpd_model_destroy(make_model(context, 1)));
  CHECK(e.lines == kept);
  CHECK_OK(vbgpd_context_set_log(context, hear, &e, VBGPD_LOG_INFO));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_job_create_equilibrium(model, &job));
  CHECK_OK(vbgpd_context_destroy(context)); /* nobody is told any more */
  CHECK(vbgpd_job_run(job, 0, NULL, NULL, NULL) >= 0);
  CHECK(e.lines == kept);
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
}

int main(void) {
  models_and_jobs_speak();
  warnings_are_heard();
  old_lines_give_way();
  many_threads_speak_at_once();
  told_as_they_are_said();
  return 0;
}
