#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/assembly/body_path.h"
#include "engine/base/enum_names.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

class Product;

/// Static bodies belong to the building; mobile ones may be moved by somebody (paper 2, section
/// 4.1). Both are obstacles to the object.
enum class Mobility { Static, Mobile };
inline constexpr EnumNames<Mobility, 2> kMobilityNames{{"static", "mobile"}};

/// sRGB, each 0...1.
using Colour = std::array<double, 3>;

/// Opacity that obstacles are shown with: what happens between and behind them matters.
inline constexpr double kObstacleOpacity = 0.38;

/// A named rigid body placed in the world.
struct RigidBody {
  std::string id;    ///< stable, unique in the scenario
  std::string name;  ///< its path in the product (assembly/body_path.h)
  Mobility mobility = Mobility::Static;
  MeshPtr mesh;  ///< in the body's frame B
  Pose X_WB;
  Colour colour{0.6, 0.6, 0.6};
  std::string label{};  ///< what people see of the name (labelBodies())

  const std::string& shown() const { return label.empty() ? name : label; }
};

/// Gives each body what people see of its name among these (Product::labels()).
void labelBodies(std::vector<RigidBody>& bodies, const Product& product);

/// Id of the scenario's body that a rigid body belongs to: the links "<body>/<link>" of a URDF file are one.
inline std::string bodyIdOf(const std::string& rigidBodyId) { return firstStepOf(rigidBodyId); }

}  // namespace glissade
