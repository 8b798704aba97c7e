// The run-time face of the engine: a scene compiled into particles and bonds, stepped and read. The only door for
// analysis and capi.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/heap.h"
#include "base/log.h"
#include "base/state_image.h"
#include "geometry/section.h"
#include "geometry/stages.h"
#include "scene/scene_def.h"
#include "simulation/memory.h"
#include "simulation/plan.h"

namespace vbgpd {

enum class Location { kParticle = 1, kBond = 2 };
enum class FieldType { kReal = 1, kInteger = 2 };

/// A named output array that describes itself.
struct FieldInfo {
  const char* name;
  const char* unit;  ///< UDUNITS
  const char* doc;
  Location location;
  FieldType type;
  int components;
  bool writable = false;  ///< Simulation::write takes it
};
std::span<const FieldInfo> fields();
int find_field(std::string_view name);  ///< -1 = no such field

/// A named number of a simulation ("damping", "time" ...); settable ones have a range.
struct NamedValue {
  const char* name;
  const char* unit;
  const char* doc;
  double default_value, min_value, max_value;
  bool max_open;
  bool settable;
  bool min_open = false;
};
std::span<const NamedValue> named_values();
/// Throws unless `name` is a named number that may be set to `value`: Error(kUnknownName), (kState), (kRange).
void require_settable(std::string_view name, double value);
/// Throws Error(kUnknownName) that says which there are: named_values and what else a kind of simulation has.
[[noreturn]] void no_such_value(std::string_view name, std::initializer_list<std::string_view> others = {});

/// A dynamic step as a share of the stable one: what the measurement may still miss of the highest frequency, and
/// what plastic flow or growing velocities may add to it, comes off.
inline constexpr Real kDefaultTimeStepFactor = 0.68;

struct CompileOptions {
  int threads = 1;                 ///< results do not depend on it
  std::int64_t max_particles = 0;  ///< 0 = no limit
  Real spacing_factor = 1;         ///< spacing aimed at, times the scene's
  int lattice_multiple = 2;        ///< key lines are asked to fall on every that many-th cell edge
  int coarsening = 1;              ///< then the cells are made this many times larger
  std::int64_t max_bytes = 0;      ///< predicted_bytes beyond it are refused; 0 = no limit
  Heap heap;                       ///< where arrays and lists come from
  std::shared_ptr<Log> log;        ///< may be null; the grids of jobs speak to the same one
};

struct StepReport {
  std::int64_t steps = 0;
  Status status = Status::kOk;  ///< kOk, kCancelled or kDiverged (back at a good step, at most 512 before)
  std::optional<Real> unbalanced_force_ratio{};  ///< of the forces the last step moved with; none without a good step
  Real speed_share = 0, energy_share = 0;  ///< largest shares of the two limits that good steps reached; given up at 1
  const char* cause = nullptr;             ///< of kDiverged, in words
};
/// Of StepReport: a particle whose speed the method cannot follow, energy that nobody put in.
inline constexpr const char* kOutranWaves = "a particle outran the waves";
inline constexpr const char* kEnergyFromNothing = "energy came out of nothing";

/// Asked between two steps of a long run: kOk = go on; kCancelled and kLimitReached end it there.
using StepWatch = std::function<Status()>;

/// What drives the soil: at first as the scene says, then as set from outside.
struct Drive {
  double kh = 0, kv = 0;         ///< pseudo-static coefficients
  std::vector<LoadDef> loads;    ///< pressures on the ground; where they act is fixed
  std::vector<Vec2> velocities;  ///< m/s, of every boundary (used by those of kind velocity)
};

/// An array as it is stored, padding included: item i, component c lies at data + i*stride_item + c*stride_component
/// bytes.
struct FieldView {
  const void* data = nullptr;
  std::int64_t count = 0, stride_item = 0, stride_component = 0;
};

/// Monitors of the present state.
struct Monitors {
  Real unbalanced_force_ratio = 0;  ///< sum |f| / sum of weights and loads
  Real max_displacement = 0, max_velocity = 0;
  Real kinetic_energy = 0;
  std::int64_t plastic_bonds = 0;
};

/// One run of quasi-static relaxation steps: momentum with restart, masses proportional to stiffness.
struct RelaxOptions {
  bool elastic = false;         ///< strengths left out
  double local_damping = 0;     ///< > 0: local damping instead of momentum, the slow and careful reference
  double time_step_factor = 1;  ///< of the stable step with its margin
  bool ledger = false;
};
struct RelaxReport {
  std::int64_t steps = 0;
  std::int64_t since_restart = 0;   ///< steps since the momentum was last dropped
  Real unbalanced_force_ratio = 0;  ///< sum |f| / sum |f_ext| of the last step
  Real power_ratio = 0;             ///< 1 - sum f.v / sum f_ext.v of the last step: internal over external power
  Real external_power = 0;          ///< sum f_ext.v of the last step, per pseudo-time
  Real velocity = 0;                ///< max |v|, per pseudo-time
  Real max_displacement = 0;
  bool diverged = false;
  Real external_work = 0, internal_work = 0, plastic_work = 0;  ///< with ledger, of this run
};

/// A saved instant: everything that changes.
class SavedState {
 public:
  virtual ~SavedState() = default;
};

class Simulation {
 public:
  /// Checks the scene (validate + check_geometry), throws Error whose text lists every error; then builds model and
  /// state.
  static std::unique_ptr<Simulation> compile(const SceneDef& scene, const CompileOptions& options);
  /// A simulation of the scene in that instant, a run-out where it is one. Throws what compile and restore_image throw.
  static std::unique_ptr<Simulation> restored(const SceneDef& scene, const CompileOptions& options,
                                              const StateImage& image);
  virtual ~Simulation() = default;

