#include "engine/planning/coarse/passage_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/collision/motion_certificate.h"
#include "engine/geometry/least_rotation.h"
#include "engine/planning/coarse/passage_section.h"
#include "engine/planning/contact/interactive_contact_birrt.h"

namespace glissade {
namespace {

struct ProbeResult {
  bool passes = false;
  std::uint64_t randomConfigurations = 0;
};

constexpr std::uint64_t kMostConfigurations = 2000;

constexpr std::uint64_t kSeed = 1;

/// Lets a planner run for a given number of random configurations.
class ProbeHost final : public PlannerHost {
 public:
  ProbeHost(const Planner& planner, double objectRadius, const StopToken& stop)
      : planner_(planner), parameters_(objectRadius), stop_(stop) {}

  std::optional<OperatorSample> operatorSample() override { return std::nullopt; }
  const ParameterValues& parameters() const override { return parameters_; }
  bool afterStep() override {
    return planner_.counts().randomConfigurations < kMostConfigurations && !stop_.stopRequested();
  }
  const StopToken& stopToken() const override { return stop_; }

 private:
  const Planner& planner_;
  ParameterValues parameters_;
  StopToken stop_;
};

/// The cells of the passage and of its borders.
SamplingRegionPtr regionOf(const TopologicalMap& map, std::size_t place) {
  std::vector<std::size_t> cells = map.places[place].cells;
  for (const Border& border : map.borders) {
    if (border.placeA == static_cast<int>(place) || border.placeB == static_cast<int>(place)) {
      cells = unionOf(cells, border.cells);
    }
  }
  return std::make_shared<const SamplingRegion>(map.grid, std::move(cells));
}

/// A short bidirectional search through a passage, for objects that pass only by tilting: from before
/// it to behind it, the trial configuration turned as `inside` is. Always the same for the same
/// passage and object. A stop ends it: nothing passes then.
ProbeResult probePassage(const EnvironmentModel& environment, std::size_t place, const CollisionWorldPtr& world,
                         const Box3& bounds, const Pose& inside, const StopToken& stop) {
  const Place& passage = environment.map.places[place];
  const double radius = 1.02 * world->objectRadius();
  Problem problem;
  problem.world = world;
  problem.bounds = bounds;
  problem.region = regionOf(environment.map, place);
  problem.start = inside;
  problem.start.position[passage.axis] = passage.box.min()[passage.axis] - radius;
  Pose goal = inside;
  goal.position[passage.axis] = passage.box.max()[passage.axis] + radius;
  problem.goal = goal;
  const auto query = world->makeQuery();
  if (query->collides(problem.start) || query->collides(goal)) return {};
  InteractiveContactBirrt planner(problem, kSeed, OperatorUse::None);
  ProbeHost host(planner, world->objectRadius(), stop);
  const bool passes = planner.solve(host);
  return {passes, planner.counts().randomConfigurations};
}

constexpr std::size_t kMostDirections = 6;
constexpr int kAngles = 36;
constexpr int kLatticePoints = 64;
/// Fits that are looked at exactly, of all that the lattice shows.
constexpr std::size_t kRefined = 6;
/// A silhouette that is too large by less than this share of the passage's width may pass by tilting.
constexpr double kProbeRange = 0.05;
/// Margin, as a share of the passage's width, at which an object passes with ease.
constexpr double kEase = 0.2;
/// A silhouette that fits where no straight way through could be proved.
constexpr double kUnproved = 0.8 * PassageFit::kFits;

/// A way to hold the object before the passage: its direction looking along the passage, then turned.
struct Placement {
  double margin = -1e300;
  double angle = 0.0;
  Point2 centre = Point2::Zero();
  std::size_t direction = 0;
};

/// The opening into which a silhouette is fitted.
struct Opening {
  Eigen::AlignedBox2d box;  ///< where the object's reference point may be
  Point2 widest;            ///< where to begin
  double ease;              ///< margins above this are as good as this
};

/// The object seen along one of its directions.
struct Silhouette {
  Quaternion R_WB;
  std::vector<Point2> points;  ///< along the outline
  double arm;                  ///< distance of the farthest
};

/// The smallest signed distance of a silhouette's points when turned and shifted, at most the
/// opening's ease; any value up to `atLeast` as soon as it is known not to be above that.
template <class Section>
double marginAt(const Section& section, const Opening& opening, const Silhouette& silhouette, const Placement& at,
                double atLeast) {
  if (!opening.box.contains(at.centre)) return -1e300;
  const Eigen::Rotation2Dd turn(at.angle);
  double least = opening.ease;
  for (const Point2& point : silhouette.points) {
    least = std::min(least, section.signedDistance(turn * point + at.centre));
    if (least <= atLeast) break;
  }
  return least;
}

/// Compass search for the largest margin over position and angle, with steps from `first` to `last`.
template <class Section>
void improve(const Section& section, const Opening& opening, const Silhouette& silhouette, double first, double last,
             Placement& best) {
  for (double step = first; step > last && best.margin < opening.ease;) {
    bool better = false;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        Placement next = best;
        if (axis == 2) {
          next.angle += sign * step / silhouette.arm;
        } else {
          next.centre[axis] += sign * step;
        }
        next.margin = marginAt(section, opening, silhouette, next, best.margin);
        if (next.margin <= best.margin) continue;
        best = next;
        better = true;
      }
    }
    if (!better) step /= 2.0;
  }
}

