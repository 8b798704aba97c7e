// Numbers and small vectors. Tension is positive everywhere in core; SI units; angles in radians inside, degrees in a
// scene.
#pragma once

#include <Eigen/Core>

#include "base/real.h"

namespace vbgpd {

template <int Dim>
using Vec = Eigen::Matrix<Real, Dim, 1>;
template <int Dim>
using Mat = Eigen::Matrix<Real, Dim, Dim>;
using Vec2 = Vec<2>;
using Mat2 = Mat<2>;

}  // namespace vbgpd
