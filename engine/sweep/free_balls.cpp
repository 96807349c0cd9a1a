#include "engine/sweep/free_balls.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// The value where the edge from a corner outside the ball to one inside enters the ball.
double valueAtEntry(const ValuedTetrahedron& tetrahedron, std::size_t outer, std::size_t inner, const FreeBall& ball) {
  const Vector3 edge = tetrahedron.corners[inner] - tetrahedron.corners[outer];
  const Vector3 from = tetrahedron.corners[outer] - ball.middle;
  const double a = edge.squaredNorm();
  const double b = from.dot(edge);
  const double c = from.squaredNorm() - ball.radius * ball.radius;
  const double share = std::clamp((-b - std::sqrt(std::max(0.0, b * b - a * c))) / a, 0.0, 1.0);
  return tetrahedron.values[outer] + share * (tetrahedron.values[inner] - tetrahedron.values[outer]);
}

/// The largest value outside the ball, `limit` or more where it is more than the limit. What is above a level is
/// convex, with its corners on the edges of the tetrahedron. So the largest value is on an edge, too.
double largestOutside(const ValuedTetrahedron& tetrahedron, const FreeBall& ball, double limit) {
  std::array<bool, 4> within{};
  double largest = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    within[i] = (tetrahedron.corners[i] - ball.middle).squaredNorm() <= ball.radius * ball.radius;
    if (!within[i]) largest = std::max(largest, tetrahedron.values[i]);
  }
  if (largest >= limit) return largest;
  for (std::size_t inner = 0; inner < 4; ++inner) {
    for (std::size_t outer = 0; outer < 4; ++outer) {
      // Values grow towards the inside only where that corner's is the larger one, and matter where they are above.
      if (!within[inner] || within[outer] || tetrahedron.values[inner] <= largest) continue;
      largest = std::max(largest, valueAtEntry(tetrahedron, outer, inner, ball));
    }
  }
  return largest;
}

}  // namespace

double certifiedLevel(const ValuedTetrahedron& tetrahedron, const std::vector<FreeBall>& balls) {
  double level = std::max(0.0, *std::max_element(tetrahedron.values.begin(), tetrahedron.values.end()));
  for (const FreeBall& ball : balls) {
    if (level <= 0.0) break;
    level = std::min(level, largestOutside(tetrahedron, ball, level));
  }
  return level;
}

}  // namespace glissade
