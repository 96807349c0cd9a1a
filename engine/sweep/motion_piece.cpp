#include "engine/sweep/motion_piece.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

MotionPiece pieceBetween(const Pose& from, const Pose& to) {
  return {from, to, angleBetween(from.orientation, to.orientation), (to.position - from.position).norm()};
}

}  // namespace

std::vector<MotionPiece> piecesOf(const std::vector<Pose>& path, double distance, double deviation, double longest) {
  if (path.size() == 1) return {pieceBetween(path.front(), path.front())};
  std::vector<MotionPiece> pieces;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const MotionPiece whole = pieceBetween(path[i - 1], path[i]);
    const double forDeviation = std::sqrt(whole.deviation(distance) / deviation);
    const double forLength = (whole.way + whole.rotation * distance) / longest;
    const int count = std::max(1, static_cast<int>(std::ceil(std::max(forDeviation, forLength))));
    Pose from = path[i - 1];
    for (int k = 1; k <= count; ++k) {
      const Pose to = interpolate(path[i - 1], path[i], static_cast<double>(k) / count);
      pieces.push_back(pieceBetween(from, to));
      from = to;
    }
  }
  return pieces;
}

}  // namespace glissade
