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
  StepReport step(std::int64_t steps, const std::atomic<bool>* cancel) override;
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
  /// velocity only; whoever pushes does the work.
  void write(int field, const std::vector<double>& rows) override;

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
  FlowData data() const;
  FlowControls controls() const;
  void set_factor(Real factor);
  void fit_guard();
  void arrange_scratch();
  void refresh_neighbours();
  void run_step(const FlowControls& controls, FlowSums& sums);
  void open_ledger();
  Real stored_energy() const;
  Real kinetic_energy() const;
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
  const FlowKernels& kernels_;
  FlowModel model_;
  FlowState state_;
  FlowLists lists_;
  mutable FlowScratch scratch_;
  mutable Workers workers_;
  std::vector<FlowSums> partial_;
  std::vector<FlowLaw> laws_, elastic_laws_;
  std::vector<Real> bond_modulus_;  // chi G by material
  FlowSums last_;
  Ledger ledger_;
  Real factor_ = 1, damping_ = 0, time_ = 0, peak_kinetic_ = 0;
  std::int64_t steps_ = 0, searches_ = 0;
  bool yields_ = false;
};

/// A run-out made from `from` in its present state. Throws Error(kState) when that is a run-out already.
std::unique_ptr<Simulation> make_runout(const Simulation& from, const FlowOptions& options = {});

}  // namespace vbgpd
