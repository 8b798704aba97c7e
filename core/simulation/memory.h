// Where the memory of a simulation is, and how much one would need before it is built.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "geometry/section.h"
#include "scene/scene_def.h"

namespace vbgpd {

/// The bytes of a simulation by what they are for.
struct Memory {
  std::size_t model = 0;    ///< geometry, neighbours, operators, masses: never changes
  std::size_t state = 0;    ///< everything that changes: one saved instant is as large
  std::size_t scratch = 0;  ///< what a step writes before it reads it, and what it needs beside the model
  std::size_t copies = 0;   ///< copies of the state for fields, monitors and the energy audit
  std::size_t outside = 0;  ///< forces and pore pressures written by a host
  std::size_t saved = 0;    ///< instants saved from it that somebody still holds; not part of the total
  std::size_t total() const { return model + state + scratch + copies + outside; }
};

/// Bytes of the saved instants that are alive; the simulation and each instant hold the same total, so that an instant
/// may outlive its simulation.
using SavedTotal = std::shared_ptr<std::atomic<std::size_t>>;
class SavedBytes {
 public:
  SavedBytes(SavedTotal total, std::size_t bytes) : total_(std::move(total)), bytes_(bytes) { *total_ += bytes_; }
  ~SavedBytes() { *total_ -= bytes_; }
  SavedBytes(const SavedBytes&) = delete;
  SavedBytes& operator=(const SavedBytes&) = delete;

 private:
  SavedTotal total_;
  std::size_t bytes_;
};

/// Bytes a simulation of the scene on that lattice will have once it was stepped, relaxed and read: an estimate from
/// the outline of the section, 5 to 30 % too high rather than too low.
double predicted_bytes(const SceneDef& scene, const Lattice& lattice, int width);

/// Throws Error(kLimit, of the context) when the lattice of that spacing needs more bytes: how many, and the spacing
/// that would fit. 0 = no limit.
using LatticeOf = std::function<Lattice(Real spacing)>;
void require_bytes(const SceneDef& scene, const LatticeOf& lattice_of, Real spacing, int width, std::int64_t max_bytes);
/// The section on the lattice of that spacing. Throws Error(kLimit) that counts its particles, walls included, when
/// they are more than max_particles (0 = no limit), and names a spacing that fits.
Section section_within(const SceneDef& scene, const LatticeOf& lattice_of, Real spacing, std::int64_t max_particles);

}  // namespace vbgpd
