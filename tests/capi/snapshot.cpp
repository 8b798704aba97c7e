// A snapshot read back as another program would: bytes of the C face, the header that flatc makes of the schema.
#include <cstdint>
#include <vector>

#include "slope.h"
#include "snapshot_generated.h"

namespace {

namespace schema = vbgpd::exchange::snapshot;

std::vector<std::uint8_t> snapshot_of(const vbgpd_model* model) {
  std::int64_t needed = -1, again = -1;
  CHECK_OK(vbgpd_model_snapshot(model, nullptr, 0, &needed));
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(needed), 0x5a);
  CHECK_STATUS(VBGPD_E_BUFFER, vbgpd_model_snapshot(model, bytes.data(), needed - 1, &again));
  CHECK(again == needed && bytes[0] == 0x5a);
  CHECK_OK(vbgpd_model_snapshot(model, bytes.data(), needed, nullptr));
  return bytes;
}

const schema::Snapshot& verified(const std::vector<std::uint8_t>& bytes) {
  flatbuffers::Verifier verifier(bytes.data(), bytes.size());
  CHECK(schema::VerifySnapshotBuffer(verifier));
  CHECK(schema::SnapshotBufferHasIdentifier(bytes.data()));
  return *schema::GetSnapshot(bytes.data());
}

std::int32_t field(const char* name) {
  std::int32_t found = -1;
  CHECK_OK(vbgpd_field_find(name, VBGPD_STRLEN, &found));
  return found;
}

/// The vector holds the field of the model, bit by bit.
void same(const vbgpd_model* model, const char* name, const flatbuffers::Vector<double>* seen) {
  vbgpd_field_info info;
  info.struct_size = sizeof info;
  CHECK_OK(vbgpd_field_info_at(field(name), &info));
  std::int64_t n = 0;
  CHECK_OK(vbgpd_model_item_count(model, VBGPD_AT_PARTICLE, &n));
  std::vector<double> values(static_cast<std::size_t>(n * info.components));
  CHECK_OK(vbgpd_model_read_f64(model, field(name), values.data(), 0, 0, n, nullptr));
  CHECK(seen != nullptr && seen->size() == values.size());
  CHECK(std::memcmp(seen->data(), values.data(), values.size() * sizeof(double)) == 0);
}

void same(const vbgpd_model* model, const char* name, const flatbuffers::Vector<std::int32_t>& seen) {
  std::vector<std::int64_t> values(seen.size());
  CHECK_OK(vbgpd_model_read_i64(model, field(name), values.data(), 0, 0, seen.size(), nullptr));
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(seen[static_cast<flatbuffers::uoffset_t>(i)] == values[i]);
}

void holds_the_model(const vbgpd_model* model, bool wet) {
  const std::vector<std::uint8_t> bytes = snapshot_of(model);
  const schema::Snapshot& s = verified(bytes);
  std::uint64_t hash = 0;
  CHECK_OK(vbgpd_model_state_hash(model, &hash));
  CHECK(s.format() == 1 && s.version()->str() == vbgpd_version_string() && s.name()->str() == "B\xC3\xB6schung");
  CHECK(s.time() == model_number(model, "time") && static_cast<double>(s.steps()) == model_number(model, "steps"));
  CHECK(s.strength_reduction_factor() == 1.25 && s.state_hash() == hash);
  CHECK(s.spacing_x() == model_number(model, "spacing_x") && s.spacing_y() == model_number(model, "spacing_y"));
  CHECK(static_cast<double>(s.particles()) == model_number(model, "particles"));
  CHECK(s.materials()->size() == 1 && s.materials()->Get(0)->str() == "soil");
  CHECK(static_cast<std::int64_t>(s.particle_id()->size()) == s.particles());
  for (flatbuffers::uoffset_t i = 0; i < s.particle_id()->size(); ++i) CHECK(s.particle_id()->Get(i) == i);
  same(model, "material", *s.material());
  same(model, "boundary", *s.boundary());
  same(model, "position", s.position());
  same(model, "displacement", s.displacement());
  same(model, "velocity", s.velocity());
  same(model, "stress", s.stress());
  same(model, "plastic_strain", s.plastic_strain());
  same(model, "volume", s.volume());
  CHECK((s.pore_pressure() != nullptr) == wet);
  if (wet) same(model, "pore_pressure", s.pore_pressure());
}

}  // namespace

int main() {
  static const double water[4] = {50e3, 50e3, 0, 0};
  vbgpd_context* context = make_context();
  vbgpd_profile* profile = make_profile(context, 2);
  vbgpd_model *model = nullptr, *flow = nullptr;
  CHECK_OK(vbgpd_profile_set_text(profile, VBGPD_OBJECT_PROFILE, 0, "name", VBGPD_STRLEN, "B\xC3\xB6schung", -1));
  CHECK_OK(vbgpd_model_create(context, profile, &model));
  CHECK_OK(vbgpd_model_set_f64(model, "strength_reduction_factor", VBGPD_STRLEN, 1.25));
  CHECK_OK(vbgpd_model_step(model, 50, nullptr));
  holds_the_model(model, false);
  CHECK_OK(vbgpd_model_create_runout(model, &flow));
  CHECK_OK(vbgpd_model_step(flow, 10, nullptr));
  holds_the_model(flow, false);
  CHECK_OK(vbgpd_model_write_grid(model, field("pore_pressure"), 0, 0, 40, 15, 2, 2, water, 0));
  CHECK_OK(vbgpd_model_step(model, 10, nullptr));
  holds_the_model(model, true);
  std::int64_t needed = -1;
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_snapshot(model, nullptr, 10, &needed));
  CHECK_STATUS(VBGPD_E_ARGUMENT, vbgpd_model_snapshot(model, nullptr, -1, &needed));
  // any other file: the verifier of the reader notices
  std::vector<std::uint8_t> bytes = snapshot_of(model);
  flatbuffers::Verifier cut(bytes.data(), bytes.size() / 2);
  CHECK(!schema::VerifySnapshotBuffer(cut));
  CHECK_OK(vbgpd_model_destroy(flow));
  CHECK_OK(vbgpd_model_destroy(model));
  CHECK_OK(vbgpd_profile_destroy(profile));
  CHECK_OK(vbgpd_context_destroy(context));
  return 0;
}
