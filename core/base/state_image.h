// A saved instant as plain data: what a checkpoint carries from one process to another. By particle id, so that it does
// not depend on how a simulation stores its particles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vbgpd {

struct StateImage {
  struct Number {
    std::string name;
    double value = 0;
  };
  struct Rows {
    std::string name;
    int components = 1;
    std::vector<double> values;  ///< packed rows by particle id (or by load, by boundary)
  };
  /// Plastic strain of a bond; bonds that never yielded have none.
  struct PlasticBond {
    std::int32_t a = 0, b = 0;  ///< particle ids of its ends
    double xx = 0, yy = 0, xy = 0;
  };
  std::int64_t particles = 0, bonds = 0;
  bool runs_out = false;  ///< of a run-out: soil only, and the order of the particles is part of it
  std::vector<Number> numbers;
  std::vector<Rows> rows;
  std::vector<PlasticBond> plastic;
  bool placed = false;                     ///< soil was placed on a section that had moved
  std::vector<PlasticBond> placed_strain;  ///< the part of `plastic` that is the shape it was placed in
  std::uint64_t hash = 0;                  ///< of the state it was made from
};

}  // namespace vbgpd
