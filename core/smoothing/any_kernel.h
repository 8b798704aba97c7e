// The list of kernels, by name.
#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "smoothing/kernels.h"

namespace vbgpd {

/// The kernel of that name, or nothing.
inline std::optional<AnyKernel> kernel_by_name(std::string_view name) {
  std::optional<AnyKernel> found;
  auto look = [&]<class... K>(std::variant<K...>*) { ((K::name == name ? (void)(found = K{}) : void()), ...); };
  look(static_cast<AnyKernel*>(nullptr));
  return found;
}

inline Real value(const AnyKernel& kernel, Real r, Real h) {
  return std::visit([&](auto k) { return decltype(k)::value(r, h); }, kernel);
}

}  // namespace vbgpd
