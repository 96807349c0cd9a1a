#pragma once

#include <map>
#include <memory>

#include "engine/base/work_watch.h"
#include "engine/geometry/triangle_tree.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// Chooses from where a step of a plan is looked at. Refers to the product.
class StepView {
 public:
  explicit StepView(const AssembledProduct& product) : product_(product) {}

  /// Unit direction from the scene to the eye, world frame: of some directions the one from which most of the moving
  /// body is seen where it is assembled, and its motion from the side. `present`: bodies that are there.
  Vector3 directionToEye(const AssemblyStep& step, const BodySet& present);

 private:
  const TriangleTree& treeOf(std::size_t body);
  /// Share of the body's surface that is seen from the direction.
  double seen(std::size_t body, const BodySet& present, const Vector3& toEye);
  bool isHidden(const Vector3& p_W, const BodySet& present, const Vector3& toEye);

  const AssembledProduct& product_;
  std::map<MeshPtr, std::unique_ptr<const TriangleTree>> trees_;
};

/// Of each step of a plan, while the bodies are there that have not left before it. Ends early where it is asked to
/// stop. Precondition: the plan is about the product.
std::vector<Vector3> directionsToEye(const AssemblyPlan& plan, const AssembledProduct& product,
                                     const WorkWatch& watch = {});

}  // namespace glissade
