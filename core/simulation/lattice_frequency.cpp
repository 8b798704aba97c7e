// The highest natural frequency of the bonds, which bounds the time step.
#include <Eigen/Eigenvalues>
#include <cmath>

#include "simulation/lattice_simulation.h"

namespace vbgpd {

namespace {

/// Of a symmetric tridiagonal matrix.
Real largest_eigenvalue(const std::vector<Real>& diagonal, const std::vector<Real>& beside) {
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>> solver;
  solver.computeFromTridiagonal(Eigen::Map<const Vector>(diagonal.data(), std::ssize(diagonal)),
                                Eigen::Map<const Vector>(beside.data(), std::ssize(beside)), Eigen::EigenvaluesOnly);
  return solver.eigenvalues().maxCoeff();
}

}  // namespace

/// Largest eigenvalue of M^-1 K by Lanczos' recurrence in the inner product of the masses: q_k are its vectors.
Real LatticeSimulation::highest_frequency(const Array& mass) const {
  const auto n = static_cast<std::size_t>(model_.storage);
  Array no_force;
  no_force.allocate(n, 0, model_.heap);
  const auto dot = [&](const Array& ax, const Array& ay, const Array& bx, const Array& by) {
    Real sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += mass[i] * (ax[i] * bx[i] + ay[i] * by[i]);
    return sum;
  };
  const auto subtract = [&](Array& a, Real factor, const Array& b) {
    for (std::size_t i = 0; i < n; ++i) a[i] -= factor * b[i];
  };
  State s;
  s.allocate(model_);
  Array qx = s.displacement_x, qy = s.displacement_y, before_x = qx, before_y = qy;
  std::uint64_t seed = 88172645463325252ull;  // xorshift: the same start for every model of a size
  const auto next = [&] {
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    return static_cast<double>(seed >> 11) * 0x1p-53 - 0.5;
  };
  for (std::size_t i = 0; i < n; ++i)
    if (model_.seed_of[i] >= 0) qx[i] = next() * model_.free_x[i], qy[i] = next() * model_.free_y[i];
  Controls c;  // one step from rest with b = 0, dt = 1, no external force gives v = -M^-1 K u
  c.time_step = c.kick = 1, c.momentum = 0;
  c.mass = mass.data();
  c.constants = elastic_constants_.data();
  Sums sums;
  constexpr int kMost = 300, kLook = 5;
  constexpr Real kSettled = 1e-3;
  std::vector<Real> diagonal, beside;
  Real eigenvalue = 0, norm = std::sqrt(dot(qx, qy, qx, qy));
  for (int k = 0; k < kMost && norm > 0; ++k) {
    for (std::size_t i = 0; i < n; ++i) qx[i] /= norm, qy[i] /= norm;
    s.displacement_x = qx, s.displacement_y = qy;
    s.velocity_x.fill_zero(), s.velocity_y.fill_zero();
    StepData d = data(s, scratch_);
    d.force_x = d.force_y = no_force.data();
    d.guided_count = 0;
    kernels_.step(model_.features.bond != BondLaw::kNone, model_.off_lattice(), false)(d, c, workers_, partial_.data(),
                                                                                       sums);
    Array &wx = s.velocity_x, &wy = s.velocity_y;
    if (k > 0) subtract(wx, -norm, before_x), subtract(wy, -norm, before_y);
    const Real along = -dot(wx, wy, qx, qy);
    subtract(wx, -along, qx), subtract(wy, -along, qy);
    if (k > 0) beside.push_back(norm);
    diagonal.push_back(along);
    if (k % kLook == kLook - 1) {
      const Real earlier = eigenvalue;
      eigenvalue = largest_eigenvalue(diagonal, beside);
      if (eigenvalue < (1 + kSettled) * earlier) break;
    }
    before_x = qx, before_y = qy;
    for (std::size_t i = 0; i < n; ++i) qx[i] = -wx[i], qy[i] = -wy[i];
    const Real was = norm;
    norm = std::sqrt(dot(qx, qy, qx, qy));
    if (!(norm > 1e-12 * (k > 0 ? was : along))) {  // the vectors span all there is
      eigenvalue = largest_eigenvalue(diagonal, beside);
      break;
    }
  }
  return std::sqrt(eigenvalue);
}

}  // namespace vbgpd
