#pragma once

#include <map>
#include <memory>
#include <optional>

#include "engine/geometry/triangle_tree.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// A direction of view on a product: from one of eight corners. For a product that is turned over, its underside is up.
struct Viewpoint {
  int quarter = 0;  ///< quarter turns of the eye about `workUp`, from 0 to 3
  bool turnedOver = false;
  Vector3 workUp = Vector3::UnitZ();  ///< AssemblyPlan::up

  /// Unit direction from the product to the eye, frame of the product.
  Vector3 toEye() const;
  /// Upward direction of the picture, frame of the product; not perpendicular to toEye().
  Vector3 up() const;

  bool operator==(const Viewpoint&) const = default;
};

/// Chooses viewpoints for steps of a plan. Refers to the product.
class StepView {
 public:
  explicit StepView(const AssembledProduct& product) : product_(product) {}

  /// Keeps the viewpoint of the step before unless another one shows the coming bodies much better. The other viewpoint
  /// shows most of them where they are assembled, and their motion from the side and not from below, with few turns of
  /// the product. `steps`: the coming steps; `present`: all bodies that are there then, including the coming ones.
  Viewpoint choose(const std::vector<AssemblyStep>& steps, const BodySet& present, const Viewpoint& before);
  /// The viewpoint's direction from which most of the step's first body, assembled, is visible. Nothing if enough of it
  /// is visible from `toEye`, or no viewpoint shows clearly more.
  std::optional<Vector3> betterEye(const AssemblyStep& step, const BodySet& present, const Vector3& toEye);
  /// Share of the surface facing the eye that no other body hides, from 0 to 1. `toEye` is a unit vector.
  double shareSeen(std::size_t body, const BodySet& present, const Vector3& toEye);

 private:
  const TriangleTree& treeOf(std::size_t body);
  bool isHidden(const Vector3& p_W, const BodySet& present, const Vector3& toEye);
  double score(const std::vector<AssemblyStep>& steps, const BodySet& present, const Viewpoint& from);

  const AssembledProduct& product_;
  std::map<MeshPtr, std::unique_ptr<const TriangleTree>> trees_;
};

}  // namespace glissade
