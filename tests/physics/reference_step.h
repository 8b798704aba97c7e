// The method as plain loops over all pairs, straight from the equations (VB1-VB5, rate-free total form): slow, and the
// oracle for the fast step. Uses the section's seeds only; shares nothing with core/step but the material laws.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <vector>

#include "geometry/section.h"
#include "material/any_law.h"
#include "material/cone.h"
#include "material/hexagon.h"
#include "simulation/build_model.h"
#include "simulation/cohesion_gradient.h"
#include "smoothing/any_kernel.h"

namespace vbgpd::test {

class ReferenceStep {
 public:
  ReferenceStep(const SceneDef& scene, const Section& section, const Model& model, Real factor)
      : scene_(scene),
        section_(section),
        constants_(pair_constants(model, factor, false)),
        laws_(model.pair_law),
        factor_(factor),
        extra_(extra_cohesion_of_seeds(scene, section)) {
    const auto n = section.seeds.size();
    u.assign(n, Vec2::Zero()), v.assign(n, Vec2::Zero()), plastic_volume.assign(n, 0);
    for (const CutPair& c : section.cut_pairs) cut_[{c.a, c.b}] = true;
    h_ = scene.smoothing_ratio * std::sqrt(section.lattice.spacing.x() * section.lattice.spacing.y());
    for (std::size_t i = 0; i < n; ++i) x.push_back(section.place(i));
    // VB1: M_i = sum omega V xi xi^T, omega0_i = sum omega V
    for (std::size_t i = 0; i < n; ++i) {
      Mat2 moment = Mat2::Zero();
      Real omega0 = 0;
      for (std::size_t j = 0; j < n; ++j)
        if (bonded(i, j))
          moment += weight(i, j) * volume(j) * (x[j] - x[i]) * (x[j] - x[i]).transpose(),
              omega0 += weight(i, j) * volume(j);
      inverse_moment.push_back(moment.inverse());
      omega0_.push_back(omega0);
    }
  }

  bool bonded(std::size_t i, std::size_t j) const {
    if (i == j || !((x[j] - x[i]).norm() < 2 * h_ * (1 - 1e-9))) return false;
    return cut_.find({static_cast<Index>(std::min(i, j)), static_cast<Index>(std::max(i, j))}) == cut_.end();
  }
  Real volume(std::size_t i) const { return section_.seeds[i].volume; }

