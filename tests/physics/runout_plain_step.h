// One step of a run-out as plain loops over all pairs of particles and all images, straight from the equations (README
// of core, "Run-out"): slow, and the oracle for the fast step. It shares nothing with core/step but the material laws.
// Left out: Coulomb walls, pore water, corners that are not right ones, the rivals but for plain SPH.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "material/any_law.h"
#include "material/cone.h"
#include "material/hexagon.h"
#include "state/flow_model.h"

namespace vbgpd::test {

class PlainRunout {
 public:
  struct Particle {
    Vec2 x, v;
    Mat2 deviator;  ///< in the plane
    Real mean = 0, gap = 0, plastic_strain = 0, wall_stretch = 0;
  };

  PlainRunout(const FlowModel& model, const FlowState& state)
      : m_(model), n_(static_cast<std::size_t>(model.particles)), h_(model.support / 2), particles(n_) {
    for (std::size_t k = 0; k < n_; ++k) {
      Particle& p = particles[static_cast<std::size_t>(state.particle[k])];
      p.x = {state.motion[4 * k], state.motion[4 * k + 1]}, p.v = {state.motion[4 * k + 2], state.motion[4 * k + 3]};
      p.deviator << state.stress[4 * k], state.stress[4 * k + 2], state.stress[4 * k + 2], state.stress[4 * k + 1];
      p.mean = state.stress[4 * k + 3], p.gap = state.gap[k], p.plastic_strain = state.plastic_strain[k];
    }
    rival_ = m_.bond == FlowBondLaw::kSph;
    for (int a = -9; a <= 9; ++a)
      for (int b = -9; b <= 9; ++b)
        if (a != 0 || b != 0) full_ += m_.spacing * m_.spacing * omega(m_.spacing * std::hypot(a, b));
    yields_ = std::any_of(m_.law.begin(), m_.law.end(), [](const AnyLaw& law) { return yields(law); });
  }

  void step() {
    place_images();
    work_.assign(n_, {});
    for (std::size_t i = 0; i < n_; ++i) strain(i);
    for (std::size_t i = 0; i < n_; ++i) update_stress(i);
    if (m_.bond == FlowBondLaw::kVirtual) load_bonds();
    for (std::size_t i = 0; i < n_; ++i) find_flux(i);
    press_images();
    for (std::size_t i = 0; i < n_; ++i) push(i);
    if (yields_ && !rival_) diffuse();
    for (std::size_t i = 0; i < n_; ++i) {
      Particle& p = particles[i];
      p.v += m_.time_step / m_.mass[i] * work_[i].force, p.x += m_.time_step * p.v;
    }
  }

 private:
  /// What a step finds out about a particle.
  struct Work {
    Mat2 inverse = Mat2::Identity(), soil_inverse = Mat2::Identity(), gradient = Mat2::Zero();
    Mat2 bond_moment = Mat2::Zero(), flux = Mat2::Zero();  ///< sum B tau (x) n; P = Z M^-1 / V
    Real omega0 = 0, ratio = 1;
    Vec2 force = Vec2::Zero();
    Eigen::Matrix<Real, 2, 4> slope = Eigen::Matrix<Real, 2, 4>::Zero();  ///< half the gradient of xx, yy, xy, mean
  };
  struct Image {
    std::size_t parent;
    std::vector<const FlowWall*> walls;  ///< one, or the two of a corner
    Vec2 x = Vec2::Zero(), v = Vec2::Zero();
    Mat2 flux = Mat2::Zero();
  };

  static Vec2 normal(const FlowWall& w) { return {w.nx, w.ny}; }
  static Mat2 mirror(const FlowWall& w) { return Mat2::Identity() - 2 * normal(w) * normal(w).transpose(); }
  static Real distance(const FlowWall& w, const Vec2& x) { return normal(w).dot(x - Vec2(w.x, w.y)); }
  Mat2 stress(std::size_t i) const { return particles[i].deviator + particles[i].mean * Mat2::Identity(); }
  Eigen::Vector4d components(std::size_t i) const {
    const Particle& p = particles[i];
    return {p.deviator(0, 0), p.deviator(1, 1), p.deviator(0, 1), p.mean};
  }
  const LawConstants& moduli(std::size_t i) const { return m_.moduli[static_cast<std::size_t>(m_.material[i])]; }
  Real wave(std::size_t i) const { return moduli(i).bulk_modulus + 4 * moduli(i).shear_modulus / 3; }
  Vec2 weight_of(std::size_t i) const { return {m_.force_x[i], m_.force_y[i]}; }

