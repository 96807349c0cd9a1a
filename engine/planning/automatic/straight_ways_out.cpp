#include "engine/planning/automatic/straight_ways_out.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "engine/collision/motion_certificate.h"
#include "engine/planning/automatic/contact_faces.h"

namespace glissade {
namespace {

constexpr std::size_t kSlideFaces = 6;

}  // namespace

std::vector<Vector3> likelyDirections(const Problem& problem) {
  std::vector<Vector3> directions;
  const auto add = [&](const Vector3& direction) {
    const auto same = [&](const Vector3& other) { return other.dot(direction) > 0.999; };
    if (std::none_of(directions.begin(), directions.end(), same)) directions.push_back(direction);
  };
  for (int axis = 0; axis < 3; ++axis) {
    add(Vector3::Unit(axis));
    add(-Vector3::Unit(axis));
  }
  for (const Vector3& normal_B : largestFaceNormals(problem.world->object(), kSlideFaces)) {
    add(problem.start.orientation * normal_B);
    add(-(problem.start.orientation * normal_B));
  }
  return directions;
}

double distanceOut(const Problem& problem, const Vector3& from, const Vector3& direction) {
  const Box3& box = problem.world->obstaclesBox();
  const double margin = problem.world->objectRadius() * (1.0 + 1e-9);
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < 1e-6) continue;
    const double face = direction[axis] > 0.0 ? box.max()[axis] + margin : box.min()[axis] - margin;
    least = std::min(least, (face - from[axis]) / direction[axis]);
  }
  return std::max(0.0, least);
}

std::vector<int> firstInTheWay(const Problem& problem, CollisionQuery& query, double required, const StopToken& stop) {
  if (problem.world->obstaclesBox().isEmpty()) return {};
  std::set<int> found;
  for (const Vector3& direction : likelyDirections(problem)) {
    Pose out = problem.start;
    out.position += distanceOut(problem, problem.start.position, direction) * direction;
    const MotionCertificate motion = certifyMotion(query, problem.start, out, required, stop);
    if (motion.status == CertificateStatus::Certified) return {};
    if (motion.status == CertificateStatus::Violated && motion.nearest.body >= 0) found.insert(motion.nearest.body);
  }
  return {found.begin(), found.end()};
}

}  // namespace glissade
