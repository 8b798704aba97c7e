// What all kinds of simulation do alike, and what one says to a request it has no answer for.
#include "simulation/simulation.h"

#include <limits>

#include "simulation/march.h"

namespace vbgpd {

namespace {

[[noreturn]] void unsupported(const char* what) {
  throw Error(Status::kUnsupported, std::string("this kind of model cannot ") + what);
}

}  // namespace

StepReport Simulation::step(std::int64_t steps, const std::atomic<bool>* cancel) {
  return march({steps, std::numeric_limits<Real>::infinity()}, [&] {
    return cancel != nullptr && cancel->load(std::memory_order_relaxed) ? Status::kCancelled : Status::kOk;
  });
}

StepReport Simulation::advance_to(double time, const StepWatch& watch) {
  require_ahead(time, get("time"));
  return march({std::numeric_limits<std::int64_t>::max(), time}, watch);
}

void Simulation::write(int, const std::vector<double>&) { unsupported("take over fields from outside"); }
const Drive& Simulation::drive() const { unsupported("tell what drives it"); }
void Simulation::set_drive(const Drive&) { unsupported("change loads while it runs"); }
void Simulation::set_layers(const Layers&) {
  throw Error(Status::kUnsupported,
              "the layers of a run-out cannot be switched, its soil has moved; draw a profile of the next stage");
}
void Simulation::start_over() { unsupported("start over, its soil has moved"); }
void Simulation::take_stresses(const Simulation&) { unsupported("take stresses over"); }
Vec2 Simulation::boundary_reaction(std::size_t) const { unsupported("tell the reaction of a boundary"); }
FieldView Simulation::view(int) const { unsupported("lend its arrays"); }
StateImage Simulation::image() const { unsupported("be written to a checkpoint"); }
void Simulation::restore_image(const StateImage&) { unsupported("be restored from a checkpoint"); }

}  // namespace vbgpd
