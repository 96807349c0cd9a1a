#include "engine/planning/path.h"

#include <algorithm>

namespace glissade {

bool isSteered(const std::vector<PathPoint>& points) {
  return std::any_of(points.begin(), points.end(), [](const PathPoint& point) {
    return point.author != Author::Computer || point.segmentAuthor != Author::Computer;
  });
}

std::vector<Pose> configurationsOf(const std::vector<PathPoint>& points) {
  std::vector<Pose> configurations;
  configurations.reserve(points.size());
  for (const PathPoint& point : points) configurations.push_back(point.q);
  return configurations;
}

std::vector<Pose> Path::configurations() const { return configurationsOf(points); }

double Path::length() const {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i].q.position - points[i - 1].q.position).norm();
  return sum;
}

double Path::rotation() const {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += angleBetween(points[i - 1].q.orientation, points[i].q.orientation);
  }
  return sum;
}

PerAuthor<double> Path::lengthByAuthor(const Se3Metric& metric) const {
  PerAuthor<double> sums{};
  for (std::size_t i = 1; i < points.size(); ++i) {
    sums[static_cast<std::size_t>(points[i].segmentAuthor)] += metric.distance(points[i - 1].q, points[i].q);
  }
  return sums;
}

}  // namespace glissade
