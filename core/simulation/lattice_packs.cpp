#include "simulation/lattice_packs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

namespace vbgpd {

namespace {

/// Lines of cells along x or along y; `at` finds the storage index of a cell.
class Lines {
 public:
  Lines(const Section& section, int width, bool along_x) : width_(width), along_x_(along_x) {
    Index min_x = 0, max_x = 0, min_y = 0, max_y = 0;
    if (!section.seeds.empty()) {
      min_x = max_x = section.seeds[0].ix, min_y = max_y = section.seeds[0].iy;
      for (const Seed& s : section.seeds) {
        min_x = std::min(min_x, s.ix), max_x = std::max(max_x, s.ix);
        min_y = std::min(min_y, s.iy), max_y = std::max(max_y, s.iy);
      }
    }
    first_ = along_x_ ? min_y : min_x;
    const Index last = along_x_ ? max_y : max_x;
    low_.assign(static_cast<std::size_t>(last - first_ + 1), 0);
    high_.assign(low_.size(), -1);
    for (const Seed& s : section.seeds) {
      const auto c = static_cast<std::size_t>(major(s) - first_);
      if (high_[c] < low_[c]) low_[c] = high_[c] = minor(s);
      low_[c] = std::min(low_[c], minor(s)), high_[c] = std::max(high_[c], minor(s));
    }
    // every line is followed by at least width - 1 cells without volume, so that packs may read past its ends
    std::int32_t next = width;
    for (std::size_t c = 0; c < low_.size(); ++c) {
      start_.push_back(next);
      if (high_[c] >= low_[c]) next += (high_[c] - low_[c] + 1 + 2 * (width - 1)) / width * width;
    }
    storage_ = next + width;
  }
  Index major(const Seed& s) const { return along_x_ ? s.iy : s.ix; }
  Index minor(const Seed& s) const { return along_x_ ? s.ix : s.iy; }
  std::int32_t at(const Seed& s) const { return index(major(s), minor(s)); }
  /// Storage index a cell would have, also a little outside its line; -1 when there is no such line.
  std::int32_t index(Index line, Index cell) const {
    const Index c = line - first_;
    if (c < 0 || c >= static_cast<Index>(low_.size()) ||
        high_[static_cast<std::size_t>(c)] < low_[static_cast<std::size_t>(c)])
      return -1;
    return start_[static_cast<std::size_t>(c)] + cell - low_[static_cast<std::size_t>(c)];
  }
  /// True when cells cell .. cell + width - 1 of a line touch what the line holds.
  bool touches(Index line, Index cell) const {
    const auto c = static_cast<std::size_t>(line - first_);
    return cell + width_ - 1 >= low_[c] && cell <= high_[c];
  }
  bool along_x() const { return along_x_; }
  std::int32_t storage() const { return storage_; }
  std::size_t count() const { return low_.size(); }
  Index line(std::size_t c) const { return first_ + static_cast<Index>(c); }
  Index low(std::size_t c) const { return low_[c]; }
  Index high(std::size_t c) const { return high_[c]; }
  Index longest() const {
    Index longest = 0;
    for (std::size_t c = 0; c < low_.size(); ++c) longest = std::max(longest, high_[c] - low_[c] + 1);
    return longest;
  }

