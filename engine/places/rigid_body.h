#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/model/body_id.h"
#include "engine/model/body_path.h"

namespace glissade {

class Product;

/// Static bodies belong to the building; a person may move mobile ones (paper 2, section 4.1). Both are obstacles to
/// the object.
enum class Mobility { Static, Mobile };
inline constexpr EnumNames<Mobility, 2> kMobilityNames{{"static", "mobile"}};

/// A colour in sRGB, each component in 0...1.
using Colour = std::array<double, 3>;

/// Opacity of displayed obstacles, so that objects between and behind them are visible.
inline constexpr double kObstacleOpacity = 0.38;

/// A named rigid body placed in the world.
struct RigidBody {
  BodyId id;
  std::string name;  ///< path in the product (assembly/body_path.h)
  Mobility mobility = Mobility::Static;
  MeshPtr mesh;  ///< mesh in the body's frame B
  Pose X_WB;
  Colour colour{0.6, 0.6, 0.6};
  std::string label{};  ///< displayed name (labelBodies())

  const std::string& shown() const { return label.empty() ? name : label; }
};

/// The ids of the bodies, in their order.
std::vector<BodyId> idsOf(const std::vector<RigidBody>& bodies);

/// Sets the displayed name of each of these bodies (Product::labels()).
void labelBodies(std::vector<RigidBody>& bodies, const Product& product);

/// Id of the scenario's body that contains a rigid body: the links "<body>/<link>" of a URDF file are one body.
inline BodyId bodyIdOf(const BodyId& rigidBodyId) { return BodyId(firstStepOf(rigidBodyId.text())); }

}  // namespace glissade
