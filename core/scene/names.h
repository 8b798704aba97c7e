// The names a scene may use: those of the engine's own lists.
#pragma once

#include <array>
#include <string_view>
#include <type_traits>
#include <variant>

#include "bond/bond_law.h"
#include "material/any_law.h"
#include "scene/scene_def.h"
#include "smoothing/any_kernel.h"

namespace vbgpd {

template <class... T>
constexpr std::array<std::string_view, sizeof...(T)> names_in(std::type_identity<std::variant<T...>>) {
  return {T::name...};
}
inline constexpr auto kLawNames = names_in(std::type_identity<AnyLaw>{});
inline constexpr auto kKernelNames = names_in(std::type_identity<AnyKernel>{});
inline constexpr auto kBondNames = [] {
  std::array<std::string_view, kBondLaws.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kBondLaws[i].name;
  return names;
}();

/// Whether a soil may yield; of a law that nobody knows (validate says so) nothing better is assumed.
inline bool yields(const MaterialDef& m) {
  const auto law = law_by_name(m.law);
  return !law || yields(*law);
}

}  // namespace vbgpd
