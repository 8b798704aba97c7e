// Checkpoints of other formats: which are read.
#include "exchange/checkpoint.h"

#include <flatbuffers/flatbuffers.h>
#include <gtest/gtest.h>

#include "physics/runout_scenes.h"

namespace vbgpd::test {
namespace {

std::vector<std::uint8_t> bytes_in_format(const Simulation& simulation, std::uint32_t format) {
  constexpr flatbuffers::voffset_t kFormatField = 4;  // the first field of the table
  Checkpoint checkpoint;
  checkpoint.scene = simulation.scene(), checkpoint.state = simulation.image();
  std::vector<std::uint8_t> bytes = checkpoint_to_bytes(checkpoint);
  EXPECT_TRUE(
      flatbuffers::GetMutableRoot<flatbuffers::Table>(bytes.data())->SetField<std::uint32_t>(kFormatField, format, 0));
  return bytes;
}

Status status_of(const std::vector<std::uint8_t>& bytes) {
  try {
    (void)checkpoint_from_bytes(bytes);
    return Status::kOk;
  } catch (const Error& e) {
    return e.issue().status;
  }
}

TEST(CheckpointFormats, OfModelsAtRestAreReadUpToTheNewest) {
  const LatticeSimulation at_rest(bar_column(4), {}, best_kernels());
  for (std::uint32_t format = 1; format <= kCheckpointFormat; ++format)
    EXPECT_EQ(status_of(bytes_in_format(at_rest, format)), Status::kOk) << format;
  EXPECT_EQ(status_of(bytes_in_format(at_rest, kCheckpointFormat + 1)), Status::kVersion);
}

TEST(CheckpointFormats, OfModelsAtRestWithoutGapsAreTakenOver) {
  LatticeSimulation old(bar_column(4), {}, best_kernels());
  old.relax(20, {});
  StateImage image = old.image();
  ASSERT_GT(std::erase_if(image.rows, [](const StateImage::Rows& r) { return r.name == "gap"; }), 0u);
  Array gap = std::move(const_cast<State&>(old.state()).gap);  // as a library of format 1 had it
  image.hash = old.state_hash();
  LatticeSimulation fresh(bar_column(4), {}, best_kernels());
  fresh.restore_image(image);
  EXPECT_EQ(fresh.get("steps"), old.get("steps"));
  EXPECT_TRUE(fresh.state().gap.present());
}

TEST(CheckpointFormats, OfRunoutsAreReadWithTheSameNeighbourListsOnly) {
  const auto sliding = runout(bar_column(4));
  EXPECT_EQ(status_of(bytes_in_format(*sliding, kCheckpointFormat)), Status::kOk);
  for (const std::uint32_t format : {1u, 2u, 3u, kCheckpointFormat + 1})
    EXPECT_EQ(status_of(bytes_in_format(*sliding, format)), Status::kVersion) << format;
}

}  // namespace
}  // namespace vbgpd::test