  /// omega = -W'(r)/r of Wendland C2.
  Real omega(Real r) const { return r < 2 * h_ ? 35 / (4 * kPi * std::pow(h_, 4)) * std::pow(1 - r / (2 * h_), 3) : 0; }
  /// use(j, xi, r) for every soil particle within the support.
  template <class F>
  void around(std::size_t i, F&& use) const {
    for (std::size_t j = 0; j < n_; ++j) {
      const Vec2 xi = particles[j].x - particles[i].x;
      if (j != i && xi.norm() < 2 * h_) use(j, xi, xi.norm());
    }
  }

  void place_images() {
    images_.clear();
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t a = 0; a < m_.walls.size(); ++a) {
        images_.push_back({i, {&m_.walls[a]}});
        for (std::size_t b = a + 1; b < m_.walls.size(); ++b)
          if (std::fabs(normal(m_.walls[a]).dot(normal(m_.walls[b]))) < 1e-6)
            images_.push_back({i, {&m_.walls[a], &m_.walls[b]}});
      }
    for (Image& g : images_) {
      g.x = particles[g.parent].x, g.v = particles[g.parent].v;
      for (const FlowWall* w : g.walls) {
        g.x -= 2 * distance(*w, g.x) * normal(*w);
        g.v = w->rough != 0 ? Vec2(-g.v) : Vec2(mirror(*w) * g.v);
      }
    }
  }

  /// M^-1 with the eigenvalues of M kept above the floor.
  Mat2 floored_inverse(const Mat2& moment) const {
    const Eigen::SelfAdjointEigenSolver<Mat2> solver(moment);
    const Vec2 values = solver.eigenvalues().cwiseMax(m_.options.smallest_eigenvalue);
    return solver.eigenvectors() * values.cwiseInverse().asDiagonal() * solver.eigenvectors().transpose();
  }

  /// Monaghan's viscosity on approach.
  Vec2 viscosity(const Vec2& xi, const Vec2& v, Real weight, Real mass) const {
    return m_.viscosity * weight * mass * std::min<Real>(v.dot(xi), 0) / (xi.squaredNorm() + 0.01 * h_ * h_) * xi;
  }

  void strain(std::size_t i) {
    Work& w = work_[i];
    const Particle& p = particles[i];
    Mat2 moment = Mat2::Zero(), soil = Mat2::Zero(), sum = Mat2::Zero();
    const auto add = [&](const Vec2& xi, const Vec2& v, Real share) {
      moment += share * xi * xi.transpose(), sum += share * v * xi.transpose(), w.omega0 += share;
    };
    around(i, [&](std::size_t j, const Vec2& xi, Real r) {
      const Vec2 v = particles[j].v - p.v;
      add(xi, v, omega(r) * m_.volume[j]);
      w.force += viscosity(xi, v, omega(r), (m_.mass[i] * m_.volume[j] + m_.volume[i] * m_.mass[j]) / 2);
      const Real overlap = m_.options.guard_distance * (m_.size[i] + m_.size[j]) / 2 - r;
      if (overlap > 0 && !rival_) w.force -= m_.options.guard_stiffness * (wave(i) + wave(j)) / 2 * overlap * xi / r;
    });
    soil = moment;
    for (const Image& g : images_) {
      const Vec2 xi = g.x - p.x, v = g.v - p.v;
      const Real share = omega(xi.norm()) * m_.volume[g.parent];
      add(xi, v, share);
      w.force += viscosity(xi, v, share, m_.mass[i]);
    }
    if (!rival_) w.inverse = floored_inverse(moment), w.soil_inverse = floored_inverse(soil);
    w.gradient = sum * w.inverse;
  }

  Stress<Real> returned(std::size_t i, const Stress<Real>& trial) const {
    const auto k = static_cast<std::size_t>(m_.material[i]);
    LawConstants c;
    std::visit([&](auto law) { decltype(law)::derive(m_.strength[k], c); }, m_.law[k]);
    c.shear_modulus = m_.moduli[k].shear_modulus, c.bulk_modulus = m_.moduli[k].bulk_modulus;
    if (m_.extra_cohesion.present()) c.k += m_.extra_cohesion[i] * c.k_per_cohesion;
    return algorithm_of(m_.law[k]) == ReturnAlgorithm::kCone ? return_to(Cone<Real>(c), trial).stress
                                                             : return_to(Hexagon<Real>(c), trial).stress;
  }

