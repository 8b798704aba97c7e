// Zero-copy views: the arrays of a model on loan.
#include <algorithm>

#include "convert.h"
#include "guard.h"
#include "selection.h"

using namespace vbgpd;
using namespace vbgpd::capi;

vbgpd_status vbgpd_model_view_acquire(vbgpd_model* model, int32_t field, vbgpd_view* view) {
  return with(model, [&](ModelObject& object) {
    require_struct(view, 3);
    Engine& engine = *object.engine;
    const FieldInfo& info = field_in(field, 2);
    const FieldView lent = engine.simulation->view(field);
    vbgpd_view told{};
    told.struct_size = sizeof told;
    told.type = static_cast<std::int32_t>(info.type);
    told.data = lent.data;
    told.count = lent.count, told.components = info.components;
    told.stride_item = lent.stride_item;
    told.stride_component = info.components > 1 ? lent.stride_component : lent.stride_item;
    told.epoch = engine.simulation->epoch();
    told.lease = engine.last_lease + 1;
    engine.leases.push_back(told.lease);
    engine.last_lease = told.lease;
    fill(view, told);
    return Status::kOk;
  });
}

vbgpd_status vbgpd_model_view_release(vbgpd_model* model, int64_t lease) {
  return with(model, [&](ModelObject& object) {
    auto& leases = object.engine->leases;
    const auto found = std::find(leases.begin(), leases.end(), lease);
    if (found == leases.end())
      throw ArgumentError(2, Status::kArgument, "There is no lease " + std::to_string(lease) + ", or it has ended.");
    leases.erase(found);
    return Status::kOk;
  });
}
