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

/// What a hand has shown so far, in its order. Immutable once it is published.
struct ShownWay {
  struct Point {
    Pose q;
    NearestObstacle nearest;  ///< distance 0 where q collides, and could not be made free
    bool follows = false;     ///< the hand moved here from the point before
  };

  /// Of the parameters in force.
  struct ContactRule {
    int samples = 0;        ///< N
    double distance = 0.0;  ///< d, metres
    double gap = 0.0;       ///< metres
  };

  /// Where the hand pushes to: an axis or a screw. It goes on from share 1 of the motion to share `end`.
  struct Push {
    ScrewDisplacement motion;
    double end;
  };

  std::vector<Point> points;
  std::optional<Push> push;
  ContactRule contact;
  double spread = 0.0;        ///< deviation of the tube about the points, metres of the metric, for each direction
  double share = 0.0;         ///< of the members' draws, that are the hand's
  double slidersShare = 0.0;  ///< the same at least, of members whose trees go on in contact

  double shareOf(bool slides) const { return slides ? std::max(share, slidersShare) : share; }
};

/// The way as it is in force. Published between the rounds of a portfolio, read by its members within them: who reads
/// it does not change it, and whoever publishes waits for the readers.
class WayBoard {
 public:
  /// Null until something is shown.
  const std::shared_ptr<const ShownWay>& current() const { return current_; }
  void publish(std::shared_ptr<const ShownWay> way) { current_ = std::move(way); }

 private:
  std::shared_ptr<const ShownWay> current_;
};

/// Collects what a hand shows, and measures how far it is off what is free.
class WayRecorder {
 public:
  explicit WayRecorder(const Se3Metric& metric) : metric_(metric) {}

  /// `moved`: metres of the metric from what was shown to q.
  void add(const Pose& q, const NearestObstacle& nearest, double moved);
  std::size_t size() const { return points_.size(); }
  const std::vector<ShownWay::Point>& points() const { return points_; }
  /// Changes with every point.
  std::uint64_t version() const { return version_; }
  double spread() const;
  /// Share of the latest configurations that were in contact or nearly: a person who works there shows what is hard.
  double inContact() const { return inContact_; }
  /// Where the hand pushes to. `hand`: where it leads to, where obstacles stop the object before it.
  std::optional<ShownWay::Push> push(const std::optional<Pose>& hand) const;

 private:
  Se3Metric metric_;
  std::vector<ShownWay::Point> points_;
  std::uint64_t version_ = 0;
  double meanSquare_ = 0.0;  ///< of what the latest configurations were moved
  double inContact_ = 0.0;
  std::uint64_t added_ = 0;
};

}  // namespace glissade
