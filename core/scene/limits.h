// How much a scene may hold. Generous for any section, small enough that a hostile file cannot exhaust the host.
#pragma once

#include <cstddef>

namespace vbgpd {

inline constexpr std::size_t kMaxSceneBytes = std::size_t{64} << 20;  ///< of text or of a buffer
inline constexpr std::size_t kMaxPoints = 1000000;                    ///< of one outline
inline constexpr std::size_t kMaxObjects = 100000;   ///< soils, layers, boundaries, loads, published values: of each
inline constexpr std::size_t kMaxTables = 2000000;   ///< points and objects together
inline constexpr std::size_t kMaxTextBytes = 65536;  ///< of one name or source
inline constexpr std::size_t kMaxAllTextBytes = std::size_t{16}
                                                << 20;  ///< together: a buffer may point at one text many times
inline constexpr std::size_t kMaxCheckpointBytes = (std::size_t{1} << 31) - (std::size_t{1} << 20);

}  // namespace vbgpd
