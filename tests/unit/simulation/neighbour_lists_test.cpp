// Neighbour lists of a run-out against all pairs and all images, for as long as they are said to serve.
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <set>
#include <tuple>

#include "physics/runout_scenes.h"
#include "state/flow_drift.h"
#include "state/flow_neighbours.h"

namespace vbgpd::test {
namespace {

using Motion = std::function<Vec2(std::size_t particle, const Vec2& place)>;  // direction, at most about 1 long

/// Neighbour lists of a run-out that somebody else moves.
class Carried {
 public:
  explicit Carried(const SceneDef& scene) : simulation_(runout(scene)) {
    search_neighbours(m_, s_, lists_);
    start_ = s_;
  }

  /// Pairs within the support that are not in the lists, images behind one wall and behind the corner too.
  int missing() const {
    const auto n = static_cast<std::size_t>(m_.particles);
    int count = 0;
    for (std::size_t i = 0; i < n; ++i) {
      std::set<std::tuple<std::int32_t, std::int32_t, std::int32_t>> listed;
      for (auto k = 4 * lists_.rows[i].begin; k < 4 * lists_.rows[i].end; ++k) {
        const std::int32_t j = lists_.neighbours[static_cast<std::size_t>(k)];
        if (j < m_.particles) listed.insert({j, -1, -1});
        if (j <= m_.particles) continue;
        const FlowGhost& g = lists_.ghosts[static_cast<std::size_t>(j - m_.particles - 1)];
        listed.insert({g.parent, g.wall, g.second});
      }
      const auto check = [&](std::size_t j, const Vec2& at, std::int32_t wall, std::int32_t second) {
        if ((at - place(i)).norm() < m_.support && listed.count({static_cast<std::int32_t>(j), wall, second}) == 0)
          ++count;
      };
      for (std::size_t j = 0; j < n; ++j) {
        if (j != i) check(j, place(j), -1, -1);
        for (std::size_t w = 0; w < m_.walls.size(); ++w)
          check(j, mirrored(place(j), w), static_cast<std::int32_t>(w), -1);
        if (m_.walls.size() == 2) check(j, mirrored(mirrored(place(j), 0), 1), 0, 1);
      }
    }
    return count;
  }

  /// Moves the soil, from where it was listed, until the lists serve no longer; answers how far the farthest went, in
  /// skins.
  double carry(const Motion& motion) {
    s_ = start_;
    const double skin = m_.options.skin * m_.spacing;
    double way = 0;
    while (room_left(m_, s_, lists_) >= 0) {
      EXPECT_EQ(missing(), 0) << "after " << way / skin << " skins";
      way += 0.05 * skin;
      for (std::size_t i = 0; i < static_cast<std::size_t>(m_.particles); ++i) {
        const Vec2 from(start_.motion[4 * i], start_.motion[4 * i + 1]), to = from + way * motion(i, from);
        s_.motion[4 * i] = to.x(), s_.motion[4 * i + 1] = to.y();
      }
    }
    return way / skin;
  }
  std::size_t particles() const { return static_cast<std::size_t>(m_.particles); }

 private:
  Vec2 place(std::size_t i) const { return {s_.motion[4 * i], s_.motion[4 * i + 1]}; }
  Vec2 mirrored(const Vec2& x, std::size_t wall) const {
    const FlowWall& w = m_.walls[wall];
    const Vec2 normal(w.nx, w.ny);
    return x - 2 * (x - Vec2(w.x, w.y)).dot(normal) * normal;
  }

  std::unique_ptr<FlowSimulation> simulation_;
  FlowModel m_ = simulation_->model();
  FlowState s_ = simulation_->state(), start_;
  FlowLists lists_;
};

TEST(NeighbourLists, HoldEveryPairWhenMade) { EXPECT_EQ(Carried(bar_column(6)).missing(), 0); }

TEST(NeighbourLists, ServeLongerWhereNeighboursMoveTogether) {
  Carried body(free_body(soil("drucker_prager", 1e4, 20), 0.2, 0.1, 0.0125));
  EXPECT_NEAR(body.carry([](std::size_t, const Vec2&) { return Vec2(0.6, 0.8); }), kFarthest, 0.051);
  EXPECT_NEAR(body.carry([](std::size_t i, const Vec2&) { return i % 2 == 0 ? Vec2(0.6, 0.8) : Vec2(-0.6, -0.8); }),
              0.5, 0.051);
}

TEST(NeighbourLists, MissNoPairWhileTheyServe) {
  Carried column(bar_column(6));
  std::mt19937 dice(3);
  std::uniform_real_distribution<double> one(-0.7, 0.7);
  std::vector<Vec2> ways;
  for (std::size_t i = 0; i < column.particles(); ++i) {
    const double x = one(dice), y = one(dice);
    ways.push_back(Vec2(x, y));
  }
  const Motion motions[] = {
      [](std::size_t, const Vec2& x) { return Vec2(10 * x.y(), 0); },                     // shears over the base
      [](std::size_t, const Vec2& x) { return Vec2(5 * x.x(), -10 * x.y()); },            // spreads and settles
      [](std::size_t, const Vec2& x) { return Vec2(-5 * x.x(), -10 * x.y()); },           // into the corner
      [](std::size_t, const Vec2& x) { return x.x() > 0.1 ? Vec2(-1, 0) : Vec2(1, 0); },  // two halves meet
      [&](std::size_t i, const Vec2&) { return ways[i]; },
  };
  for (const Motion& motion : motions) EXPECT_GE(column.carry(motion), 0.3);
}

}  // namespace
}  // namespace vbgpd::test
