#include <algorithm>
#include <cstring>

#include "state/flow_model.h"

namespace vbgpd {

namespace {

template <class T, class A>
std::size_t bytes_of(const std::vector<T, A>& v) {
  return v.capacity() * sizeof(T);
}
std::size_t bytes_of(std::initializer_list<const Array*> arrays) {
  std::size_t sum = 0;
  for (const Array* a : arrays) sum += a->bytes();
  return sum;
}

}  // namespace

std::size_t FlowModel::bytes() const {
  return bytes_of({&volume, &mass, &force_x, &force_y, &weight, &surface_area, &reference_x, &reference_y, &size,
                   &extra_cohesion}) +
         bytes_of(material) + bytes_of(walls);
}

std::size_t FlowLists::bytes() const {
  return bytes_of(rows) + bytes_of(neighbours) + bytes_of(ghosts) + bytes_of(soil) + bytes_of(group) +
         bytes_of(touching) + bytes_of({&constants, &volume, &force, &extra_cohesion, &pore_pressure});
}

std::size_t FlowScratch::bytes() const {
  return bytes_of({&motion, &next_motion, &next_stress, &gradient, &bond, &inverse, &flux, &slope_x, &slope_y,
                   &artificial, &pair_force, &weight, &pairs});
}

void FlowState::allocate(const FlowModel& m) {
  const auto n = static_cast<std::size_t>(m.particles);
  motion.allocate(4 * n, 1, m.heap);
  stress.allocate(4 * (n + 1), 2, m.heap);
  gap.allocate(n, 3, m.heap);
  plastic_strain.allocate(n, 4, m.heap);
  wall_shear.allocate(m.walls.empty() ? 0 : n, 5, m.heap);
  const bool slides = std::any_of(m.walls.begin(), m.walls.end(), [](const FlowWall& w) { return w.friction >= 0; });
  wall_limit.allocate(slides ? n : 0, 10, m.heap);
  particle.allocate(n, 6, m.heap);
  listed.allocate(2 * n, 7, m.heap);
  dead.allocate(m.bond == FlowBondLaw::kGpd ? n : 0, 9, m.heap);
}

std::size_t FlowState::bytes() const {
  std::size_t sum = 0;
  for_each_array(*this, [&](const char*, const Array& a) { sum += a.bytes(); });
  return sum;
}

/// FNV-1a over 64-bit words of every present array, in the order of the list.
std::uint64_t FlowState::hash() const {
  std::uint64_t h = 14695981039346656037ull;
  for_each_array(*this, [&](const char*, const Array& a) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double value = a[i] + 0.0;  // -0 and 0 are the same state
      std::uint64_t word;
      std::memcpy(&word, &value, sizeof word);
      h = (h ^ word) * 1099511628211ull;
    }
  });
  return h;
}

}  // namespace vbgpd
