#pragma once

#include <map>
#include <memory>
#include <optional>

#include "engine/geometry/triangle_tree.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// From where a product is looked at: one of eight corners. Where the product is turned over, its underside is up.
struct Viewpoint {
  int quarter = 0;  ///< quarter turns of the eye about +z, from 0 to 3
  bool turnedOver = false;

  /// Unit direction from the product to the eye, world frame.
  Vector3 toEye() const;
  /// World frame; not perpendicular to toEye().
  Vector3 up() const;

  bool operator==(const Viewpoint&) const = default;
};

/// Chooses from where steps of a plan are looked at. Refers to the product.
class StepView {
 public:
  explicit StepView(const AssembledProduct& product) : product_(product) {}

  /// The viewpoint of the step before, unless another one shows the bodies that come much better: then the one that
  /// shows most of them where they are assembled, and their motion from the side and not from below, with few turns of
  /// the product.
  /// `steps`: what comes; `present`: all bodies that are there then, those that come among them.
  Viewpoint choose(const std::vector<AssemblyStep>& steps, const BodySet& present, const Viewpoint& before);
  /// The direction to an eye from which the bodies of a step are seen where they are assembled: of the viewpoints the
  /// one that shows most of them. Nothing where most is seen already, or no viewpoint shows clearly more.
  std::optional<Vector3> betterEye(const AssemblyStep& step, const BodySet& present, const Vector3& toEye);
  /// Share of the surface that faces the eye which no other body hides, from 0 to 1. `toEye` is a unit vector.
  double shareSeen(std::size_t body, const BodySet& present, const Vector3& toEye);

 private:
  const TriangleTree& treeOf(std::size_t body);
  bool isHidden(const Vector3& p_W, const BodySet& present, const Vector3& toEye);
  double score(const std::vector<AssemblyStep>& steps, const BodySet& present, const Viewpoint& from);

  const AssembledProduct& product_;
  std::map<MeshPtr, std::unique_ptr<const TriangleTree>> trees_;
};

}  // namespace glissade
