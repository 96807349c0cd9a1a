#include "engine/sequence/step_view.h"

#include <cmath>
#include <limits>

#include "engine/geometry/least_rotation.h"
#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// Direction to the first corner: front, left, above.
const Vector3 kFirstCorner(-1.0, -1.2, 0.9);
/// Factors of the scores of other viewpoints, by the effort of turning the product, and of lying upside down.
constexpr double kQuarterTurn = 0.9;
constexpr double kHalfTurn = 0.85;
constexpr double kTurnOver = 0.8;
/// The viewpoint is kept if its score is at least this share of the best one. A product that is turned over goes back
/// on its base sooner.
constexpr double kGoodEnough = 0.6;
constexpr double kGoodEnoughTurnedOver = 0.9;
/// Number of surface points that are tested for visibility.
constexpr std::size_t kSamples = 160;
/// Weight of a motion that is seen from the side.
constexpr double kMotionShare = 0.4;
/// Factor of a viewpoint in which the part would have to be brought from below.
constexpr double kFromBelow = 0.5;
constexpr double kSteep = 0.7;  // sine of the slope of such a motion

/// Another direction is chosen if the visible share of a part is below kWellSeen and grows by the factor kClearlyMore.
constexpr double kWellSeen = 0.3;
constexpr double kClearlyMore = 1.5;
constexpr double kLeastSeen = 0.02;

struct SurfacePoint {
  Vector3 p_W;
  Vector3 n_W;
  double area;
};

/// Centres of triangles, spread roughly evenly over the surface.
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

Vector3 Viewpoint::toEye() const {
  const double angle = 0.5 * std::acos(-1.0) * quarter;
  const Vector3 corner = Eigen::AngleAxisd(angle, Vector3::UnitZ()) * kFirstCorner.normalized();
  const Vector3 eye = leastRotation(Vector3::UnitZ(), workUp) * corner;
  return turnedOver ? Vector3(-eye) : eye;
}

Vector3 Viewpoint::up() const { return turnedOver ? Vector3(-workUp) : workUp; }

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

std::optional<Vector3> StepView::betterEye(const AssemblyStep& step, const BodySet& present, const Vector3& toEye) {
  const std::size_t body = bodiesOf(step, product_).front();
  const double seen = shareSeen(body, present, toEye);
  if (seen >= kWellSeen) return std::nullopt;
  std::optional<Vector3> better;
  double best = kClearlyMore * std::max(seen, kLeastSeen);
  for (const bool over : {false, true}) {
    for (const int quarter : {0, 1, 3, 2}) {
      const Vector3 other = Viewpoint{quarter, over}.toEye();
      const double value = shareSeen(body, present, other);
      if (value <= best) continue;
      best = value;
      better = other;
    }
  }
  return better;
}

double StepView::shareSeen(std::size_t body, const BodySet& present, const Vector3& toEye) {
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

/// Mean score of the motions of the steps: the visible share of their bodies, and their motion as seen from the side.
double StepView::score(const std::vector<AssemblyStep>& steps, const BodySet& present, const Viewpoint& from) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const AssemblyStep& step : steps) {
    for (const StepMotion& motion : step.motions) {
      const Vector3 exit = exitDirection(motion.path);
      const double aside = exit.cross(from.toEye()).norm();
      const double handling = exit.dot(from.up()) < -kSteep ? kFromBelow : 1.0;
      const double seen = shareSeen(product_.indexOf(motion.body), present, from.toEye());
      sum += handling * (1.0 - kMotionShare + kMotionShare * aside) * (0.05 + seen);
    }
    count += step.motions.size();
  }
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

Viewpoint StepView::choose(const std::vector<AssemblyStep>& steps, const BodySet& present, const Viewpoint& before) {
  const double kept = (before.turnedOver ? kTurnOver : 1.0) * score(steps, present, before);
  Viewpoint chosen = before;
  double best = kept;
  for (const int quarters : {0, 1, 3, 2}) {
    for (const bool over : {false, true}) {
      const Viewpoint other{(before.quarter + quarters) % 4, before.turnedOver != over, before.workUp};
      if (other == before) continue;
      const double turning = quarters == 0 ? 1.0 : quarters == 2 ? kHalfTurn : kQuarterTurn;
      const double value = turning * (other.turnedOver ? kTurnOver : 1.0) * score(steps, present, other);
      if (value <= best) continue;
      best = value;
      chosen = other;
    }
  }
  return kept >= (before.turnedOver ? kGoodEnoughTurnedOver : kGoodEnough) * best ? before : chosen;
}

}  // namespace glissade
