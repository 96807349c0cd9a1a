#include "engine/product/product_shapes.h"

#include <cmath>

namespace glissade {
namespace {

constexpr double kSameDirectionSine = 0.02;

}  // namespace

ProductShapes::ProductShapes(const AssembledProduct& product) : product_(product) {
  for (const RigidBody& body : product.bodies) boxes_.push_back(boundingBox(*body.mesh, body.X_WB));
}

ProductShapes::Shape& ProductShapes::shapeOf(std::size_t index) const { return shapes_[body(index).mesh]; }

const AxialMesh& ProductShapes::axial(std::size_t index) const {
  Shape& shape = shapeOf(index);
  if (!shape.axial) shape.axial = std::make_unique<const AxialMesh>(*body(index).mesh);
  return *shape.axial;
}

const TurnedShape* ProductShapes::turned(std::size_t index) const {
  Shape& shape = shapeOf(index);
  if (!shape.turned) shape.turned = turnedShapeOf(*body(index).mesh, axial(index));
  return *shape.turned ? &**shape.turned : nullptr;
}

AxisLine ProductShapes::axisOf(std::size_t index) const { return transformed(turned(index)->axis, body(index).X_WB); }

AxisLine ProductShapes::seenFrom(std::size_t index, const AxisLine& axis_W) const {
  return transformed(axis_W, inverse(body(index).X_WB));
}

std::vector<std::size_t> ProductShapes::near(const AxisLine& axis_W, const AxialReach& reach, std::size_t but) const {
  Box3 box(Vector3(axis_W.point + reach.low * axis_W.direction));
  box.extend(Vector3(axis_W.point + reach.high * axis_W.direction));
  box.min().array() -= reach.radius;
  box.max().array() += reach.radius;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (i != but && boxes_[i].intersects(box)) found.push_back(i);
  }
  return found;
}

bool isSameAxis(const AxisLine& one, const AxisLine& other, double apart) {
  return one.direction.cross(other.direction).norm() < kSameDirectionSine && one.distanceOf(other.point) < apart;
}

}  // namespace glissade
