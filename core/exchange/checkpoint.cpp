#include "exchange/checkpoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "checkpoint_generated.h"
#include "scene/limits.h"
#include "exchange/scene_buffer.h"

namespace vbgpd {

namespace fb = flatbuffers;
namespace schema = exchange::checkpoint;

namespace {

constexpr std::size_t kMostRows = 64, kMostNumbers = 64, kMostName = 64;

[[noreturn]] void refuse(const std::string& text) { throw Error(Status::kFormat, "the checkpoint " + text); }

/// Bytes the arrays need, with room for names and tables.
std::size_t size_of(const Checkpoint& c, std::size_t scene) {
  std::size_t sum =
      scene + 65536 + (c.state.plastic.size() + c.state.placed_strain.size()) * sizeof(schema::PlasticBond);
  for (const auto& r : c.state.rows) sum += r.values.size() * sizeof(double);
  return sum;
}

const schema::Checkpoint& verified(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() < 8 || !schema::CheckpointBufferHasIdentifier(bytes.data()))
    refuse("is none: bytes 4 to 7 must be \"" + std::string(schema::CheckpointIdentifier()) + "\"");
  fb::Verifier::Options options;
  options.max_depth = 4;
  options.max_tables = kMostRows + kMostNumbers + 1;
  fb::Verifier verifier(bytes.data(), bytes.size(), options);
  if (!schema::VerifyCheckpointBuffer(verifier))
    refuse("is damaged or cut short (" + std::to_string(bytes.size()) + " bytes): some part of it points outside it");
  return *schema::GetCheckpoint(bytes.data());
}

std::string name_of(const fb::String* text) {
  if (text->size() == 0 || text->size() > kMostName) refuse("has a name of impossible length");
  return text->str();
}

double finite(double v, const std::string& what) {
  if (!std::isfinite(v)) refuse("has a " + what + " that is not finite");
  return v;
}

/// The verifier looks at bounds, not at where the elements of a vector fall; where there are none, a writer does not
/// care either.
template <class Vector>
void require_aligned(const Vector& v) {
  if (v.size() > 0 && reinterpret_cast<std::uintptr_t>(v.Data()) % alignof(double) != 0)
    refuse("has an array off its place");
}

StateImage state_from(const schema::Checkpoint& from) {
  StateImage state;
  state.particles = from.particles(), state.bonds = from.bonds(), state.hash = from.hash();
  constexpr std::int64_t kMostParticles = std::numeric_limits<std::int32_t>::max();
  if (state.particles <= 0 || state.particles > kMostParticles || state.bonds < 0 || state.bonds > 100 * kMostParticles)
    refuse("has an impossible number of particles or bonds");
  for (const auto* n : *from.numbers()) {
    std::string name = name_of(n->name());
    const double value = finite(n->value(), name);
    state.numbers.push_back({std::move(name), value});
  }
  for (const auto* r : *from.rows()) {
    StateImage::Rows rows{name_of(r->name()), r->components(), {}};
    if (rows.components < 1 || rows.components > 8 || r->values()->size() % static_cast<unsigned>(rows.components) != 0)
      refuse("has " + rows.name + " in rows of impossible length");
    require_aligned(*r->values());
    rows.values.assign(r->values()->begin(), r->values()->end());
    for (const double v : rows.values) finite(v, rows.name);
    state.rows.push_back(std::move(rows));
  }
  // what is claimed must be there: no more particles are ever built than the bytes hold
  state.runs_out = from.runs_out();
  if (state.runs_out && from.format() < kCheckpointFormat)
    throw Error(Status::kVersion, "the checkpoint is of a run-out in format " + std::to_string(from.format()) +
                                      ", whose neighbours are listed otherwise; this library reads format " +
                                      std::to_string(kCheckpointFormat) + " only");
  const std::string_view where = state.runs_out ? "position" : "displacement";
  const bool whole = std::any_of(state.rows.begin(), state.rows.end(), [&](const StateImage::Rows& r) {
    return r.name == where && static_cast<std::int64_t>(r.values.size()) == 2 * state.particles;
  });
  if (!whole) refuse("lacks the " + std::string(where) + "s of its " + std::to_string(state.particles) + " particles");
  const auto take_bonds = [&](const fb::Vector<const schema::PlasticBond*>& list,
                              std::vector<StateImage::PlasticBond>& to) {
    if (static_cast<std::int64_t>(list.size()) > std::max(state.bonds, state.particles))
      refuse("has more plastic bonds than bonds");
    require_aligned(list);
    for (const schema::PlasticBond* p : list) {
      if (p->a() < 0 || p->b() < 0 || p->a() >= state.particles || p->b() >= state.particles)
        refuse("has a bond between particles that are none");
      to.push_back({p->a(), p->b(), finite(p->xx(), "strain"), finite(p->yy(), "strain"), finite(p->xy(), "strain")});
    }
  };
  take_bonds(*from.plastic(), state.plastic);
  state.placed = from.placed();
  if (from.placed_strain() != nullptr) take_bonds(*from.placed_strain(), state.placed_strain);
  return state;
}

std::uint32_t format_of(const StateImage& image) {
  const bool gaps = std::any_of(image.rows.begin(), image.rows.end(), [](const auto& r) { return r.name == "gap"; });
  return image.runs_out || gaps ? kCheckpointFormat : 1;
}

}  // namespace

