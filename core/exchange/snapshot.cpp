#include "exchange/snapshot.h"

#include "base/error.h"
#include "scene/limits.h"
#include "snapshot_generated.h"

namespace vbgpd {

namespace fb = flatbuffers;
namespace schema = exchange::snapshot;

namespace {

std::size_t size_of(const Snapshot& s) {
  std::size_t numbers = s.particle_id.size() + (s.material.size() + s.boundary.size()) / 2;
  for (const auto* v :
       {&s.position, &s.displacement, &s.velocity, &s.stress, &s.plastic_strain, &s.volume, &s.pore_pressure})
    numbers += v->size();
  std::size_t texts = s.name.size() + s.version.size();
  for (const std::string& m : s.materials) texts += m.size() + 16;
  return numbers * sizeof(double) + texts + 4096;
}

fb::Offset<fb::Vector<std::int32_t>> indices(fb::FlatBufferBuilder& out, const std::vector<std::int64_t>& from) {
  return out.CreateVector(std::vector<std::int32_t>(from.begin(), from.end()));
}

}  // namespace

std::vector<std::uint8_t> snapshot_to_bytes(const Snapshot& s) {
  const std::size_t size = size_of(s);
  if (size > kMaxCheckpointBytes)
    throw Error(Status::kLimit, "the snapshot would need " + std::to_string(size) +
                                    " bytes: a flatbuffer holds at most " + std::to_string(kMaxCheckpointBytes));
  fb::FlatBufferBuilder out(size);
  const auto version = out.CreateString(s.version), name = out.CreateString(s.name);
  const auto materials = out.CreateVectorOfStrings(s.materials);
  const auto particle_id = out.CreateVector(s.particle_id);
  const auto material = indices(out, s.material), boundary = indices(out, s.boundary);
  const auto position = out.CreateVector(s.position), displacement = out.CreateVector(s.displacement);
  const auto velocity = out.CreateVector(s.velocity), stress = out.CreateVector(s.stress);
  const auto plastic_strain = out.CreateVector(s.plastic_strain), volume = out.CreateVector(s.volume);
  const auto pore_pressure = s.pore_pressure.empty() ? 0 : out.CreateVector(s.pore_pressure);
  schema::FinishSnapshotBuffer(
      out, schema::CreateSnapshot(
               out, kSnapshotFormat, version, name, s.time, s.steps, s.strength_reduction_factor, s.spacing_x,
               s.spacing_y, s.state_hash, static_cast<std::int64_t>(s.particle_id.size()), materials, particle_id,
               material, boundary, position, displacement, velocity, stress, plastic_strain, volume, pore_pressure));
  return {out.GetBufferPointer(), out.GetBufferPointer() + out.GetSize()};
}

}  // namespace vbgpd
