#include "engine/sequence/base_choice.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace glissade {
namespace {

/// A body stands on the ground if its lowest point is above it by less than this share of the product's height.
constexpr double kGround = 0.02;
/// How much more a body counts that stands on the ground.
constexpr double kStands = 1.5;

/// Height of the body's lowest point against gravity, metres.
double lowestOf(const RigidBody& body, const Vector3& up) {
  const Box3 box = boundingBox(*body.mesh, body.X_WB);
  return up.dot(box.center()) - 0.5 * up.cwiseAbs().dot(box.sizes());
}

std::vector<bool> mayBeBase(std::size_t bodies, const Joints& joints, const std::vector<FastenerKind>& fasteners) {
  std::vector<bool> may(bodies, true);
  for (std::size_t body = 0; body < fasteners.size(); ++body) may[body] = fasteners[body] == FastenerKind::None;
  for (const Joint& joint : joints) {
    const bool isUnit = joint.kind == JointKind::Unit || joint.kind == JointKind::Permanent;
    if (!isUnit && joint.kind != JointKind::Snap) may[joint.body] = false;
  }
  return may;
}

}  // namespace

std::size_t baseOf(const AssembledProduct& product, const BodySet& among, const LiaisonGraph& graph,
                   const Joints& joints, const std::vector<FastenerKind>& fasteners, const Vector3& gravity) {
  const bool hasGround = gravity.norm() > 0.0;
  const Vector3 up = hasGround ? Vector3(-gravity.normalized()) : Vector3(Vector3::UnitZ());
  const Box3 whole = boxOf(product, among);
  const double height = up.cwiseAbs().dot(whole.sizes());
  const double ground = up.dot(whole.center()) - 0.5 * height;
  const std::vector<bool> may = mayBeBase(product.bodies.size(), joints, fasteners);
  // Ordered by: touches another one; no fastener; worth; size.
  const auto rank = [&](std::size_t body) {
    const auto& all = graph.neighboursOf(body);
    const auto touching = std::count_if(all.begin(), all.end(), [&](std::size_t other) { return among[other]; });
    const bool stands = hasGround && lowestOf(product.bodies[body], up) - ground <= kGround * height;
    const double size = boxVolume(product.bodies[body]);
    const double worth = std::sqrt(static_cast<double>(touching)) * std::cbrt(size) * (stands ? kStands : 1.0);
    return std::tuple(touching > 0, may[body], worth, size);
  };
  const BodyGroup bodies = bodiesIn(among);
  return *std::max_element(bodies.begin(), bodies.end(),
                           [&](std::size_t one, std::size_t other) { return rank(one) < rank(other); });
}

}  // namespace glissade
