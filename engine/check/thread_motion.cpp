#include "engine/check/thread_motion.h"

#include <algorithm>
#include <cmath>

namespace glissade::check {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kTernarySteps = 100;
constexpr int kMostHalvedParts = 20'000;
/// Tolerance of the distance of a thread's vertex from the axis: a share of the radius, or metres.
constexpr double kShareOfRadius = 1e-3;
constexpr double kMetres = 5e-6;
/// Vertices of a hole belong to its thread within this multiple of the shaft's radius, those of a shaft within its
/// radius.
constexpr double kWidest = 1.25;

/// The lowest and the highest point on the axis beside which the mesh has vertices of its thread.
std::pair<Vector3, Vector3> threadEnds(const TriangleMesh& mesh, const Pose& X_WM, const Thread& rule, bool shaft) {
  const Eigen::ParametrizedLine<double, 3> line(rule.point, rule.axis);
  const auto [narrow, wide] = std::minmax(rule.radiusMoving, rule.radiusOther);
  const double off = std::max(kMetres, kShareOfRadius * wide);
  double low = 0.0;
  double high = 0.0;
  bool any = false;
  for (const Vector3& vertex : mesh.vertices) {
    const Vector3 p = X_WM.orientation.toRotationMatrix() * vertex + X_WM.position;
    const double distance = line.distance(p);
    if (shaft ? distance > wide + off : distance < narrow - off || distance > kWidest * wide) continue;
    const double along = (p - rule.point).dot(rule.axis);
    low = any ? std::min(low, along) : along;
    high = any ? std::max(high, along) : along;
    any = true;
  }
  return {rule.point + low * rule.axis, rule.point + high * rule.axis};
}

/// Signed angle about the axis of the rotation between the configurations, radians; the rest of the rotation is in
/// `tilt`.
double turnOf(const Pose& from, const Pose& to, const Vector3& axis, double& tilt) {
  const Eigen::AngleAxisd rotation(to.orientation.toRotationMatrix() * from.orientation.toRotationMatrix().transpose());
  const Vector3 vector = rotation.angle() * rotation.axis();
  const double turn = vector.dot(axis);
  tilt = (vector - turn * axis).norm();
  return turn;
}

}  // namespace

ThreadMotion::ThreadMotion(const std::vector<MotionCheck::Threaded>& threads, const TriangleMesh& object) {
  double reach = 0.0;
  for (const Vector3& vertex : object.vertices) reach = std::max(reach, vertex.norm());
  for (const MotionCheck::Threaded& each : threads) {
    const Thread& rule = each.thread;
    const auto own = threadEnds(object, rule.assembled, rule, rule.movingIsShaft);
    const auto other = threadEnds(*each.mesh, each.X_WB, rule, !rule.movingIsShaft);
    const Pose X_BW = inverse(rule.assembled);
    threads_.push_back({rule, X_BW * own.first, X_BW * own.second, other.first, other.second, reach});
  }
}

/// Lower bound on the distance of the shaft's axis from the bore, above 0 if they are apart. The larger of two convex
/// functions of the place on the shaft's axis has one minimum.
double ThreadMotion::separation(const Extent& thread, const Pose& X_WB) {
  const bool moves = thread.thread.movingIsShaft;
  const Vector3 low = X_WB * thread.low_B;
  const Vector3 high = X_WB * thread.high_B;
  const Vector3& shaftLow = moves ? low : thread.low_W;
  const Vector3& shaftHigh = moves ? high : thread.high_W;
  const Vector3& boreLow = moves ? thread.low_W : low;
  const Vector3& boreHigh = moves ? thread.high_W : high;
  const double radius = moves ? thread.thread.radiusOther : thread.thread.radiusMoving;
  const Vector3 middle = 0.5 * (boreLow + boreHigh);
  const double length = (boreHigh - boreLow).norm();
  const Vector3 axis = length > 0.0 ? Vector3((boreHigh - boreLow) / length) : thread.thread.axis;
  const auto outside = [&](double t) {
    const Vector3 p = shaftLow + t * (shaftHigh - shaftLow) - middle;
    const double along = p.dot(axis);
    return std::max(std::abs(along) - 0.5 * length, (p - along * axis).norm() - radius);
  };
  double begin = 0.0;
  double end = 1.0;
  for (int i = 0; i < kTernarySteps && end - begin > 1e-15; ++i) {
    const double third = (end - begin) / 3.0;
    if (outside(begin + third) <= outside(end - third)) {
      end -= third;
    } else {
      begin += third;
    }
  }
  return std::min({outside(0.0), outside(1.0), outside(0.5 * (begin + end))});
}

