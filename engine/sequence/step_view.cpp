#include "engine/sequence/step_view.h"

#include <array>
#include <cmath>
#include <limits>

#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// The usual direction first; corners from above before those from below.
const std::array<Vector3, 8> kDirections{{{-1.0, -1.2, 0.9},
                                          {1.2, -1.0, 0.9},
                                          {1.0, 1.2, 0.9},
                                          {-1.2, 1.0, 0.9},
                                          {-1.0, -1.2, -0.7},
                                          {1.2, -1.0, -0.7},
                                          {1.0, 1.2, -0.7},
                                          {-1.2, 1.0, -0.7}}};
constexpr std::array<double, 8> kPreference{1.0, 0.97, 0.97, 0.97, 0.8, 0.8, 0.8, 0.8};
/// Points of a surface that are looked at.
constexpr std::size_t kSamples = 160;
/// How much a motion counts that is seen from the side.
constexpr double kMotionShare = 0.4;

struct SurfacePoint {
  Vector3 p_W;
  Vector3 n_W;
  double area;
};

/// Middles of triangles, about evenly over the surface.
std::vector<SurfacePoint> surfacePoints(const RigidBody& body) {
  const TriangleMesh& mesh = *body.mesh;
  const std::size_t stride = std::max<std::size_t>(1, mesh.triangles.size() / kSamples);
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += stride) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vector3 p = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
    const Vector3 cross = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    if (cross.norm() <= 0.0) continue;
    points.push_back({body.X_WB * p, body.X_WB.orientation * cross.normalized(), 0.5 * cross.norm()});
  }
  return points;
}

}  // namespace

const TriangleTree& StepView::treeOf(std::size_t body) {
  auto& tree = trees_[product_.bodies[body].mesh];
  if (!tree) tree = std::make_unique<const TriangleTree>(*product_.bodies[body].mesh);
  return *tree;
}

bool StepView::isHidden(const Vector3& p_W, const BodySet& present, const Vector3& toEye) {
  for (const std::size_t other : bodiesIn(present)) {
    const Pose X_BW = inverse(product_.bodies[other].X_WB);
    const TriangleTree& tree = treeOf(other);
    const double least = 1e-4 * tree.box().diagonal().norm();
    if (std::isfinite(tree.firstHit(X_BW * p_W, X_BW.orientation * toEye, least))) return true;
  }
  return false;
}

double StepView::seen(std::size_t body, const BodySet& present, const Vector3& toEye) {
  double visible = 0.0;
  double whole = 0.0;
  for (const SurfacePoint& point : surfacePoints(product_.bodies[body])) {
    const double facing = point.n_W.dot(toEye);
    if (facing <= 0.0) continue;
    whole += facing * point.area;
    if (!isHidden(point.p_W, present, toEye)) visible += facing * point.area;
  }
  return whole > 0.0 ? visible / whole : 0.0;
}

Vector3 StepView::directionToEye(const AssemblyStep& step, const BodySet& present) {
  const Vector3 motion = exitDirection(step.path);
  const std::size_t body = bodiesOf(step, product_).front();
  double best = -1.0;
  Vector3 chosen = kDirections.front().normalized();
  for (std::size_t i = 0; i < kDirections.size(); ++i) {
    const Vector3 toEye = kDirections[i].normalized();
    const double aside = motion.cross(toEye).norm();
    const double score =
        kPreference[i] * (1.0 - kMotionShare + kMotionShare * aside) * (0.05 + seen(body, present, toEye));
    if (score <= best) continue;
    best = score;
    chosen = toEye;
  }
  return chosen;
}

std::vector<Vector3> directionsToEye(const AssemblyPlan& plan, const AssembledProduct& product,
                                     const WorkWatch& watch) {
  StepView view(product);
  BodySet present(product.bodies.size(), true);
  std::vector<Vector3> directions;
  for (const AssemblyStep& step : plan.steps) {
    if (watch.stop.stopRequested()) return directions;
    directions.push_back(view.directionToEye(step, present));
    for (const std::size_t body : bodiesOf(step, product)) present[body] = false;
    watch.report(static_cast<double>(directions.size()) / static_cast<double>(plan.steps.size()));
  }
  return directions;
}

}  // namespace glissade