  virtual const SceneDef& scene() const = 0;
  virtual const CompileOptions& options() const = 0;
  virtual const Section& section() const = 0;
  virtual std::int64_t particle_count() const = 0;  ///< soil first, then walls
  virtual std::int64_t bond_count() const = 0;
  virtual bool runs_out() const { return false; }  ///< updated-Lagrangian: bonds come and go, no factor of safety

  /// Dynamic steps with true masses at the stable time step; `cancel` may be null.
  StepReport step(std::int64_t steps, const std::atomic<bool>* cancel);
  /// Dynamic steps of equal length that end exactly at `time`, however often the watch interrupts them.
  StepReport advance_to(double time, const StepWatch& watch);
  virtual Monitors monitors() const = 0;
  /// The same right after dynamic steps, with the forces of the last one: no forces are worked out again.
  virtual Monitors monitors_after(const StepReport& /*steps*/) const { return monitors(); }

  /// Quasi-static steps; velocities are pseudo-velocities meanwhile. `halt` drops them and the momentum.
  virtual RelaxReport relax(std::int64_t steps, const RelaxOptions& options) = 0;
  virtual void halt() = 0;
  virtual std::shared_ptr<SavedState> save() const = 0;
  virtual void restore(const SavedState& saved) = 0;
  virtual Real displacement_scale() const = 0;  ///< gamma H^2 / E: unit of the displacement level
  virtual Real elastic_energy() const = 0;      ///< J per metre run

  virtual double get(std::string_view name) const = 0;  ///< throws Error(kUnknownName)
  virtual void set(std::string_view name,
                   double value) = 0;  ///< throws Error(kUnknownName), Error(kRange), Error(kState)

  /// All items of a field, packed rows, by particle id or bond by bond.
  virtual void read(int field, std::vector<double>& out) const = 0;
  virtual void read(int field, std::vector<std::int64_t>& out) const = 0;  ///< integer fields only
  virtual std::uint64_t state_hash() const = 0;

  /// Every feature as used or left out; their bytes add up to "bytes". By default all of them in one entry.
  virtual std::vector<Feature> plan() const;
  /// The same bytes by what they are for.
  virtual Memory memory() const = 0;

  // Coupling; a kind of simulation that cannot do one of these throws Error(kUnsupported).

  /// All items of a writable field, packed rows by particle id. Forces and pressures stay until written again.
  virtual void write(int field, const std::vector<double>& rows);
  virtual const Drive& drive() const;
  virtual void set_drive(const Drive& drive);
  /// Which layers of the scene are there; empty = all, as at first.
  virtual Layers layers() const { return {}; }
  /// Takes the soil of layers away or places it; the other soil keeps its state. Throws Error(kArgument) when no soil
  /// would be left; whatever it throws, nothing has changed.
  virtual void set_layers(const Layers& layers);
  /// Soil that has never moved nor yielded, at rest; layers, drive, pressures and forces stay as they are.
  virtual void start_over();
  /// Displacements and stresses of another simulation of the same section whose soils are less stiff: what strain the
  /// stress there means and here does not is booked as the shape the soil was placed in. Exact within a soil; in a bond
  /// between two, where the mean stress is continuous. Throws Error(kArgument) for any other section.
  virtual void take_stresses(const Simulation& softer);
  /// Force of the wall particles of a boundary on the soil, N per metre run.
  virtual Vec2 boundary_reaction(std::size_t boundary) const;
  /// A field in storage order; "particle_id" tells which particle an item is, -1 = padding.
  virtual FieldView view(int field) const;
  /// Grows whenever particles are added, removed or stored in another order.
  virtual std::int64_t epoch() const { return 0; }
  /// A saved instant as plain data, for another process or machine. restore_image checks all of it before it changes
  /// anything.
  virtual StateImage image() const;
  virtual void restore_image(const StateImage& image);

 protected:
  /// Where a run of dynamic steps ends: after so many, or exactly at a time.
  struct Goal {
    std::int64_t steps;
    Real time;
  };
  virtual StepReport march(const Goal& goal, const StepWatch& watch) = 0;
};

}  // namespace vbgpd
