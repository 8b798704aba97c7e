/* What is left after a job diverged, a grid was too coarse, a state was restored: what the header says. */
#include <math.h>
#include <string.h>

#include "slope.h"

static void a_diverged_equilibrium_leaves_the_last_good_state(vbgpd_context* context) {
  vbgpd_profile* profile = make_profile(context, 1.0);
  vbgpd_model* model = NULL;
  vbgpd_job* job = NULL;
  uint64_t before = 0, after = 1;
  CHECK_OK(vbgpd_profile_add_boundary(profile, "left", VBGPD_STRLEN, NULL, 16, 0, VBGPD_BOUNDARY_ROLLER, NULL));
  CHECK_OK(vbgpd_profile_add_boundary(profile, "right", VBGPD_STRLEN, NULL, 16, 0, VBGPD_BOUNDARY_ROLLER, NULL));
  CHECK_OK(vbgpd_model_create(context, profile, &model)); /* nothing holds it up */
  CHECK_OK(vbgpd_model_state_hash(model, &before));
  CHECK_OK(vbgpd_job_create_equilibrium(model, &job));
  CHECK(vbgpd_job_run(job, 0, NULL, NULL, NULL) == VBGPD_E_DIVERGED);
  CHECK_OK(vbgpd_model_state_hash(model, &after));
  CHECK(after == before);
  CHECK(model_number(model, "max_displacement") == 0);
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_profile_destroy(profile));
}

static void grids_too_coarse_for_the_section_are_left_out(vbgpd_context* context) {
  char reason[2048];
  vbgpd_model* model = make_model(context, 2.0);
  vbgpd_job* job = NULL;
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "levels", VBGPD_STRLEN, 5));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK(job_number(job, "factor_of_safety") > 0.5);
  CHECK(job_number(job, "levels") >= 2 && job_number(job, "levels") < 5);
  CHECK_OK(vbgpd_job_get_text(job, "reason", VBGPD_STRLEN, reason, sizeof reason, NULL));
  CHECK(strstr(reason, "a coarser grid is left out (spacing = ") != NULL);
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
}

static void a_profile_with_too_large_a_spacing_is_invalid(vbgpd_context* context) {
  vbgpd_profile* profile = make_profile(context, 20.0);
  vbgpd_model* model = NULL;
  int64_t errors = 0;
  CHECK_OK(vbgpd_profile_validate(profile, &errors, NULL));
  CHECK(errors == 1);
  CHECK(vbgpd_model_create(context, profile, &model) == VBGPD_E_RANGE);
  CHECK_OK(vbgpd_profile_destroy(profile));
}

static void a_name_no_file_could_hold_is_invalid(vbgpd_context* context) {
  vbgpd_profile* profile = make_profile(context, 1.0);
  int64_t errors = 0, soil = -1;
  CHECK_OK(vbgpd_profile_add_material(profile, "so\x01il", 5, &soil));
  vbgpd_profile_validate(profile, &errors, NULL);
  CHECK(errors >= 1);
  CHECK_OK(vbgpd_profile_destroy(profile));
}

static void a_restored_state_brings_damping_and_time_step_back(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 2.0);
  vbgpd_state* state = NULL;
  CHECK_OK(vbgpd_model_set_f64(model, "damping", VBGPD_STRLEN, 0.3));
  CHECK_OK(vbgpd_model_set_f64(model, "time_step_factor", VBGPD_STRLEN, 0.5));
  CHECK_OK(vbgpd_model_save_state(model, &state));
  CHECK_OK(vbgpd_model_set_f64(model, "damping", VBGPD_STRLEN, 0.8));
  CHECK_OK(vbgpd_model_set_f64(model, "time_step_factor", VBGPD_STRLEN, 0.6));
  CHECK_OK(vbgpd_model_restore_state(model, state));
  CHECK(model_number(model, "damping") == 0.3);
  CHECK(model_number(model, "time_step_factor") == 0.5);
  CHECK_OK(vbgpd_state_destroy(state));
  vbgpd_model* runout = NULL;
  CHECK_OK(vbgpd_model_create_runout(model, &runout));
  CHECK_OK(vbgpd_model_set_f64(runout, "damping", VBGPD_STRLEN, 0.2));
  state = NULL;
  CHECK_OK(vbgpd_model_save_state(runout, &state));
  CHECK_OK(vbgpd_model_set_f64(runout, "damping", VBGPD_STRLEN, 0.7));
  CHECK_OK(vbgpd_model_restore_state(runout, state));
  CHECK(model_number(runout, "damping") == 0.2);
  CHECK_OK(vbgpd_state_destroy(state));
  CHECK_OK(vbgpd_model_destroy(runout));
  CHECK_OK(vbgpd_model_destroy(model));
}

static void the_energy_books_begin_anew_after_a_relaxation(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 1.0);
  vbgpd_job* job = NULL;
  CHECK_OK(vbgpd_job_create_equilibrium(model, &job));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK(model_number(model, "elastic_energy") > 0);
  CHECK(model_number(model, "energy_residual") == 0);
  CHECK_OK(vbgpd_model_set_f64(model, "kh", VBGPD_STRLEN, 0.05));
  CHECK_OK(vbgpd_model_step(model, 100, NULL));
  CHECK(fabs(model_number(model, "external_work")) > 0);
  CHECK(model_number(model, "energy_residual") < 1e-3);
  CHECK_OK(vbgpd_model_destroy(model));
}

static void a_job_refused_for_its_options_leaves_the_model_free(vbgpd_context* context) {
  vbgpd_model* model = make_model(context, 2.0);
  vbgpd_job* job = NULL;
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_OK(vbgpd_job_set_f64(job, "srf_min", VBGPD_STRLEN, 2));
  CHECK_OK(vbgpd_job_set_f64(job, "srf_max", VBGPD_STRLEN, 1));
  CHECK_STATUS(VBGPD_E_RANGE, vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_model_step(model, 1, NULL));
  CHECK_OK(vbgpd_job_set_f64(job, "srf_max", VBGPD_STRLEN, 3)); /* put right, it runs */
  CHECK_OK(vbgpd_job_set_f64(job, "srf_min", VBGPD_STRLEN, 0.5));
  CHECK_OK(vbgpd_job_run(job, 0, NULL, NULL, NULL));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
}

int main(void) {
  vbgpd_context* context = make_context();
  a_diverged_equilibrium_leaves_the_last_good_state(context);
  grids_too_coarse_for_the_section_are_left_out(context);
  a_profile_with_too_large_a_spacing_is_invalid(context);
  a_name_no_file_could_hold_is_invalid(context);
  a_restored_state_brings_damping_and_time_step_back(context);
  the_energy_books_begin_anew_after_a_relaxation(context);
  a_job_refused_for_its_options_leaves_the_model_free(context);
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
