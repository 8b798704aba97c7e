#include <cstring>

#include "state/model.h"

namespace vbgpd {

namespace {

template <class T, class A>
std::size_t bytes_of(const std::vector<T, A>& v) {
  return v.capacity() * sizeof(T);
}

}  // namespace

void Model::take_from(const Heap& from) {
  heap = from;
  use(blocks, heap), use(neighbours, heap), use(packs, heap), use(pair_weight, heap);
  use(material, heap), use(seed_of, heap), use(storage_of, heap), use(id_of, heap);
}

std::size_t Model::bytes() const {
  std::size_t sum = bytes_of(offsets) + bytes_of(blocks) + bytes_of(neighbours) + bytes_of(packs) + bytes_of(chunks) +
                    bytes_of(guided) + bytes_of(material) + bytes_of(seed_of) + bytes_of(storage_of) + bytes_of(id_of) +
                    bytes_of(pair_weight);
  for (const Array* a :
       {&volume, &share, &moment_xx, &moment_xy, &moment_yy, &sum_x, &sum_y, &force_x, &force_y, &free_x, &free_y,
        &mass, &scaled_mass, &extra_cohesion, &compressibility, &place_x, &place_y})
    sum += a->bytes();
  return sum;
}

namespace {

Offset off_lattice_offset(const Model& m, std::int32_t first, std::int32_t second, std::int32_t record, int l) {
  const auto i = static_cast<std::size_t>(first + l), j = static_cast<std::size_t>(second + l);
  const auto place = static_cast<std::size_t>(record) * static_cast<std::size_t>(m.width) + static_cast<std::size_t>(l);
  const Real weight = m.pair_weight[place];
  return offset_of(m.place_x[j] - m.place_x[i], m.place_y[j] - m.place_y[i], weight);
}

}  // namespace

Offset Model::offset(const BondPack& pack, int l) const {
  if (!off_lattice()) return offsets[pack.offset];
  if (pack.i == pack.j) return {};  // particles that yield themselves
  return off_lattice_offset(*this, pack.i, pack.j, pack.slot, l);
}

Offset Model::offset(std::int32_t k, const Block& block, int l) const {
  const NeighbourPack& pack = neighbours[static_cast<std::size_t>(k)];
  if (!off_lattice()) return offsets[pack.offset];
  return off_lattice_offset(*this, block.first, pack.j, weight_record(block, k, forward_packs), l);
}

void State::allocate(const Model& m) {
  const auto n = static_cast<std::size_t>(m.storage);
  displacement_x.allocate(n, 1, m.heap);
  displacement_y.allocate(n, 2, m.heap);
  velocity_x.allocate(n, 3, m.heap);
  velocity_y.allocate(n, 4, m.heap);
  plastic_volume.allocate(m.features.volumetric_plastic ? n : 0, 5, m.heap);
  gap.allocate(m.features.volumetric_plastic ? n : 0, 8, m.heap);
  const std::size_t records =
      m.features.bond == BondLaw::kNone ? n : static_cast<std::size_t>(m.slots) * static_cast<std::size_t>(m.width);
  plastic_strain.allocate(m.features.plastic ? 3 * records : 0, 6, m.heap);
  placed_strain.allocate(m.features.placed ? 3 * records : 0, 12, m.heap);
}

void State::take_motion(const State& other) {
  displacement_x = other.displacement_x, displacement_y = other.displacement_y;
  velocity_x = other.velocity_x, velocity_y = other.velocity_y;
  plastic_volume = other.plastic_volume, gap = other.gap;
}

std::size_t State::bytes() const {
  std::size_t sum = 0;
  for_each_array(*this, [&](const char*, const Array& a) { sum += a.bytes(); });
  return sum;
}

/// FNV-1a over 64-bit words of every present array, in the order of the list.
std::uint64_t State::hash() const {
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

void Scratch::allocate(const Model& m) {
  const auto n = static_cast<std::size_t>(m.storage);
  int stagger = 7;
  for (Array* a : {&weighted_x, &weighted_y, &gradient_xx, &gradient_xy, &gradient_yx, &gradient_yy, &dilation,
                   &flux_xx, &flux_xy, &flux_yx, &flux_yy, &pair_force_x, &pair_force_y})
    a->allocate(n, stagger++, m.heap);
  volume_source.allocate(m.features.dilatant ? n : 0, stagger++, m.heap);
  if (m.features.bond == BondLaw::kNone) pair_force_x.allocate(0, 0), pair_force_y.allocate(0, 0);
}

void Scratch::keep_books(const Model& m) {
  const auto n = static_cast<std::size_t>(m.storage);
  if (m.features.volumetric_plastic && !opening.present()) opening.allocate(n, 21, m.heap);
  if (m.features.dilatant && !mean_load.present()) mean_load.allocate(n, 22, m.heap);
}

std::size_t Scratch::bytes() const {
  std::size_t sum = 0;
  for (const Array* a :
       {&weighted_x, &weighted_y, &gradient_xx, &gradient_xy, &gradient_yx, &gradient_yy, &dilation, &flux_xx, &flux_xy,
        &flux_yx, &flux_yy, &pair_force_x, &pair_force_y, &volume_source, &opening, &mean_load})
    sum += a->bytes();
  return sum;
}

}  // namespace vbgpd
