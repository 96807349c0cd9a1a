#include "engine/planning/smoothing/shortcuts.h"

#include <algorithm>

#include "engine/base/random_stream.h"
#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

/// Least gain of a change, as a share of the length of the whole path.
constexpr double kWorthwhile = 1e-6;

/// Degree of freedom that a shortcut makes straight.
enum class Freedom { All, X, Y, Z, Turn };

using Points = std::vector<PathPoint>;

class Shortener {
 public:
  Shortener(const Path& path, const Problem& problem, const ParameterValues& parameters, std::uint64_t seed,
            const StopToken& stop)
      : points_(path.points),
        metric_(problem.metric()),
        parameters_(parameters),
        query_(problem.world->makeQuery()),
        stream_(seed, "shortcuts"),
        stop_(stop) {}

  void tryShortcut() {
    measure();
    const double total = arrival_.back();
    double begin = stream_.uniform() * total;
    double end = stream_.uniform() * total;
    if (begin > end) std::swap(begin, end);
    const bool straight = stream_.uniform() < 0.5;
    const auto single = static_cast<Freedom>(1 + std::min(3, static_cast<int>(4.0 * stream_.uniform())));
    const std::size_t first = edgeAt(begin);
    const std::size_t last = edgeAt(end);
    if (first == last) return;

    Points old{pointAt(first, begin)};
    old.insert(old.end(), points_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
               points_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    old.push_back(pointAt(last, end));
    const Points fresh = shortened(old, straight ? Freedom::All : single);
    if (lengthOf(fresh) < lengthOf(old) - kWorthwhile * total && isCertified(fresh)) replace(first, last, fresh);
  }

  /// Removes each configuration whose neighbours can be joined directly.
  void leaveOut() {
    for (std::size_t i = 1; i + 1 < points_.size() && !stop_.stopRequested();) {
      Points past{points_[i - 1], points_[i + 1]};
      if (points_[i].segmentAuthor != past.back().segmentAuthor) past.back().segmentAuthor = Author::Computer;
      if (isCertified(past)) {
        points_[i + 1] = past.back();
        points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
  }

  Path result() {
    Path path;
    path.certificate = certifyPath(*query_, points_, parameters_, stop_);
    path.points = std::move(points_);
    return path;
  }

 private:
  void measure() {
    arrival_.assign(1, 0.0);
    for (std::size_t i = 1; i < points_.size(); ++i) {
      arrival_.push_back(arrival_.back() + metric_.distance(points_[i - 1].q, points_[i].q));
    }
  }

  /// Index of the edge at metric length s from the start.
  std::size_t edgeAt(double s) const {
    const auto after = std::upper_bound(arrival_.begin() + 1, arrival_.end() - 1, s);
    return static_cast<std::size_t>(after - arrival_.begin()) - 1;
  }

  PathPoint pointAt(std::size_t edge, double s) const {
    const PathPoint& from = points_[edge];
    const PathPoint& to = points_[edge + 1];
    const double length = arrival_[edge + 1] - arrival_[edge];
    const double t = length > 0.0 ? (s - arrival_[edge]) / length : 0.0;
    const bool sliding = from.author == Author::Contact || to.author == Author::Contact;
    return {interpolate(from.q, to.q, t), sliding ? Author::Contact : to.segmentAuthor, to.segmentAuthor};
  }

  Points shortened(const Points& old, Freedom freedom) const {
    Points fresh{old.front()};
    if (freedom != Freedom::All) {
      const double length = lengthOf(old);
      double s = 0.0;
      for (std::size_t i = 1; i + 1 < old.size(); ++i) {
        s += metric_.distance(old[i - 1].q, old[i].q);
        const Pose straight = interpolate(old.front().q, old.back().q, length > 0.0 ? s / length : 0.0);
        Pose q = old[i].q;
        if (freedom == Freedom::Turn) {
          q.orientation = straight.orientation;
        } else {
          const int axis = static_cast<int>(freedom) - static_cast<int>(Freedom::X);
          q.position[axis] = straight.position[axis];
        }
        fresh.push_back({q, Author::Computer, Author::Computer});
      }
    }
    fresh.push_back(old.back());
    fresh.back().segmentAuthor = Author::Computer;
    return fresh;
  }

  double lengthOf(const Points& points) const {
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += metric_.distance(points[i - 1].q, points[i].q);
    return sum;
  }

  bool isCertified(const Points& points) { return !firstRefusedEdge(*query_, points, parameters_, stop_); }

  /// Replaces the part between a place on edge `first` and a place on edge `last` by `fresh`.
  void replace(std::size_t first, std::size_t last, const Points& fresh) {
    const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(first) + 1;
    const auto end = points_.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    points_.insert(points_.erase(begin, end), fresh.begin(), fresh.end());
  }

  Points points_;
  Se3Metric metric_;
  const ParameterValues& parameters_;
  std::unique_ptr<CollisionQuery> query_;
  RandomStream stream_;
  const StopToken& stop_;
  std::vector<double> arrival_;  ///< metric length from the start to each point
};

}  // namespace

Path withShortcuts(const Path& path, const Problem& problem, const ParameterValues& parameters, std::uint64_t seed,
                   int attempts, const WorkWatch& watch) {
  if (path.points.size() < 3) return path;
  Shortener shortener(path, problem, parameters, seed, watch.stop);
  for (int i = 0; i < attempts && !watch.stop.stopRequested(); ++i) {
    watch.report(static_cast<double>(i) / attempts);
    shortener.tryShortcut();
  }
  shortener.leaveOut();
  Path shorter = shortener.result();
  return shorter.certificate.status == CertificateStatus::Certified ? shorter : path;
}

Path withShortcutsOfComputer(const Path& path, const Problem& problem, const ParameterValues& parameters,
                             std::uint64_t seed, int attempts, const StopToken& stop) {
  const auto endsComputersEdge = [](const PathPoint& point) { return point.segmentAuthor == Author::Computer; };
  const auto edges = std::count_if(path.points.begin() + 1, path.points.end(), endsComputersEdge);
  Path shorter;
  for (auto from = path.points.begin(); from != path.points.end();) {
    const auto end = std::find_if_not(from + 1, path.points.end(), endsComputersEdge);
    Points stretch(from, end);
    if (stretch.size() > 2) {
      const auto share = static_cast<int>(attempts * (end - from - 1) / edges);
      stretch = withShortcuts({std::move(stretch), {}}, problem, parameters, seed, share, stop).points;
    }
    shorter.points.insert(shorter.points.end(), stretch.begin(), stretch.end());
    from = end;
  }
  shorter.certificate = certifyPath(*problem.world->makeQuery(), shorter.points, parameters, stop);
  return shorter.certificate.status == CertificateStatus::Certified ? shorter : path;
}

}  // namespace glissade
