#include "engine/fits/product_shapes.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/triangle_pair.h"

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

std::vector<CylinderRegion> ProductShapes::cylindersOf(std::size_t index) const {
  Shape& shape = shapeOf(index);
  if (!shape.cylinders) shape.cylinders = findSurfaceRegions(welded(*body(index).mesh)).cylinders;
  std::vector<CylinderRegion> placed = *shape.cylinders;
  for (CylinderRegion& cylinder : placed) {
    const AxisLine axis = transformed(AxisLine{cylinder.point, cylinder.direction}, body(index).X_WB);
    cylinder.point = axis.point;
    cylinder.direction = axis.direction;
  }
  return placed;
}

AxisLine ProductShapes::seenFrom(std::size_t index, const AxisLine& axis_W) const {
  return transformed(axis_W, inverse(body(index).X_WB));
}

double ProductShapes::apart(std::size_t a, std::size_t b, double limit) const {
  double least = 2.0 * limit + 1e-9;
  if (boxes_[a].exteriorDistance(boxes_[b]) > limit) return least;
  const Pose X_AB = inverse(body(a).X_WB) * body(b).X_WB;
  const Vector3 margin = Vector3::Constant(limit);
  for (const Triangle& triangle : axial(b).tree().triangles()) {
    const Triangle moved{X_AB * triangle[0], X_AB * triangle[1], X_AB * triangle[2]};
    Box3 box(Vector3(moved[0].cwiseMin(moved[1]).cwiseMin(moved[2]) - margin),
             Vector3(moved[0].cwiseMax(moved[1]).cwiseMax(moved[2]) + margin));
    axial(a).tree().visit(box, [&](std::uint32_t t) {
      const Triangle& other = axial(a).tree().triangles()[t];
      least = trianglesMeet(other, moved) ? 0.0 : std::min(least, std::sqrt(triangleDistance(other, moved).squared));
      return least > 0.0;
    });
    if (least <= 0.0) return least;
  }
  return least;
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
