// The simulation of a run-out (updated-Lagrangian): made from a lattice simulation, in its present state.
#pragma once

#include "base/parallel.h"
#include "simulation/lattice_simulation.h"
#include "state/flow_model.h"
#include "step/flow_kernels.h"

namespace vbgpd {

class FlowSimulation final : public Simulation {
 public:
  explicit FlowSimulation(const LatticeSimulation& from, const FlowOptions& options = {},
                          const FlowKernels& kernels = best_flow_kernels());

  const SceneDef& scene() const override { return scene_; }
  const CompileOptions& options() const override { return options_; }
  const Section& section() const override { return section_; }
  std::int64_t particle_count() const override { return model_.particles; }  ///< soil only: walls are mirrors
  std::int64_t bond_count() const override;
  bool runs_out() const override { return true; }
  Layers layers() const override { return layers_; }  ///< of the model it was made from
  Monitors monitors() const override;
  /// Steps with local damping (0.7 unless given), with or without strengths: the gravity state before the release.
  RelaxReport relax(std::int64_t steps, const RelaxOptions& options) override;
  void halt() override;
  std::shared_ptr<SavedState> save() const override;
  void restore(const SavedState& saved) override;
  Real displacement_scale() const override { return model_.stress_scale * model_.height / model_.stiffness; }
  Real elastic_energy() const override;
  double get(std::string_view name) const override;
  void set(std::string_view name, double value) override;
  void read(int field, std::vector<double>& out) const override;
  void read(int field, std::vector<std::int64_t>& out) const override;
  std::uint64_t state_hash() const override { return state_.hash(); }
  Memory memory() const override;
  /// velocity (whoever pushes does the work), external_force and pore_pressure.
  void write(int field, const std::vector<double>& rows) override;
  const Drive& drive() const override { return drive_; }
  void set_drive(const Drive& drive) override;
  /// Of the step to come, found by taking it with a copy.
  Vec2 boundary_reaction(std::size_t boundary) const override;
  FieldView view(int field) const override;
  std::int64_t epoch() const override { return epoch_; }
  StateImage image() const override;
  void restore_image(const StateImage& image) override;

  const FlowModel& model() const { return model_; }
  FlowState& state() { return state_; }
  const FlowState& state() const { return state_; }
  /// Neighbours are searched again before the next step (after a test has moved particles).
  void state_was_changed();
  /// Law pseudo_spring: joins the particles anew, as they are now; nothing with the other laws.
  void join();

 private:
  /// Works since the release, J per metre run; the energies it began with.
  struct Ledger {
    Real external = 0, internal = 0, bond = 0, viscous = 0, damping = 0, contact = 0;
    Real kinetic_before = 0, guard_before = 0, stored_before = 0;
    bool open = false;
  };
  struct Saved;
  StepReport march(const Goal& goal, const StepWatch& watch) override;
  FlowData data(FlowState& state) const;
  FlowControls controls() const;
  void set_factor(Real factor);
  void fit_guard();
  /// Sizes a scratch for the present number of mirror images and writes what stays the same until the next search.
  void arrange(const FlowLists& lists, FlowScratch& scratch) const;
  /// Takes over a state with what follows from it.
  void settle(FlowState&& state, FlowLists&& lists, FlowScratch&& scratch);
  void note_farthest();
  void refresh_neighbours(Real time_step);  ///< after a step
  /// One step of `state`, which lies as the lists say; its new motion is left in the scratch, its new stress too where
  /// this answers true.
  bool evaluate(FlowState& state, const FlowControls& controls, FlowSums& sums) const;
  void run_step(const FlowControls& controls, FlowSums& sums);
  /// Forces of a drive and from outside, anew; when memory runs out, as before.
  void take_forces(Drive drive, Outside outside);
  Outside outside() const;  ///< all that is set from outside, the water too
  void write_velocity(const std::vector<double>& rows);
  void open_ledger();
  Real stored_energy() const;
  Real kinetic_energy() const;
  Real max_displacement() const;
  Real energy_residual() const;
  Real plastic_bond_count() const;
  bool plastic(std::size_t i, std::size_t j, std::size_t slot) const;
  template <class F>
  void for_each_bond(F&& f) const;
  void read_particles(int field, std::vector<double>& out) const;
  void read_bonds(int field, std::vector<double>& out) const;

  SceneDef scene_;
  CompileOptions options_;
  SavedTotal saved_ = std::make_shared<std::atomic<std::size_t>>(0);
  Section section_;
  Layers layers_;  // empty = all
  const FlowKernels& kernels_;
  FlowModel model_;
  FlowState state_;
  FlowLists lists_;
  mutable FlowScratch scratch_;
  mutable Workers workers_;
  mutable std::vector<FlowSums> partial_;
  std::vector<FlowLaw> laws_, elastic_laws_;
  std::vector<Real> bond_modulus_;  // chi G by material
  FlowSums last_;
  Real room_ = 0;  ///< every particle may move so far before the lists are looked at, m
  Ledger ledger_;
  Real factor_ = 1, damping_ = 0, time_ = 0, peak_kinetic_ = 0;
  Real farthest_ = 0,
       farther_at_ = 0;  ///< largest displacement so far, m, and when it was reached or the drive changed
  std::int64_t steps_ = 0, searches_ = 0, epoch_ = 0;
  bool yields_ = false;
  Drive drive_;
  Outside outside_;                                ///< by particle id; its water is kept in the model
  mutable std::vector<std::int64_t> storage_ids_;  ///< particle ids in the present order, for views
};

/// A run-out made from `from` in its present state. Throws Error(kState) when that is a run-out already.
std::unique_ptr<Simulation> make_runout(const Simulation& from, const FlowOptions& options = {});

}  // namespace vbgpd
