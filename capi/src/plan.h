// Forecasts by name, for the named numbers of a model.
#pragma once

#include <optional>
#include <string_view>

#include "objects.h"

namespace vbgpd::capi {

/// "forecast_seconds" ...; nothing for any other name. Runs a few steps and puts the state back.
std::optional<double> forecast_of(const Engine& engine, std::string_view name);

}  // namespace vbgpd::capi
