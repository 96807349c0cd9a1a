#pragma once

#include <string>

#include "tests/oracle/vectors.h"

namespace glissade::oracle {

/// The solids of a scenario file, in metres: each body in the world, the object in its own frame.
struct Scene {
  std::vector<Triangles> bodies;
  Triangles object;
};

/// Reads the scenario and its mesh files. Bodies and the object must be meshes of Z-up assets. Throws
/// std::runtime_error.
Scene readScene(const std::string& file);

/// The configurations of a path file (CSV, as resources and README describe it). Throws std::runtime_error.
std::vector<Placement> readPath(const std::string& file);

/// The straight motion between two configurations as the documents define it: linear in position, the shorter
/// great arc in orientation.
Placement between(const Placement& a, const Placement& b, double t);

}  // namespace glissade::oracle