  /// Internal forces at the present u; yields on the way.
  std::vector<Vec2> internal_forces() {
    const auto n = x.size();
    std::vector<Mat2> L(n, Mat2::Zero()), VS(n, Mat2::Zero());
    std::vector<Real> theta(n), source(n, 0);
    std::vector<Vec2> f(n, Vec2::Zero());
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        if (bonded(i, j)) L[i] += (u[j] - u[i]) * phi(i, j).transpose();  // VB2
      theta[i] = L[i].trace() - plastic_volume[i];
      const LawConstants& c = constants_[pair_of(i, i)];
      const Real over = std::max(0.0, theta[i] - c.t / c.bulk_modulus);  // tension cut-off: a gap
      theta[i] -= over;
      if (keeps_gaps) plastic_volume[i] += over;
    }
    const bool bonds = scene_.bond != "none";
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j) {
        if (bonds ? !bonded(i, j) : j != i) continue;
        const std::size_t pair = pair_of(i, j);
        LawConstants c = constants_[pair];
        c.k += (extra_[i] + extra_[j]) / 2 / factor_ * c.k_per_cohesion;
        Mat2 gradient = (L[i] + L[j]) / 2;
        Vec2 normal = Vec2::Zero();
        Real r = 0, bond_volume = volume(i);
        if (bonds) {
          const Vec2 xi = x[j] - x[i];
          r = xi.norm(), normal = xi / r;
          gradient += ((u[j] - u[i]) / r - gradient * normal) * normal.transpose();
          bond_volume = volume(i) * volume(j) * weight(i, j) * (1 / omega0_[i] + 1 / omega0_[j]);
        }
        const Mat2 d = (gradient + gradient.transpose()) / 2;
        Eigen::Vector3d& ep = plastic_strain[{i, j}];
        if (ep.size() == 0 || !touched_[{i, j}]) ep.setZero(), touched_[{i, j}] = true;
        const Real third = d.trace() / 3, G2 = 2 * c.shear_modulus;  // VB3, VB4
        const Stress<Real> trial{G2 * (d(0, 0) - third - ep[0]), G2 * (d(1, 1) - third - ep[1]), G2 * (d(0, 1) - ep[2]),
                                 c.bulk_modulus * (theta[i] + theta[j]) / 2};
        const Returned<Real> r_map = algorithm_of(laws_[pair]) == ReturnAlgorithm::kCone
                                         ? return_to(Cone<Real>(c), trial)
                                         : return_to(Hexagon<Real>(c), trial);
        const Stress<Real>& s = r_map.stress;
        ep += Eigen::Vector3d(trial.xx - s.xx, trial.yy - s.yy, trial.xy - s.xy) / G2;
        const Real dilated = r_map.dilated;
        Mat2 deviator;
        deviator << s.xx, s.xy, s.xy, s.yy;
        if (!bonds) {
          VS[i] = volume(i) * (deviator + s.m * Mat2::Identity());
          source[i] += volume(i) * dilated;
          continue;
        }
        const Mat2 share =
            bond_volume / 2 * (deviator * (Mat2::Identity() - normal * normal.transpose()) + s.m * Mat2::Identity());
        VS[i] += share, VS[j] += share;  // VB5
        const auto bulk = [&](std::size_t k) { return constants_[pair_of(k, k)].bulk_modulus; };
        source[i] += bond_volume / 2 * dilated * c.bulk_modulus / bulk(i);  // springs in series
        source[j] += bond_volume / 2 * dilated * c.bulk_modulus / bulk(j);
        f[i] += bond_volume * deviator * normal / r, f[j] -= bond_volume * deviator * normal / r;
      }
    for (std::size_t i = 0; i < n; ++i) {
      plastic_volume[i] += source[i] / volume(i);
      for (std::size_t j = 0; j < n; ++j)
        if (bonded(i, j)) f[i] += VS[i] * phi(i, j) - VS[j] * phi(j, i);
    }
    return f;
  }

  std::vector<Vec2> x, u, v;
  std::vector<Real> plastic_volume;
  bool keeps_gaps = false;  ///< true dynamics; else they close where they opened
  std::vector<Mat2> inverse_moment;
  std::map<std::pair<std::size_t, std::size_t>, Eigen::Vector3d> plastic_strain;

 private:
  Real weight(std::size_t i, std::size_t j) const {
    const Real exact = value(*kernel_by_name(scene_.kernel), (x[j] - x[i]).norm(), h_);
    return scene_.jitter > 0 ? static_cast<Real>(static_cast<float>(exact)) : exact;  // weights of their own are single
  }
  Vec2 phi(std::size_t i, std::size_t j) const { return volume(j) * weight(i, j) * inverse_moment[i] * (x[j] - x[i]); }
  std::size_t pair_of(std::size_t i, std::size_t j) const {
    const auto a = section_.seeds[i].material, b = section_.seeds[j].material;
    return static_cast<std::size_t>(std::min(a, b)) * scene_.materials.size() +
           static_cast<std::size_t>(std::max(a, b));
  }
  const SceneDef& scene_;
  const Section& section_;
  std::vector<LawConstants> constants_;
  std::vector<AnyLaw> laws_;
  Real factor_, h_ = 0;
  std::vector<Real> extra_;
  std::vector<Real> omega0_;
  std::map<std::pair<Index, Index>, bool> cut_;
  std::map<std::pair<std::size_t, std::size_t>, bool> touched_;
};

}  // namespace vbgpd::test