/// True if they stay apart: a point of the object moves by no more than its frame's displacement plus the turn of its
/// arm.
bool ThreadMotion::staysApart(const Extent& thread, const Pose& from, const Pose& to) {
  const double way =
      (to.position - from.position).norm() + thread.reach * angleBetween(from.orientation, to.orientation);
  std::vector<std::pair<double, double>> open{{0.0, 1.0}};
  for (int parts = 0; !open.empty(); ++parts) {
    const auto [begin, end] = open.back();
    open.pop_back();
    const double middle = 0.5 * (begin + end);
    const double play = kThreadPlay * std::abs(thread.thread.pitch);
    const double apart = separation(thread, interpolate(from, to, middle)) - play;
    if (apart > 0.5 * (end - begin) * way * (1.0 + 1e-9)) continue;
    if (apart <= 0.0 || parts > kMostHalvedParts) return false;
    open.emplace_back(begin, middle);
    open.emplace_back(middle, end);
  }
  return true;
}

/// True if the thread's ends are where a turn about the axis from the first engaged configuration puts them.
bool ThreadMotion::isTurn(const Extent& thread, const Pose& from, const Pose& to, Followed& followed) {
  const Thread& rule = thread.thread;
  const double play = kThreadPlay * std::abs(rule.pitch);
  const Eigen::ParametrizedLine<double, 3> axis(rule.point, rule.axis);
  if (!followed.engaged) followed = {true, from, 0.0};
  const bool onAxis =
      axis.distance(followed.first * thread.low_B) <= play && axis.distance(followed.first * thread.high_B) <= play;
  double tilt = 0.0;
  const double turn = turnOf(from, to, rule.axis, tilt);
  const double sagitta = axis.distance(from.position) * (1.0 - std::cos(0.5 * turn));
  if (!onAxis || sagitta > play || std::abs(turn) > kPi - 1e-6) return false;
  if (!rule.mayTurn) return std::abs(turn) + tilt <= 1e-9 && (to.position - from.position).norm() <= 1e-9;
  followed.turn += turn;
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(followed.turn, rule.axis).toRotationMatrix();
  const Vector3 advance = followed.turn / (2.0 * kPi) * rule.pitch * rule.axis;
  for (const Vector3& end_B : {thread.low_B, thread.high_B}) {
    const Vector3 expected = rule.point + rotation * (followed.first * end_B - rule.point) + advance;
    if ((to * end_B - expected).norm() + rule.radiusMoving * tilt > play) return false;
  }
  return true;
}

std::vector<ThreadMotion::Edge> ThreadMotion::judge(const std::vector<Pose>& path, const StopToken& stop) const {
  std::vector<Edge> edges;
  std::vector<Followed> followed(threads_.size());
  const std::size_t count = std::max<std::size_t>(1, path.size() - 1);
  for (std::size_t i = 0; i < count && !stop.stopRequested(); ++i) {
    const Pose& to = path[std::min(i + 1, path.size() - 1)];
    Edge edge;
    for (std::size_t k = 0; k < threads_.size(); ++k) {
      if (staysApart(threads_[k], path[i], to)) {
        followed[k].engaged = false;
        continue;
      }
      edge.engaged = true;
      edge.thread = &threads_[k].thread;
      if (!isTurn(threads_[k], path[i], to, followed[k])) edge.forbiddenBy = static_cast<int>(threads_[k].thread.other);
    }
    edges.push_back(edge);
    if (edge.forbiddenBy >= 0) break;
  }
  return edges;
}

}  // namespace glissade::check
