#include "geometry/jitter.h"

namespace vbgpd {
namespace {

/// Uniform in [-1, 1): splitmix64 (Steele, Lea & Flood 2014) of a cell and an axis.
Real uniform(Index ix, Index iy, unsigned axis) {
  std::uint64_t z = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(ix)) << 32) | static_cast<std::uint32_t>(iy);
  z = 2 * z + axis + 1;
  z *= 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  z ^= z >> 31;
  return static_cast<Real>(z >> 11) * 0x1p-52 - 1;
}

}  // namespace

void jitter(Real amplitude, Section& section) {
  section.shifts.clear();
  if (!(amplitude > 0)) return;
  const Vec2& spacing = section.lattice.spacing;
  section.shifts.assign(section.seeds.size(), Vec2::Zero());
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    const Seed& s = section.seeds[k];
    if (s.hold != Hold::kFree || s.volume < (1 - 1e-9) * spacing.prod()) continue;
    section.shifts[k] = amplitude * spacing.cwiseProduct(Vec2(uniform(s.ix, s.iy, 0), uniform(s.ix, s.iy, 1)));
  }
}

}  // namespace vbgpd
