#include "engine/planning/automatic/straight_end.h"

#include "engine/planning/automatic/straight_ways_out.h"
#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

using Points = std::vector<PathPoint>;

class Straightener {
 public:
  Straightener(const Path& path, const Problem& problem, const ParameterValues& parameters, const StopToken& stop)
      : points_(path.points),
        problem_(problem),
        metric_(problem.metric()),
        parameters_(parameters),
        query_(problem.world->makeQuery()),
        likely_(likelyDirections(problem)),
        stop_(stop) {
    left_.assign(points_.size(), 0.0);
    for (std::size_t i = points_.size() - 1; i-- > 0;) {
      left_[i] = left_[i + 1] + metric_.distance(points_[i].q, points_[i + 1].q);
    }
  }

  Path result() {
    std::size_t first = 0;
    std::size_t last = points_.size() - 1;
    std::optional<PathPoint> end;
    while (first < last && !stop_.stopRequested()) {
      const std::size_t middle = (first + last) / 2;
      if (const auto out = straightOut(middle)) {
        end = out;
        last = middle;
      } else {
        first = middle + 1;
      }
    }
    Path path;
    if (!end) return path;
    points_.resize(last + 1);
    points_.push_back(*end);
    path.certificate = certifyPath(*query_, points_, parameters_, stop_);
    path.points = std::move(points_);
    return path;
  }

 private:
  /// The nearest place outside the product, straight on from point `index`.
  std::optional<PathPoint> straightOut(std::size_t index) {
    std::vector<Vector3> directions = likely_;
    const Vector3 along = points_[index + 1].q.position - points_[index].q.position;
    if (along.norm() > 0.0) directions.push_back(along.normalized());
    std::optional<PathPoint> nearest;
    double least = left_[index];
    for (const Vector3& direction : directions) {
      Pose q = points_[index].q;
      const double distance = distanceOut(problem_, q.position, direction);
      if (distance >= least) continue;
      q.position += distance * direction;
      const PathPoint out{q, Author::Computer, Author::Computer};
      if (!problem_.bounds.contains(q.position) || firstRefusedEdge(*query_, {points_[index], out}, parameters_, stop_))
        continue;
      nearest = out;
      least = distance;
    }
    return nearest;
  }

  Points points_;
  const Problem& problem_;
  Se3Metric metric_;
  const ParameterValues& parameters_;
  std::unique_ptr<CollisionQuery> query_;
  std::vector<Vector3> likely_;
  const StopToken& stop_;
  std::vector<double> left_;  ///< metric length from each point to the end
};

}  // namespace

Path withStraightEnd(const Path& path, const Problem& problem, const ParameterValues& parameters,
                     const StopToken& stop) {
  const bool isOut = std::holds_alternative<GoalOut>(problem.goal) && !problem.world->obstaclesBox().isEmpty();
  if (!isOut || path.points.size() < 3) return path;
  Path straight = Straightener(path, problem, parameters, stop).result();
  return straight.certificate.status == CertificateStatus::Certified && !straight.points.empty() ? straight : path;
}

}  // namespace glissade
