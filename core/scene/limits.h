// How much a scene may hold. Generous for any section, small enough that a hostile file cannot exhaust the host.
#pragma once

#include <cstddef>
#include <string_view>

namespace vbgpd {

inline constexpr std::size_t kMaxSceneBytes = std::size_t{64} << 20;  ///< of text or of a buffer
inline constexpr std::size_t kMaxPoints = 1000000;                    ///< of one outline
inline constexpr std::size_t kMaxObjects = 100000;   ///< layers, boundaries, loads, published values: of each
inline constexpr std::size_t kMaxSoils = 256;        ///< bonds number the pairs of soils in 16 bits
inline constexpr std::size_t kMaxTables = 2000000;   ///< points and objects together
inline constexpr std::size_t kMaxTextBytes = 65536;  ///< of one name or source
inline constexpr std::size_t kMaxAllTextBytes = std::size_t{16}
                                                << 20;  ///< together: a buffer may point at one text many times
inline constexpr std::size_t kMaxCheckpointBytes = (std::size_t{1} << 31) - (std::size_t{1} << 20);

/// Where a name stops being plain text: its first control character, npos where it has none.
inline std::size_t control_in(std::string_view name) {
  std::size_t at = 0;
  while (at < name.size() && (static_cast<unsigned char>(name[at]) >= ' ' || name[at] == '\n' || name[at] == '\t'))
    ++at;
  return at < name.size() ? at : std::string_view::npos;
}

}  // namespace vbgpd
