// A C++ host whose progress function throws: the exception ends at the library, which stays usable.
#include <stdexcept>

#include "slope.h"

static int32_t VBGPD_CALL throw_something(void*, const vbgpd_progress*) { throw std::runtime_error("from the host"); }

static void VBGPD_CALL throw_a_line(void* user, const vbgpd_log_line*, const char*) {
  ++*static_cast<int*>(user);
  throw std::runtime_error("from the host");
}

int main() {
  vbgpd_context* context = make_context();
  vbgpd_model* model = make_model(context, 0.5);
  vbgpd_job* job = nullptr;
  vbgpd_error_info info;
  info.struct_size = sizeof info;
  CHECK_OK(vbgpd_job_create_strength_reduction(model, &job));
  CHECK_STATUS(VBGPD_E_INTERNAL, vbgpd_job_run(job, 0, throw_something, nullptr, nullptr));
  CHECK_OK(vbgpd_job_error(job, &info, nullptr, 0, nullptr));
  CHECK(info.status == VBGPD_E_INTERNAL && info.argument == 3);
  CHECK_STATUS(VBGPD_LIMIT_REACHED, vbgpd_job_run(job, 0.01, nullptr, nullptr, nullptr));
  CHECK(model_number(model, "particles") > 0);
  int thrown = 0;
  CHECK_OK(vbgpd_context_set_log(context, throw_a_line, &thrown, VBGPD_LOG_DETAIL));
  CHECK_STATUS(VBGPD_LIMIT_REACHED, vbgpd_job_run(job, 0.01, nullptr, nullptr, nullptr));
  vbgpd_model* other = make_model(context, 2);
  CHECK(thrown > 0);
  CHECK_OK(vbgpd_model_destroy(other));
  CHECK_OK(vbgpd_job_destroy(job));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
