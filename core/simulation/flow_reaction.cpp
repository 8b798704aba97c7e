// What the walls of a run-out do to the soil, boundary by boundary.
#include "simulation/flow_simulation.h"
#include "step/flow_walls.h"

namespace vbgpd {

namespace {

/// Adds up what the walls of one boundary do.
struct Listener {
  static constexpr bool kListens = true;
  const std::vector<FlowWall>& walls;
  std::size_t boundary;
  Vec2& sum;
  bool belongs(std::int32_t wall) const {
    return static_cast<std::size_t>(walls[static_cast<std::size_t>(wall)].boundary) == boundary;
  }
  void operator()(int wall, double x, double y) const {
    if (belongs(wall)) sum += Vec2(x, y);
  }
};

}  // namespace

Vec2 FlowSimulation::boundary_reaction(std::size_t boundary) const {
  const Workers::Session session(workers_);
  const FlowControls c = controls();
  FlowState probe = state_;
  FlowSums sums;
  evaluate(probe, c, sums);
  FlowState before = state_;  // the contact springs have been stretched in the other copy
  FlowData d = data(probe);
  d.wall_shear = before.wall_shear.data(), d.wall_limit = before.wall_limit.data();
  Vec2 sum = Vec2::Zero();
  const Listener tell{model_.walls, boundary, sum};
  for (int i = 0; i < d.particles; ++i) {
    const FlowRow& row = d.rows[i];
    if (row.near_wall == 0) continue;
    for (auto k = 4l * row.ghosts; k < 4l * row.end; ++k) {
      const std::int32_t j = d.neighbours[k];
      if (j == d.particles) continue;
      const FlowGhost& ghost = d.ghosts[j - d.particles - 1];
      const bool first = tell.belongs(ghost.wall), second = ghost.second >= 0 && tell.belongs(ghost.second);
      if (!first && !second) continue;
      const ContactForce image = image_force(d, c, i, j);
      const Vec2 force(image.x, image.y);
      if (ghost.second < 0 || (first && second)) {
        sum += force;
        continue;
      }
      // an image behind a right corner: each wall bears what comes across it
      const FlowWall& wall = d.walls[first ? ghost.wall : ghost.second];
      const Vec2 normal(wall.nx, wall.ny);
      sum += force.dot(normal) * normal;
    }
    wall_force(d, c, i, tell);
  }
  return sum;
}

}  // namespace vbgpd