/// The best placement of all silhouettes: every angle on the lattice, the most promising exactly.
Placement bestPlacement(const PassageSection& section, const Opening& opening,
                        const std::vector<Silhouette>& silhouettes, double width, const StopToken& stop) {
  double arm = 0.0;
  for (const Silhouette& silhouette : silhouettes) arm = std::max(arm, silhouette.arm);
  const Point2 around = Point2::Constant(arm);
  const SampledSection lattice(section, {opening.box.min() - around, opening.box.max() + around}, kLatticePoints);
  std::vector<Placement> found;
  for (std::size_t i = 0; i < silhouettes.size(); ++i) {
    for (int k = 0; k < kAngles && !stop.stopRequested(); ++k) {
      Placement start{0.0, 2.0 * std::numbers::pi * k / kAngles, opening.widest, i};
      start.margin = marginAt(lattice, opening, silhouettes[i], start, -1e300);
      improve(lattice, opening, silhouettes[i], width / 8.0, width / 200.0, start);
      found.push_back(start);
    }
  }
  // Among equally good placements the first one is taken, which has the largest face ahead.
  std::stable_sort(found.begin(), found.end(),
                   [](const Placement& a, const Placement& b) { return a.margin > b.margin; });
  Placement best;
  for (std::size_t i = 0; i < std::min(kRefined, found.size()); ++i) {
    if (found[i].margin < -2.0 * lattice.step()) break;
    Placement exact = found[i];
    exact.margin = marginAt(section, opening, silhouettes[exact.direction], exact, -1e300);
    improve(section, opening, silhouettes[exact.direction], width / 8.0, 1e-5 * width, exact);
    if (exact.margin > best.margin + 1e-6 * width) best = exact;
  }
  if (best.margin == -1e300 && !found.empty()) best = found.front();
  return best;
}

/// R_WB with the object's direction along the passage.
Quaternion facing(const Vector3& direction_B, int axis) { return leastRotation(direction_B, Vector3::Unit(axis)); }

/// Smallest distance of two parallel lines with the hull between them.
double leastWidth(const std::vector<Point2>& hull) {
  double least = 1e300;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point2 edge = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
    const Point2 inward(-edge.y(), edge.x());
    double most = 0.0;
    for (const Point2& corner : hull) most = std::max(most, inward.dot(corner - hull[i]));
    least = std::min(least, most);
  }
  return least;
}

/// The outlines of the object along its principal directions, without those that are wider in every
/// direction than the opening is across.
std::vector<Silhouette> silhouettesOf(const TriangleMesh& object, int axis, double across, double spacing) {
  std::vector<Silhouette> silhouettes;
  for (const Vector3& direction : principalDirections(object, kMostDirections)) {
    Silhouette silhouette{facing(direction, axis), {}, 1e-12};
    std::vector<Point2> corners;
    corners.reserve(object.vertices.size());
    for (const Vector3& v : object.vertices) corners.push_back(acrossAxis(axis, silhouette.R_WB * v));
    const std::vector<Point2> hull = convexHull(std::move(corners));
    if (leastWidth(hull) > across) continue;
    silhouette.points = pointsAlong(hull, spacing);
    for (const Point2& point : silhouette.points) silhouette.arm = std::max(silhouette.arm, point.norm());
    silhouettes.push_back(std::move(silhouette));
  }
  return silhouettes;
}

/// Least and largest coordinate of the turned object along the axis.
std::pair<double, double> extentAlong(const TriangleMesh& object, const Quaternion& R_WB, int axis) {
  double least = 1e300;
  double most = -1e300;
  for (const Vector3& v : object.vertices) {
    const double s = (R_WB * v)[axis];
    least = std::min(least, s);
    most = std::max(most, s);
  }
  return {least, most};
}

/// The straight way through the passage, long enough that the object can turn freely at its ends;
/// shorter, just clear of the passage, where something stands in the way.
std::optional<PassageFit::Crossing> straightThrough(const CollisionWorldPtr& world, const Box3& bounds, int axis,
                                                    const Box3& passage, const Pose& inside, double required,
                                                    const StopToken& stop) {
  const auto [back, front] = extentAlong(world->object(), inside.orientation, axis);
  const double radius = 1.02 * world->objectRadius();
  const auto query = world->makeQuery();
  const auto at = [&](double s) {
    Pose q = inside;
    q.position[axis] = s;
    return q;
  };
  struct Reach {
    double before;
    double behind;
  };
  for (const Reach& reach : {Reach{radius, radius}, Reach{1.02 * front, radius}, Reach{radius, -1.02 * back},
                             Reach{1.02 * front, -1.02 * back}}) {
    const PassageFit::Crossing crossing{at(passage.min()[axis] - reach.before), inside,
                                        at(passage.max()[axis] + reach.behind)};
    if (!bounds.contains(crossing.before.position) || !bounds.contains(crossing.behind.position)) continue;
    if (certifyPath(*query, {crossing.before, inside, crossing.behind}, required, stop).status ==
        CertificateStatus::Certified) {
      return crossing;
    }
  }
  return std::nullopt;
}

