// Run-out models: made from another model, and the ground as it is now.
#include "convert.h"
#include "guard.h"
#include "simulation/flow_simulation.h"

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_model_create_runout(const vbgpd_model* from, vbgpd_model** out) {
  return with(from, [&](ModelObject& source) {
    require_not_null(out, 2, "out");
    auto model = std::make_unique<ModelObject>();
    model->engine->simulation = make_runout(*source.engine->simulation);
    hand_out(std::move(model), out);
    return Status::kOk;
  });
}