  /// Gap memory, rotation, elastic trial, return; the increment is taken in the middle of the drift.
  void update_stress(std::size_t i) {
    Particle& p = particles[i];
    const Real dt = m_.time_step, shear = moduli(i).shear_modulus, bulk = moduli(i).bulk_modulus;
    const Mat2 l = work_[i].gradient * (Mat2::Identity() - dt / 2 * work_[i].gradient).inverse();
    const Real gap_before = p.gap, mean_before = p.mean;
    Real opening = l.trace() * dt;
    if (!rival_) {
      const Real closed = std::max<Real>(0, std::min(p.gap, -opening));
      p.gap -= closed, opening += closed;
    }
    const Mat2 turn = Eigen::Rotation2D<Real>(2 * std::atan((l(1, 0) - l(0, 1)) * dt / 4)).toRotationMatrix();
    const Mat2 rate = (l + l.transpose()) / 2 - l.trace() / 3 * Mat2::Identity();
    const Mat2 s = turn * p.deviator * turn.transpose() + 2 * shear * dt * rate;
    const Stress<Real> trial{s(0, 0), s(1, 1), s(0, 1), p.mean + bulk * opening}, end = returned(i, trial);
    if (end.xx != trial.xx || end.yy != trial.yy || end.xy != trial.xy || end.m != trial.m) {
      const Real before = std::sqrt(trial.j2()), after = std::sqrt(end.j2());
      work_[i].ratio = before > 0 ? std::min<Real>(after / before, 1) : 0;
      p.plastic_strain += std::max<Real>(before - after, 0) / shear;
      if (!rival_) p.gap += std::max<Real>(trial.m - end.m, 0) / bulk;
    }
    p.deviator << end.xx, end.xy, end.xy, end.yy;
    p.mean = end.m;
    const bool soil = yields(m_.law[static_cast<std::size_t>(m_.material[i])]);
    const bool disturbed = p.plastic_strain > m_.options.disturbed;
    if (soil && disturbed && !rival_ && work_[i].omega0 < m_.options.loose * full_) {  // a loose grain
      p.deviator.setZero(), p.mean = 0, work_[i].ratio = 0;
      p.gap = std::max<Real>(gap_before + l.trace() * dt + mean_before / bulk, 0);
    }
  }

  /// Disturbed soil diffuses its stress like soil that yields.
  bool diffuses(std::size_t i) const {
    return work_[i].ratio < 1 || particles[i].plastic_strain > m_.options.disturbed;
  }
  Real bond_modulus(std::size_t i) const {
    const bool soil = yields(m_.law[static_cast<std::size_t>(m_.material[i])]);
    return (soil ? m_.options.bond_stiffness : m_.options.elastic_bond_stiffness) * moduli(i).shear_modulus;
  }

  /// q = (v_j - v_i)/r - Lbar n,  tau <- min(rm_i, rm_j) [turned tau + chi G dt q], lost where the pair parts.
  void load_bonds() {
    std::map<std::pair<std::size_t, std::size_t>, Vec2> now;
    const Real dt = m_.time_step;
    for (std::size_t i = 0; i < n_; ++i)
      around(i, [&](std::size_t j, const Vec2& xi, Real r) {
        if (j < i) return;
        const Mat2 mean = (work_[i].gradient + work_[j].gradient) / 2;
        const Vec2 q = (particles[j].v - particles[i].v - mean * xi) / r;
        const Real angle = (mean(1, 0) - mean(0, 1)) * dt / 2;
        Mat2 turn;
        turn << 1 - angle * angle / 2, -angle, angle, 1 - angle * angle / 2;
        const auto old = traction_.find({i, j});
        const Vec2 before = old == traction_.end() ? Vec2(0, 0) : old->second;
        const Vec2 tau = std::min(work_[i].ratio, work_[j].ratio) *
                         (turn * before + (bond_modulus(i) + bond_modulus(j)) / 2 * dt * q);
        now[{i, j}] = tau;
        const Real volume = m_.volume[i] * m_.volume[j] * omega(r) * (1 / work_[i].omega0 + 1 / work_[j].omega0);
        const Mat2 moment = volume * tau * xi.transpose() / r;
        work_[i].force += volume * tau / r, work_[j].force -= volume * tau / r;
        work_[i].bond_moment += moment, work_[j].bond_moment += moment;
      });
    traction_ = std::move(now);
  }