/// Each face of a convex body has all corners behind it.
bool isConvex(const TriangleMesh& object) {
  const double tolerance = 1e-6 * radiusAboutOrigin(object);
  for (const auto& [a, b, c] : object.triangles) {
    const Vector3 normal = (object.vertices[b] - object.vertices[a]).cross(object.vertices[c] - object.vertices[a]);
    if (normal.norm() < 1e-15) continue;
    const Vector3 unit = normal.normalized();
    for (const Vector3& v : object.vertices) {
      if (unit.dot(v - object.vertices[a]) > tolerance) return false;
    }
  }
  return true;
}

double scoreOf(double margin, double width) {
  return PassageFit::kFits + (1.0 - PassageFit::kFits) * std::min(1.0, margin / (kEase * width));
}

}  // namespace

std::vector<Vector3> principalDirections(const TriangleMesh& object, std::size_t most) {
  struct Cluster {
    Vector3 direction;
    double area;
  };
  constexpr double kSame = 0.985;  // within ten degrees
  std::vector<Cluster> clusters;
  for (const auto& [a, b, c] : object.triangles) {
    const Vector3 normal = (object.vertices[b] - object.vertices[a]).cross(object.vertices[c] - object.vertices[a]);
    const double area = normal.norm();
    if (area <= 0.0) continue;
    const Vector3 unit = normal / area;
    const auto like = std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& cluster) {
      return std::abs(cluster.direction.dot(unit)) > kSame;
    });
    if (like == clusters.end()) {
      clusters.push_back({unit, area});
    } else {
      like->area += area;
    }
  }
  std::stable_sort(clusters.begin(), clusters.end(),
                   [](const Cluster& a, const Cluster& b) { return a.area > b.area; });
  std::vector<Vector3> directions;
  for (std::size_t i = 0; i < std::min(most, clusters.size()); ++i) {
    directions.push_back(clusters[i].direction);
    directions.push_back(-clusters[i].direction);
  }
  return directions;
}

PassageFit fitThroughPassage(const EnvironmentModel& environment, std::size_t place, const CollisionWorldPtr& world,
                             const Box3& bounds, double requiredClearance, const StopToken& stop) {
  const Place& passage = environment.map.places[place];
  const int axis = passage.axis;
  const double low = passage.box.min()[axis];
  const double high = passage.box.max()[axis];
  const double width = passage.narrowness;
  Opening opening{{}, acrossAxis(axis, passage.anchor), kEase * width};
  opening.box.extend(acrossAxis(axis, passage.box.min()));
  opening.box.extend(acrossAxis(axis, passage.box.max()));
  PassageFit fit;
  fit.score = 0.0;
  const double across = opening.box.diagonal().norm();
  const auto silhouettes = silhouettesOf(world->object(), axis, across, width / 8.0);
  if (silhouettes.empty()) {
    fit.margin = -width / 2.0;
    return fit;
  }
  std::vector<double> positions;
  for (const double t : {0.1, 0.5, 0.9}) positions.push_back(low + t * (high - low));
  const PassageSection section(environment.statics_W, axis, positions, opening.widest,
                               across + 2.0 * world->objectRadius());
  const Placement best = bestPlacement(section, opening, silhouettes, width, stop);
  fit.margin = best.margin;
  const Quaternion turn(Eigen::AngleAxisd(best.angle, Vector3::Unit(axis)));
  const Pose inside{alongAxis(axis, (low + high) / 2.0, best.centre),
                    (turn * silhouettes[best.direction].R_WB).normalized()};
  if (best.margin > 0.0) {
    fit.crossing = straightThrough(world, bounds, axis, passage.box, inside, requiredClearance, stop);
    fit.score = fit.crossing ? scoreOf(best.margin, width) : kUnproved;
  } else if (best.margin > -kProbeRange * width && !isConvex(world->object())) {
    const ProbeResult probe = probePassage(environment, place, world, bounds, inside, stop);
    fit.probed = true;
    fit.randomConfigurations = probe.randomConfigurations;
    if (probe.passes) fit.score = PassageFit::kFits;
  }
  return fit;
}

double slimmestExtent(const TriangleMesh& object) {
  double slimmest = 1e300;
  for (const Vector3& direction : principalDirections(object, kMostDirections)) {
    double least = 1e300;
    double most = -1e300;
    for (const Vector3& v : object.vertices) {
      least = std::min(least, direction.dot(v));
      most = std::max(most, direction.dot(v));
    }
    slimmest = std::min(slimmest, most - least);
  }
  return slimmest;
}

PassageFit fitInRoom(const Place& room, double slimmestExtent) {
  PassageFit fit;
  fit.margin = (room.narrowness - slimmestExtent) / 2.0;
  if (fit.margin < 0.0) fit.score = 0.9 * PassageFit::kFits * room.narrowness / slimmestExtent;
  return fit;
}

}  // namespace glissade
