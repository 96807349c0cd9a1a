#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/base/random_stream.h"
#include "engine/collision/collision_query.h"
#include "engine/geometry/screw_displacement.h"
#include "engine/geometry/se3_metric.h"

namespace glissade {

/// The configurations that a hand has shown so far, in order. Immutable once it is published.
struct ShownWay {
  struct Point {
    Pose q;
    NearestObstacle nearest;  ///< nearest obstacle; distance 0 where q collides and could not be made free
    bool follows = false;     ///< the hand moved here from the point before
  };

  /// Rule of contact sampling from the parameters in force.
  struct ContactRule {
    int samples = 0;        ///< N
    double distance = 0.0;  ///< d, metres
    double gap = 0.0;       ///< metres
  };

  /// Motion in the direction in which the hand pushes: a translation or a screw. It goes on from share 1 of the motion
  /// to share `end`.
  struct Push {
    ScrewDisplacement motion;
    double end;
  };

  std::vector<Point> points;
  std::optional<Push> push;
  ContactRule contact;
  double spread = 0.0;        ///< deviation of the tube about the points, metres of the metric, for each direction
  double share = 0.0;         ///< share of the members' draws that follow the hand
  double slidersShare = 0.0;  ///< least such share of members whose trees go on in contact

  double shareOf(bool slides) const { return slides ? std::max(share, slidersShare) : share; }
};

/// The current way. It is published between the rounds of a portfolio and read by its members during the rounds. A
/// reader does not change it, and a publisher waits for the readers.
class WayBoard {
 public:
  /// The way; null until something is shown.
  const std::shared_ptr<const ShownWay>& current() const { return current_; }
  void publish(std::shared_ptr<const ShownWay> way) { current_ = std::move(way); }

 private:
  std::shared_ptr<const ShownWay> current_;
};

/// Collects the configurations that a hand shows, and measures their distance from free configurations.
class WayRecorder {
 public:
  explicit WayRecorder(const Se3Metric& metric) : metric_(metric) {}

  /// `moved`: distance from the shown configuration to q, metres in the metric.
  void add(const Pose& q, const NearestObstacle& nearest, double moved);
  std::size_t size() const { return points_.size(); }
  const std::vector<ShownWay::Point>& points() const { return points_; }
  /// Number that changes with every point.
  std::uint64_t version() const { return version_; }
  double spread() const;
  /// Share of the latest configurations that were in contact or nearly. Contact shows that the place is difficult.
  double inContact() const { return inContact_; }
  /// The motion in the direction in which the hand pushes. `hand`: pose that the hand leads to, where obstacles stop
  /// the object before it.
  std::optional<ShownWay::Push> push(const std::optional<Pose>& hand) const;

 private:
  Se3Metric metric_;
  std::vector<ShownWay::Point> points_;
  std::uint64_t version_ = 0;
  double meanSquare_ = 0.0;  ///< mean square distance by which the latest configurations were moved
  double inContact_ = 0.0;
  std::uint64_t added_ = 0;
};

}  // namespace glissade