 private:
  int width_;
  bool along_x_;
  Index first_ = 0;
  std::vector<Index> low_, high_;
  std::vector<std::int32_t> start_;
  std::int32_t storage_ = 0;
};

/// What a step along these lines costs, in packs: bonds once for every material in a block, a quarter of it the sums
/// over particles, padding included. Layers that are switched off count, for the numbering outlives that.
Real cost_of(const Lines& lines, const Section& section, int width) {
  constexpr Real kSums = 0.25, kOutOfCache = 0.15;  // the latter for every doubling of the length
  std::vector<std::uint64_t> materials(static_cast<std::size_t>(lines.storage() / width), 0);
  for (const Seed& s : section.seeds) {
    std::uint64_t& there = materials[static_cast<std::size_t>(lines.at(s) / width)];
    there |= std::uint64_t{1} << (static_cast<unsigned>(s.material) % 64);
  }
  Real packs = kSums * static_cast<Real>(materials.size());
  for (const std::uint64_t there : materials) packs += std::popcount(there);
  const Real doublings = std::log2(std::max<Real>(1, static_cast<Real>(lines.longest()) / kLongestLine));
  return packs * (1 + kOutOfCache * doublings);
}

/// Along x layers stay in packs of their own and lines are long; along y the lines of a large section are shorter.
Lines lines_of(const Section& section, int width) {
  Lines x(section, width, true), y(section, width, false);
  return cost_of(x, section, width) < cost_of(y, section, width) ? x : y;
}

struct LatticeOffset {
  int major, minor;
};

/// Bonds of consecutive packs should not end in the same cells: a load that overlaps a store not yet written waits for
/// it. Greedy: next comes the offset whose last overlapping predecessor lies furthest back.
std::vector<LatticeOffset> spread(std::vector<LatticeOffset> rest, int width) {
  std::vector<LatticeOffset> order;
  while (!rest.empty()) {
    const auto age = [&](LatticeOffset o) {
      for (std::size_t back = 1; back <= order.size(); ++back) {
        const LatticeOffset earlier = order[order.size() - back];
        if (earlier.major == o.major && std::abs(earlier.minor - o.minor) < width) return back;
      }
      return order.size() + 1;
    };
    const auto next =
        std::max_element(rest.begin(), rest.end(), [&](LatticeOffset p, LatticeOffset q) { return age(p) < age(q); });
    order.push_back(*next);
    rest.erase(next);
  }
  return order;
}

/// Offsets within the support 2h, forward ones (higher storage index) first, spread; then their opposites. Particles
/// off the lattice by up to `jitter` spacings may be nearer than their cells.
std::vector<LatticeOffset> find_offsets(const Lines& lines, const Lattice& lattice, Real jitter,
                                        const AnyKernel& kernel, Real h, Model& m) {
  const Real minor_spacing = lines.along_x() ? lattice.spacing.x() : lattice.spacing.y();
  const Real major_spacing = lines.along_x() ? lattice.spacing.y() : lattice.spacing.x();
  std::vector<LatticeOffset> forward;
  const int reach = static_cast<int>(std::ceil(2 * h / std::min(minor_spacing, major_spacing) + 2 * jitter));
  const auto nearest = [&](int cells) { return std::max<Real>(0, std::abs(cells) - 2 * jitter); };
  const auto distance = [&](LatticeOffset o) {
    return std::hypot(nearest(o.major) * major_spacing, nearest(o.minor) * minor_spacing);
  };
  for (int a = 0; a <= reach; ++a)
    for (int b = -reach; b <= reach; ++b)
      if ((a > 0 || b > 0) && distance({a, b}) < 2 * h * (1 - 1e-9)) forward.push_back({a, b});
  std::sort(forward.begin(), forward.end(), [](LatticeOffset p, LatticeOffset q) {
    return std::array{p.major, p.minor} < std::array{q.major, q.minor};
  });
  forward = spread(forward, m.width);
  std::vector<LatticeOffset> all = forward;
  for (LatticeOffset o : forward) all.push_back({-o.major, -o.minor});
  m.forward_offsets = static_cast<int>(forward.size());
  for (LatticeOffset o : all) {
    const Real a = o.major * major_spacing, b = o.minor * minor_spacing;
    m.offsets.push_back(
        offset_of(lines.along_x() ? b : a, lines.along_x() ? a : b, value(kernel, std::hypot(a, b), h)));
  }
  return all;
}

/// Which seeds sit where, and which pairs are cut.
struct Occupancy {
  const Model& m;
  Real reach;                // of a bond, m
  std::vector<CutPair> cut;  // storage indices, sorted
  bool occupied(std::int32_t i) const { return i >= 0 && i < m.storage && m.seed_of[static_cast<std::size_t>(i)] >= 0; }
  bool any(std::int32_t first) const {
    for (int l = 0; l < m.width; ++l)
      if (occupied(first + l)) return true;
    return false;
  }
  bool joined(std::int32_t i, std::int32_t j) const {
    if (!occupied(i) || !occupied(j) || !(m.off_lattice() ? distance(i, j) < reach : true)) return false;
    const CutPair key{std::min(i, j), std::max(i, j)};
    return !std::binary_search(cut.begin(), cut.end(), key, less);
  }
  Real distance(std::int32_t i, std::int32_t j) const {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    return std::hypot(m.place_x[b] - m.place_x[a], m.place_y[b] - m.place_y[a]);
  }
  static bool less(const CutPair& p, const CutPair& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; }
};

Occupancy number_particles(const Section& section, const Lines& lines, Real reach, Model& m) {
  m.storage = lines.storage();
  const auto n = static_cast<std::size_t>(m.storage);
  m.seed_of.assign(n, -1);
  m.material.assign(n, -1);
  m.storage_of.resize(section.seeds.size());
  m.id_of.resize(section.seeds.size());
  m.volume.allocate(n, 0, m.heap);
  if (!section.shifts.empty()) m.place_x.allocate(n, 13, m.heap), m.place_y.allocate(n, 14, m.heap);
  std::int32_t id = 0;
  for (const bool soil : {true, false})
    for (std::size_t k = 0; k < section.seeds.size(); ++k)
      if ((section.seeds[k].hold == Hold::kFree) == soil) m.id_of[k] = id++;
  for (std::size_t k = 0; k < section.seeds.size(); ++k) {
    const Seed& s = section.seeds[k];
    const std::int32_t i = lines.at(s);
    m.storage_of[k] = i;
    if (s.hold == Hold::kFree) ++m.soil_particles;
    if (!s.active) continue;
    m.seed_of[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(k);
    m.material[static_cast<std::size_t>(i)] = s.material;
    m.volume[static_cast<std::size_t>(i)] = s.volume;
    if (!m.off_lattice()) continue;
    const Vec2 x = section.local_place(k);
    m.place_x[static_cast<std::size_t>(i)] = x.x(), m.place_y[static_cast<std::size_t>(i)] = x.y();
  }
  m.particles = static_cast<std::int64_t>(section.seeds.size());
  Occupancy who{m, reach, {}};
  for (const CutPair& c : section.cut_pairs) {
    const std::int32_t a = m.storage_of[static_cast<std::size_t>(c.a)], b = m.storage_of[static_cast<std::size_t>(c.b)];
    who.cut.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(who.cut.begin(), who.cut.end(), Occupancy::less);
  return who;
}

/// Lanes of a pack that are bonds, and whether any lane must be hidden (both ends there, but no bond).
struct Lanes {
  std::uint8_t bonds = 0;
  bool hidden = false;
};
Lanes lanes_of(const Occupancy& who, int width, std::int32_t i, std::int32_t j) {
  Lanes lanes;
  for (int l = 0; l < width; ++l) {
    if (who.joined(i + l, j + l)) lanes.bonds |= static_cast<std::uint8_t>(1u << l);
    else if (who.occupied(i + l) && who.occupied(j + l)) lanes.hidden = true;
  }
  return lanes;
}

void build_blocks(const Lines& lines, const std::vector<LatticeOffset>& offsets, const Occupancy& who, Model& m) {
  for (std::size_t c = 0; c < lines.count(); ++c) {
    const Index line = lines.line(c);
    for (Index cell = lines.low(c); cell <= lines.high(c); cell += m.width) {
      Block block;
      block.first = lines.index(line, cell);
      if (!who.any(block.first)) continue;
      block.neighbours_begin = block.backward_begin = static_cast<std::int32_t>(m.neighbours.size());
      block.forward_before = m.forward_packs;
      for (std::size_t o = 0; o < offsets.size(); ++o) {
        const std::int32_t j = lines.index(line + offsets[o].major, cell + offsets[o].minor);
        if (j < 0 || !lines.touches(line + offsets[o].major, cell + offsets[o].minor)) continue;
        const Lanes lanes = lanes_of(who, m.width, block.first, j);
        if (lanes.bonds == 0) continue;
        m.neighbours.push_back({j, static_cast<std::uint8_t>(o), lanes.hidden ? lanes.bonds : std::uint8_t{0xff}});
        if (o < static_cast<std::size_t>(m.forward_offsets)) ++block.backward_begin, ++m.forward_packs;
      }
      block.neighbours_end = static_cast<std::int32_t>(m.neighbours.size());
      m.blocks.push_back(block);
    }
  }
}

std::uint16_t pair_of(const Model& m, std::int32_t i, std::int32_t j) {
  const std::int32_t a = m.material[static_cast<std::size_t>(i)], b = m.material[static_cast<std::size_t>(j)];
  return static_cast<std::uint16_t>(std::min(a, b) * m.materials + std::max(a, b));
}

/// One pack per pair of materials among the bonds between block `i` and `j`; all share one record.
void add_packs(const Occupancy& who, std::int32_t i, std::int32_t j, std::uint8_t offset, List<BondPack>& packs,
               Model& m) {
  std::map<std::uint16_t, std::uint8_t> pairs;
  int occupied = 0;
  for (int l = 0; l < m.width; ++l) {
    if (who.occupied(i + l) && who.occupied(j + l)) ++occupied;
    if (i == j ? who.occupied(i + l) : who.joined(i + l, j + l))
      pairs[pair_of(m, i + l, j + l)] |= static_cast<std::uint8_t>(1u << l);
  }
  for (const auto& [pair, lanes] : pairs) {
    const int shown = __builtin_popcount(lanes);
    if (i != j) m.bonds += shown;
    packs.push_back(
        {i, j, static_cast<std::int32_t>(m.slots), pair, offset, shown == occupied ? std::uint8_t{0xff} : lanes});
  }
  if (!pairs.empty()) ++m.slots;
}

int algorithm_of_pack(const Model& m, const BondPack& p) { return static_cast<int>(algorithm_of(m.pair_law[p.pair])); }

/// Chunks of whole blocks, each longer than the reach of a bond, so that packs of chunk c write to chunks c and c + 1
/// only.
void build_chunks(Model& m) {
  constexpr std::int32_t kLeast =
      512;  // particles: enough for one turn of a thread, few enough for a wave of six chunks to stay in cache
  List<BondPack> packs;
  use(packs, m.heap);
  std::int32_t reach = kLeast;
  for (const BondPack& p : m.packs) reach = std::max(reach, p.j + 2 * m.width - p.i);
  std::vector<BondPack> sorted[kReturnAlgorithms];
  std::size_t next = 0;  // packs are in block order already
  for (std::size_t b = 0; b < m.blocks.size();) {
    Chunk chunk;
    chunk.blocks_begin = static_cast<std::int32_t>(b);
    const std::int32_t begin = m.blocks[b].first;
    while (b < m.blocks.size() && m.blocks[b].first - begin < reach) ++b;
    chunk.blocks_end = static_cast<std::int32_t>(b);
    const std::int32_t end = b < m.blocks.size() ? m.blocks[b].first : static_cast<std::int32_t>(m.storage);
    for (auto& s : sorted) s.clear();
    for (; next < m.packs.size() && m.packs[next].i < end; ++next)
      sorted[algorithm_of_pack(m, m.packs[next])].push_back(m.packs[next]);
    // bonds of a block that join the same materials are worked on together
    const auto before = [](const BondPack& p, const BondPack& q) { return p.i != q.i ? p.i < q.i : p.pair < q.pair; };
    for (int a = 0; a < kReturnAlgorithms; ++a) {
      std::stable_sort(sorted[a].begin(), sorted[a].end(), before);
      chunk.packs_begin[a] = static_cast<std::int32_t>(packs.size());
      packs.insert(packs.end(), sorted[a].begin(), sorted[a].end());
      chunk.packs_end[a] = static_cast<std::int32_t>(packs.size());
    }
    m.chunks.push_back(chunk);
  }
  m.packs = std::move(packs);
}

/// M_i^-1; where the neighbours lie (almost) on a line the direction without information is left out.
Mat2 guarded_inverse(const Mat2& moment) {
  Eigen::SelfAdjointEigenSolver<Mat2> solver(moment);
  constexpr Real kLeastRatio = 1e-3;
  const Real largest = solver.eigenvalues()[1];
  Mat2 inverse = Mat2::Zero();
  for (int a = 0; a < 2; ++a) {
    const Real value = solver.eigenvalues()[a];
    if (value <= kLeastRatio * largest) continue;
    const Vec2 direction = solver.eigenvectors().col(a);
    inverse += direction * direction.transpose() / value;
  }
  return inverse;
}

/// omega_ij of every pair, where no two are alike. The records of bonds are those of the forward packs.
void build_weights(const Occupancy& who, const AnyKernel& kernel, Real h, Model& m) {
  const auto width = static_cast<std::size_t>(m.width);
  m.pair_weight.resize(m.neighbours.size() * width);
  for (const Block& block : m.blocks)
    for (std::int32_t k = block.neighbours_begin; k < block.neighbours_end; ++k) {
      float* const weights =
          m.pair_weight.data() + width * static_cast<std::size_t>(weight_record(block, k, m.forward_packs));
      const std::int32_t second = m.neighbours[static_cast<std::size_t>(k)].j;
      for (int l = 0; l < m.width; ++l) {
        const std::int32_t i = block.first + l, j = second + l;
        weights[l] = who.joined(i, j) ? static_cast<float>(value(kernel, who.distance(i, j), h)) : 0;
      }
    }
}

/// omega0_i, M_i (VB1) and the stiffness-proportional mass sum_j B_ij/2 (K + 4G/3).
void build_operators(Model& m) {
  const auto n = static_cast<std::size_t>(m.storage);
  Array share;
  share.allocate(n, 1, m.heap);
  m.moment_xx.allocate(n, 2, m.heap), m.moment_xy.allocate(n, 3, m.heap), m.moment_yy.allocate(n, 4, m.heap);
  m.scaled_mass.allocate(n, 5, m.heap);
  m.sum_x.allocate(n, 6, m.heap), m.sum_y.allocate(n, 7, m.heap);
  const auto each_neighbour = [&](auto&& f) {
    for (const Block& block : m.blocks)
      for (int l = 0; l < m.width; ++l) {
        const std::int32_t i = block.first + l;
        if (m.seed_of[static_cast<std::size_t>(i)] < 0) continue;
        for (std::int32_t k = block.neighbours_begin; k < block.neighbours_end; ++k) {
          const NeighbourPack& p = m.neighbours[static_cast<std::size_t>(k)];
          const std::int32_t j = p.j + l;
          if (((p.lanes >> l) & 1) == 0 || m.seed_of[static_cast<std::size_t>(j)] < 0) continue;
          f(static_cast<std::size_t>(i), static_cast<std::size_t>(j), m.offset(k, block, l));
        }
      }
  };
  std::vector<Real> omega0(n, 0);
  std::vector<Mat2> moment(n, Mat2::Zero());
  each_neighbour([&](std::size_t i, std::size_t j, const Offset& o) {
    const Vec2 xi(o.xi_x, o.xi_y);
    omega0[i] += o.weight * m.volume[j];
    moment[i] += o.weight * m.volume[j] * xi * xi.transpose();
    m.sum_x[i] += m.volume[j] * o.g_x, m.sum_y[i] += m.volume[j] * o.g_y;
  });
  for (std::size_t i = 0; i < n; ++i) {
    if (m.seed_of[i] < 0 || !(omega0[i] > 0)) continue;
    const Mat2 inverse = guarded_inverse(moment[i]);
    m.moment_xx[i] = inverse(0, 0), m.moment_xy[i] = inverse(0, 1), m.moment_yy[i] = inverse(1, 1);
    share[i] = m.volume[i] / omega0[i];
  }
  each_neighbour([&](std::size_t i, std::size_t j, const Offset& o) {
    const LawConstants& c = m.pair_elastic[pair_of(m, static_cast<std::int32_t>(i), static_cast<std::int32_t>(j))];
    const Real bond_volume = o.weight * (m.volume[i] * share[j] + share[i] * m.volume[j]);
    m.scaled_mass[i] += 0.5 * bond_volume * (c.bulk_modulus + 4 * c.shear_modulus / 3);
  });
  if (m.features.bond != BondLaw::kNone) m.share = std::move(share);
}

}  // namespace

void build_packs(const Section& section, Real jitter, const AnyKernel& kernel, Real h, Model& m) {
  const Lines lines = lines_of(section, m.width);
  const std::vector<LatticeOffset> offsets = find_offsets(lines, section.lattice, jitter, kernel, h, m);
  const Occupancy who = number_particles(section, lines, 2 * h * (1 - 1e-9), m);
  build_blocks(lines, offsets, who, m);
  for (const Block& block : m.blocks) {
    if (m.features.bond == BondLaw::kNone) {
      add_packs(who, block.first, block.first, 0, m.packs, m);
      continue;
    }
    for (std::int32_t k = block.neighbours_begin; k < block.backward_begin; ++k) {
      const NeighbourPack& p = m.neighbours[static_cast<std::size_t>(k)];
      add_packs(who, block.first, p.j, p.offset, m.packs, m);
    }
  }
  build_chunks(m);
  if (m.off_lattice()) build_weights(who, kernel, h, m);
  build_operators(m);
}

}  // namespace vbgpd
