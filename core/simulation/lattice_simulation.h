// The simulation on a lattice with fixed bonds (total-Lagrangian): what Simulation::compile makes today.
#pragma once

#include "base/parallel.h"
#include "simulation/observe.h"
#include "simulation/outside.h"
#include "simulation/simulation.h"
#include "state/model.h"
#include "step/kernels.h"

namespace vbgpd {

class LatticeSimulation final : public Simulation {
 public:
  /// The scene is valid. `kernels` is the build of the step to use.
  LatticeSimulation(const SceneDef& scene, const CompileOptions& options, const Kernels& kernels);

  const SceneDef& scene() const override { return scene_; }
  const CompileOptions& options() const override { return options_; }
  const Section& section() const override { return section_; }
  std::int64_t particle_count() const override { return model_.particles; }
  std::int64_t bond_count() const override { return model_.bonds; }
  Monitors monitors() const override;
  /// Limit of the finer grids that are made of it, 0 = none.
  void limit_particles(std::int64_t most) { options_.max_particles = most; }
  Monitors monitors_after(const StepReport& steps) const override;
  RelaxReport relax(std::int64_t steps, const RelaxOptions& options) override;
  void halt() override;
  void start_over() override;
  std::shared_ptr<SavedState> save() const override;
  void restore(const SavedState& saved) override;
  Real displacement_scale() const override { return model_.stress_scale * model_.height / model_.stiffness; }
  Real elastic_energy() const override;
  double get(std::string_view name) const override;
  void set(std::string_view name, double value) override;
  void read(int field, std::vector<double>& out) const override;
  void read(int field, std::vector<std::int64_t>& out) const override;
  std::uint64_t state_hash() const override { return hash_of(state_, layers_); }
  std::vector<Feature> plan() const override;
  Memory memory() const override;
  void write(int field, const std::vector<double>& rows) override;
  const Drive& drive() const override { return drive_; }
  void set_drive(const Drive& drive) override;
  Layers layers() const override { return layers_; }
  void set_layers(const Layers& layers) override;
  void take_stresses(const Simulation& softer) override;
  Vec2 boundary_reaction(std::size_t boundary) const override;
  FieldView view(int field) const override;
  StateImage image() const override;
  void restore_image(const StateImage& image) override;

  const Model& model() const { return model_; }
  State& state() {
    unbook();
    return state_;
  }
  const std::vector<LawConstants>& constants() const { return constants_; }
  const Array& dilation_cap() const { return dilation_cap_; }
  StepData step_data_for_tests() { return data(state_, scratch_); }

 private:
  struct Ledger {
    Real external = 0, damping = 0, plastic = 0;
    Real before = 0;    ///< energy that the soil had but for what is booked: of relaxations
    bool open = false;  ///< since then only dynamic steps have moved the soil
    Real booked() const { return external - damping - plastic; }
  };
  /// An instant of dynamic stepping whose energy was found in order.
  struct Audit {
    bool valid = false;
    State state;
    Ledger ledger;
    Real stored = 0, time = 0;
    Real share = 0;  ///< what the audit before found
    std::int64_t steps = 0;
  };
  struct Saved;
  /// What depends on which layers are there, made aside so that it is taken as a whole or not at all.
  struct Stage {
    Layers layers;
    Section section;
    Model model;
    State state;
    Scratch scratch;
    std::vector<Sums> partial;
    Array dilation_cap;
    std::vector<LawConstants> constants, elastic_constants;
  };
  /// All but the state, under those forces and at that strength reduction factor. `placed`: with room for the shape
  /// that soil was placed in.
  Stage stage(const Layers& layers, bool placed, const Drive& drive, const Outside& outside, Real factor) const;
  void exchange(Stage& stage) noexcept;
  static std::uint64_t hash_of(const State& state, const Layers& layers);
  /// Forces of a drive and from outside on a model.
  void load(const Drive& drive, const Outside& outside, const Section& section, Model& model) const;
  StepReport march(const Goal& goal, const StepWatch& watch) override;
  /// Forces of a drive and from outside, anew; when memory runs out, as before.
  Array stored_pressure(const std::vector<double>& rows) const;  ///< by particle id into storage order
  void take_forces(Drive drive, Outside outside);
  void write_velocity(const std::vector<double>& rows);
  StepData data(State& state, Scratch& scratch) const;
  void run_step(StepData data, const Controls& controls, Sums& sums) const;
  /// A step of a copy of the motion, by the present plastic strain and without keeping that of the step.
  Sums probe(const Controls& controls) const;
  /// Highest natural frequency with the given masses: by Lanczos' recurrence on the elastic operator.
  Real highest_frequency(const Array& mass) const;
  Real dynamic_time_step() const;
  void set_factor(Real factor);
  /// Material constants already made for that factor.
  void take_constants(Real factor, std::vector<LawConstants> constants);
  static void fit_dilation_cap(const Model& model, const std::vector<LawConstants>& constants, Array& cap);
  Controls evaluation_controls() const;
  /// Brings scratch up to date with the state without moving anything.
  Sums evaluate() const;
  Real unbalanced_force_ratio(const Sums& sums) const;
  Monitors monitors_of(Real unbalanced_force_ratio) const;
  Real kinetic_energy() const;
  /// Kinetic and elastic energy at the time of the displacements.
  Real stored_energy() const;
  void begin_audit(Real share = 0);
  /// Something other than a dynamic step moves the soil: what energy it then has is not booked.
  void unbook() { audit_.valid = ledger_.open = false; }
  Real energy_residual() const;
  bool walls_move() const;
  /// Energy that has come out of nothing since the audit before, as a share of what is tolerated; above 1 the state is
  /// that of the audit before. Every so many steps; between them what the last one found.
  Real audit();
  /// Work of the internal forces over the half step by which velocities lag behind displacements (leap-frog).
  Real half_step_work() const;
  void read_particles(int field, std::vector<double>& out) const;
  void read_bonds(int field, std::vector<double>& out) const;

  SceneDef scene_;
  CompileOptions options_;
  SavedTotal saved_ = std::make_shared<std::atomic<std::size_t>>(0);
  Layers layers_;  // empty = all
  Section section_;
  const Kernels& kernels_;
  Model model_;
  State state_;
  mutable Scratch scratch_;
  mutable State probe_;  // copy of the motion for evaluations
  mutable std::vector<Sums> partial_;
  mutable Workers workers_;
  Array dilation_cap_;  // mean stress at the tension cut-off over K, at the present factor
  mutable Real dynamic_frequency_ = 0, relaxing_frequency_ = 0;
  std::vector<LawConstants> constants_, elastic_constants_;
  Real factor_ = 1, damping_ = 0, time_step_factor_ = kDefaultTimeStepFactor, time_ = 0;
  std::int64_t steps_ = 0, since_restart_ = 0;
  Ledger ledger_;
  Audit audit_;
  Real last_time_step_ = 0;  ///< of the last dynamic step, 0 = none yet
  Drive drive_;
  Outside outside_;
  std::uint64_t force_version_ = 0, newest_force_version_ = 0;  ///< which forces hold; every change makes a new one
  mutable std::vector<std::int64_t> storage_ids_;               ///< particle ids in storage order, for views
};

}  // namespace vbgpd