std::vector<std::uint8_t> checkpoint_to_bytes(const Checkpoint& c) {
  const std::vector<std::uint8_t> scene = scene_to_flatbuffer(c.scene);
  const std::size_t size = size_of(c, scene.size());
  if (size > kMaxCheckpointBytes)
    throw Error(Status::kLimit, "the checkpoint would need " + std::to_string(size) +
                                    " bytes: a flatbuffer holds at most " + std::to_string(kMaxCheckpointBytes));
  fb::FlatBufferBuilder out(size);
  std::vector<fb::Offset<schema::Number>> numbers;
  for (const auto& n : c.state.numbers) numbers.push_back(schema::CreateNumber(out, out.CreateString(n.name), n.value));
  std::vector<fb::Offset<schema::Rows>> rows;
  for (const auto& r : c.state.rows) {
    const auto name = out.CreateString(r.name);
    const auto values = out.CreateVector(r.values);
    rows.push_back(schema::CreateRows(out, name, r.components, values));
  }
  const auto bonds = [](const std::vector<StateImage::PlasticBond>& from) {
    std::vector<schema::PlasticBond> list;
    list.reserve(from.size());
    for (const auto& p : from) list.emplace_back(p.a, p.b, p.xx, p.yy, p.xy);
    return list;
  };
  const auto scene_bytes = out.CreateVector(scene);
  const auto number_list = out.CreateVector(numbers);
  const auto row_list = out.CreateVector(rows);
  const auto plastic_list = out.CreateVectorOfStructs(bonds(c.state.plastic));
  const auto placed_list = c.state.placed_strain.empty() ? 0 : out.CreateVectorOfStructs(bonds(c.state.placed_strain));
  const auto root = schema::CreateCheckpoint(out, format_of(c.state), scene_bytes, c.spacing_factor, c.lattice_multiple,
                                             c.coarsening, c.state.particles, c.state.bonds, number_list, row_list,
                                             plastic_list, c.state.hash, c.state.placed, placed_list, c.state.runs_out);
  schema::FinishCheckpointBuffer(out, root);
  return {out.GetBufferPointer(), out.GetBufferPointer() + out.GetSize()};
}

Checkpoint checkpoint_from_bytes(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > kMaxCheckpointBytes) refuse("has more bytes than a flatbuffer holds");
  // A copy: aligned as flatbuffers expects, and nobody can change it between the check and the reading.
  const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  const schema::Checkpoint& from = verified(copy);
  if (from.format() > kCheckpointFormat)
    throw Error(Status::kVersion, "the checkpoint has format " + std::to_string(from.format()) +
                                      "; this library reads up to " + std::to_string(kCheckpointFormat));
  if (from.format() == 0) refuse("names no format");
  Checkpoint out;
  out.spacing_factor = from.spacing_factor();
  out.lattice_multiple = from.lattice_multiple(), out.coarsening = from.coarsening();
  if (!(out.spacing_factor >= 0.01 && out.spacing_factor <= 100) || out.lattice_multiple < 1 ||
      out.lattice_multiple > 64 || out.coarsening < 1 || out.coarsening > 64)
    refuse("has an impossible grid");
  out.state = state_from(from);
  out.scene = scene_from_flatbuffer({from.scene()->data(), from.scene()->size()});
  return out;
}

}  // namespace vbgpd