  void find_flux(std::size_t i) {
    work_[i].flux = (stress(i) - work_[i].bond_moment / (2 * m_.volume[i])) * work_[i].inverse;
  }

  /// P_g = Q^T P S, and the weight between particle and image, at most doubling the pressure there.
  void press_images() {
    for (Image& g : images_) {
      g.flux = work_[g.parent].flux;
      for (const FlowWall* w : g.walls) {
        const Mat2 s = mirror(*w);
        g.flux = w->rough != 0 ? Mat2(-g.flux * s) : Mat2(s * g.flux * s);
      }
      for (const FlowWall* w : g.walls) {
        const Vec2 n = normal(*w);
        Vec2 b = -2 * distance(*w, g.x) / m_.volume[g.parent] * weight_of(g.parent);
        const Real across = -b.dot(n), pressure = -n.dot(stress(g.parent) * n);
        if (across > 0 && across > pressure) b *= std::max<Real>(pressure, 0) / across;
        if (w->rough == 0) b = b.dot(n) * n;
        g.flux += b * n.transpose();
      }
    }
  }

  /// A spring and a dashpot across a wall nearer than half the guard distance; along a rough one a spring.
  Vec2 contact(std::size_t i) {
    Particle& p = particles[i];
    Vec2 force(0, 0);
    bool held = false;
    const Real reach = m_.options.guard_distance * m_.size[i] / 2, density = m_.mass[i] / m_.volume[i];
    for (const FlowWall& w : m_.walls) {
      const Vec2 n = normal(w), along(w.ny, -w.nx);
      const Real d = distance(w, p.x);
      if (d >= reach) continue;
      const Real dashpot = 0.2 * m_.spacing * density * std::sqrt(wave(i) / density);
      force += n * std::max<Real>(2 * m_.options.guard_stiffness * wave(i) * (reach - d) - dashpot * p.v.dot(n), 0);
      if (w.rough == 0 || held) continue;
      held = true;
      p.wall_stretch += m_.time_step * p.v.dot(along);
      force -= moduli(i).shear_modulus * p.wall_stretch * along;
    }
    if (!held) p.wall_stretch = 0;
    return force;
  }

  void push(std::size_t i) {
    Work& w = work_[i];
    Vec2 sum(0, 0);
    around(i, [&](std::size_t j, const Vec2& xi, Real r) {
      sum += omega(r) * m_.volume[j] * (w.flux + work_[j].flux) * xi;
    });
    for (const Image& g : images_) {
      const Vec2 xi = g.x - particles[i].x;
      sum += omega(xi.norm()) * m_.volume[g.parent] * (w.flux + g.flux) * xi;
    }
    w.force += m_.volume[i] * sum + contact(i) + weight_of(i);
  }

  /// sigma_i += 2 zeta h c dt sum_j V_j omega [sigma_j - sigma_i - (grad_i + grad_j) . xi / 2]
  void diffuse() {
    for (std::size_t i = 0; i < n_; ++i) {
      around(i, [&](std::size_t j, const Vec2& xi, Real r) {
        work_[i].slope += omega(r) * m_.volume[j] * xi * (components(j) - components(i)).transpose();
      });
      work_[i].slope = (work_[i].soil_inverse * work_[i].slope / 2).eval();
    }
    std::vector<Eigen::Vector4d> change(n_, Eigen::Vector4d::Zero());
    for (std::size_t i = 0; i < n_; ++i) {
      around(i, [&](std::size_t j, const Vec2& xi, Real r) {
        if (!diffuses(i) && !diffuses(j)) return;
        change[i] += omega(r) * m_.volume[j] *
                     (components(j) - components(i) - (work_[i].slope + work_[j].slope).transpose() * xi);
      });
      const Real speed = std::sqrt(wave(i) * m_.volume[i] / m_.mass[i]);
      change[i] *= 2 * m_.options.stress_diffusion * h_ * speed * m_.time_step;
    }
    for (std::size_t i = 0; i < n_; ++i) {
      Mat2 deviator;
      deviator << change[i][0], change[i][2], change[i][2], change[i][1];
      particles[i].deviator += deviator, particles[i].mean += change[i][3];
    }
  }

  const FlowModel& m_;
  std::size_t n_;
  Real h_, full_ = 0;
  bool rival_ = false, yields_ = false;
  std::vector<Work> work_;
  std::vector<Image> images_;
  std::map<std::pair<std::size_t, std::size_t>, Vec2> traction_;

 public:
  std::vector<Particle> particles;  ///< by id
};

}  // namespace vbgpd::test
