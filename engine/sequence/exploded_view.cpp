#include "engine/sequence/exploded_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// Between the boxes of two bodies, as a share of the product's diagonal.
constexpr double kGapShare = 0.025;

Box3 worldBox(const RigidBody& body) { return boundingBox(*body.mesh, body.X_WB); }

Box3 widened(const Box3& box, double by) {
  return {box.min() - Vector3::Constant(by), box.max() + Vector3::Constant(by)};
}

/// From where to where along the direction the moving box meets the other one; empty (first > second) where never.
std::pair<double, double> meeting(const Box3& moving, const Vector3& direction, const Box3& other) {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double low = other.min()[axis] - moving.max()[axis];
    const double high = other.max()[axis] - moving.min()[axis];
    const double speed = direction[axis];
    if (std::abs(speed) < 1e-9) {
      if (low > 0.0 || high < 0.0) return {1.0, 0.0};
      continue;
    }
    from = std::max(from, std::min(low / speed, high / speed));
    to = std::min(to, std::max(low / speed, high / speed));
  }
  return {from, to};
}

/// The least distance from which on the box is clear of all others.
double clearDistance(const Box3& moving, const Vector3& direction, const std::vector<Box3>& others) {
  double distance = 0.0;
  for (bool met = true; met;) {
    met = false;
    for (const Box3& other : others) {
      const auto [from, to] = meeting(moving, direction, other);
      if (from > distance || to <= distance) continue;
      distance = to;
      met = true;
    }
  }
  return distance;
}

/// The body that the step's body was attached to: whose fit overlaps it most, else the nearest one.
std::optional<std::size_t> carrierOf(const AssemblyStep& step, const AssembledProduct& product) {
  const auto deepest =
      std::max_element(step.allowances.begin(), step.allowances.end(),
                       [](const StepAllowance& a, const StepAllowance& b) { return a.overlap < b.overlap; });
  if (deepest != step.allowances.end()) return product.indexOf(deepest->body);
  return step.proof.nearest.empty() ? std::nullopt : product.indexOf(step.proof.nearest);
}

}  // namespace

std::vector<Vector3> explodedOffsets(const AssembledProduct& product, const AssemblyPlan& plan) {
  std::vector<Vector3> offsets(product.bodies.size(), Vector3::Zero());
  BodySet leaves(product.bodies.size(), false);
  for (const AssemblyStep& step : plan.steps) {
    for (const std::size_t body : bodiesOf(step, product)) leaves[body] = true;
  }
  Box3 whole;
  std::vector<Box3> placed;
  for (std::size_t body = 0; body < product.bodies.size(); ++body) {
    const Box3 box = worldBox(product.bodies[body]);
    whole.extend(box);
    if (!leaves[body]) placed.push_back(box);
  }
  const double gap = kGapShare * whole.diagonal().norm();
  for (auto step = plan.steps.rbegin(); step != plan.steps.rend(); ++step) {
    const std::vector<std::size_t> bodies = bodiesOf(*step, product);
    const auto carrier = carrierOf(*step, product);
    const Vector3 carried = carrier ? offsets[*carrier] : Vector3(Vector3::Zero());
    const Vector3 direction = exitDirection(step->path);
    Box3 box;
    for (const std::size_t body : bodies) box.extend(worldBox(product.bodies[body]));
    box.translate(carried);
    const Vector3 offset = carried + clearDistance(widened(box, gap), direction, placed) * direction;
    box.translate(offset - carried);
    placed.push_back(box);
    for (const std::size_t body : bodies) offsets[body] = offset;
  }
  return offsets;
}

}  // namespace glissade
