#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "engine/fits/around_shaft.h"
#include "engine/fits/assembled_product.h"
#include "engine/fits/surface_regions.h"

namespace glissade {

/// The shapes of a product's bodies, each computed once on demand. Used by one thread.
class ProductShapes {
 public:
  explicit ProductShapes(const AssembledProduct& product);

  const AssembledProduct& product() const { return product_; }
  std::size_t size() const { return product_.bodies.size(); }
  const RigidBody& body(std::size_t index) const { return product_.bodies[index]; }
  const Box3& box(std::size_t index) const { return boxes_[index]; }
  const AxialMesh& axial(std::size_t index) const;
  /// Null if the body is not turned.
  const TurnedShape* turned(std::size_t index) const;
  /// The axis of turned() in the world.
  AxisLine axisOf(std::size_t index) const;
  /// The cylinders of the body in the world frame, from findSurfaceRegions().
  std::vector<CylinderRegion> cylindersOf(std::size_t index) const;
  /// An axis of the world in the body's frame.
  AxisLine seenFrom(std::size_t index, const AxisLine& axis_W) const;
  /// Distance of the meshes of two bodies, metres; more than `limit` if they are farther apart.
  double apart(std::size_t a, std::size_t b, double limit) const;
  /// Bodies other than `but` whose boxes meet the box around a part of an axis of the world; ascending.
  std::vector<std::size_t> near(const AxisLine& axis_W, const AxialReach& reach, std::size_t but) const;

 private:
  struct Shape {
    std::unique_ptr<const AxialMesh> axial;
    std::optional<std::optional<TurnedShape>> turned;
    std::optional<std::vector<CylinderRegion>> cylinders;
  };
  Shape& shapeOf(std::size_t index) const;

  const AssembledProduct& product_;
  std::vector<Box3> boxes_;
  mutable std::map<MeshPtr, Shape> shapes_;
};

/// True if the axes are parallel, and the second one passes the middle of the body's axis within `apart` metres.
bool isSameAxis(const AxisLine& one, const AxisLine& other, double apart);

}  // namespace glissade
