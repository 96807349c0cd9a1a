#include "engine/planning/coarse/passage_fit.h"

#include <algorithm>
#include <cmath>

#include "engine/collision/motion_certificate.h"
#include "engine/planning/coarse/passage_probe.h"
#include "engine/planning/coarse/passage_section.h"

namespace glissade {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kMostDirections = 6;
constexpr int kAngles = 36;
/// A silhouette that is too large by less than this share of the passage's width may pass by tilting.
constexpr double kProbeRange = 0.05;
/// Margin, as a share of the passage's width, at which an object passes with ease.
constexpr double kEase = 0.2;

/// A way to hold the object before the passage: its direction looking along the passage, then turned.
struct Placement {
  double margin = -1e300;
  double angle = 0.0;
  Point2 centre = Point2::Zero();
};

/// What a silhouette is fitted into.
struct Opening {
  const PassageSection& section;
  Eigen::AlignedBox2d box;  ///< where the object's reference point may be
  double ease;              ///< margins above this are as good as this
};

/// The smallest signed distance of a silhouette's corners when turned and shifted, at most the
/// opening's ease; any value up to `atLeast` as soon as it is known not to be above that.
double marginAt(const Opening& opening, const std::vector<Point2>& silhouette, double angle, const Point2& centre,
                double atLeast) {
  if (!opening.box.contains(centre)) return -1e300;
  const Eigen::Rotation2Dd turn(angle);
  double least = opening.ease;
  for (const Point2& corner : silhouette) {
    least = std::min(least, opening.section.signedDistance(turn * corner + centre));
    if (least <= atLeast) break;
  }
  return least;
}

/// Compass search for the largest margin, over the position and, where `turning`, the angle.
void improve(const Opening& opening, const std::vector<Point2>& silhouette, double reach, bool turning,
             Placement& best) {
  const double arm = std::max(1e-12, std::sqrt(std::max_element(silhouette.begin(), silhouette.end(),
                                                                [](const Point2& a, const Point2& b) {
                                                                  return a.squaredNorm() < b.squaredNorm();
                                                                })
                                                   ->squaredNorm()));
  const double finest = reach * (turning ? 1e-5 : 1e-2);
  for (double step = reach / 4.0; step > finest && best.margin < opening.ease;) {
    bool better = false;
    for (int axis = 0; axis < (turning ? 3 : 2); ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        Placement next = best;
        if (axis == 2) {
          next.angle += sign * step / arm;
        } else {
          next.centre[axis] += sign * step;
        }
        next.margin = marginAt(opening, silhouette, next.angle, next.centre, best.margin);
        if (next.margin <= best.margin) continue;
        best = next;
        better = true;
      }
    }
    if (!better) step /= 2.0;
  }
}

Placement bestPlacement(const Opening& opening, const std::vector<Point2>& silhouette, const Point2& about,
                        double reach) {
  constexpr std::size_t kRefined = 4;
  std::vector<Placement> starts;
  for (int i = 0; i < kAngles; ++i) {
    Placement start{0.0, 2.0 * kPi * i / kAngles, about};
    start.margin = marginAt(opening, silhouette, start.angle, start.centre, -1e300);
    improve(opening, silhouette, reach, false, start);
    starts.push_back(start);
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Placement& a, const Placement& b) { return a.margin > b.margin; });
  Placement best;
  for (std::size_t i = 0; i < kRefined; ++i) {
    improve(opening, silhouette, reach, true, starts[i]);
    if (starts[i].margin > best.margin) best = starts[i];
  }
  return best;
}

/// R_WB with the object's direction along the passage.
Quaternion facing(const Vector3& direction_B, int axis) {
  return Quaternion::FromTwoVectors(direction_B, Vector3::Unit(axis));
}

std::vector<Point2> silhouetteOf(const TriangleMesh& object, const Quaternion& R_WB, int axis) {
  std::vector<Point2> points;
  points.reserve(object.vertices.size());
  for (const Vector3& v : object.vertices) points.push_back(acrossAxis(axis, R_WB * v));
  return convexHull(std::move(points));
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
                                                    const Box3& passage, const Pose& inside, double required) {
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
    if (certifyPath(*query, world->object(), {crossing.before, inside, crossing.behind}, required).status ==
        CertificateStatus::Certified) {
      return crossing;
    }
  }
  return std::nullopt;
}

bool convexOutline(const TriangleMesh& object) {
  // A convex body has no corner off its hull's planes: each face has all corners behind it.
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
  return margin > 0.0 ? PassageFit::kFits + (1.0 - PassageFit::kFits) * std::min(1.0, margin / (kEase * width)) : 0.0;
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
  std::stable_sort(clusters.begin(), clusters.end(), [](const Cluster& a, const Cluster& b) { return a.area > b.area; });
  std::vector<Vector3> directions;
  for (std::size_t i = 0; i < std::min(most, clusters.size()); ++i) {
    directions.push_back(clusters[i].direction);
    directions.push_back(-clusters[i].direction);
  }
  return directions;
}

PassageFit fitThroughPassage(const EnvironmentModel& environment, std::size_t place, const CollisionWorldPtr& world,
                             const Box3& bounds, double requiredClearance) {
  const Place& passage = environment.map.places[place];
  const int axis = passage.axis;
  const double low = passage.box.min()[axis];
  const double high = passage.box.max()[axis];
  std::vector<double> positions;
  for (const double t : {0.1, 0.5, 0.9}) positions.push_back(low + t * (high - low));
  const Point2 about = acrossAxis(axis, passage.anchor);
  const double width = passage.narrowness;
  const double reach = width + 2.0 * world->objectRadius();
  const PassageSection section(environment.statics_W, axis, positions, about, reach);
  Opening opening{section, {}, kEase * width};
  opening.box.extend(acrossAxis(axis, passage.box.min()));
  opening.box.extend(acrossAxis(axis, passage.box.max()));

  PassageFit fit;
  Placement best;
  Quaternion orientation = Quaternion::Identity();
  const TriangleMesh& object = world->object();
  for (const Vector3& direction : principalDirections(object, kMostDirections)) {
    const Quaternion R_WB = facing(direction, axis);
    const Placement placement = bestPlacement(opening, silhouetteOf(object, R_WB, axis), about, width / 2.0);
    // Of equally good ways the first: the largest face ahead.
    if (placement.margin <= best.margin + 1e-6 * width) continue;
    best = placement;
    orientation = (Quaternion(Eigen::AngleAxisd(placement.angle, Vector3::Unit(axis))) * R_WB).normalized();
  }
  fit.margin = best.margin;
  fit.score = scoreOf(best.margin, width);
  const Pose inside{alongAxis(axis, (low + high) / 2.0, best.centre), orientation};
  if (best.margin > 0.0) {
    fit.crossing = straightThrough(world, bounds, axis, passage.box, inside, requiredClearance);
  } else if (best.margin > -kProbeRange * width && !convexOutline(object)) {
    const ProbeResult probe = probePassage(environment, place, world, bounds, inside);
    fit.probed = true;
    fit.randomConfigurations = probe.randomConfigurations;
    if (probe.passes) fit.score = PassageFit::kFits;
  }
  return fit;
}

PassageFit fitInRoom(const EnvironmentModel& environment, std::size_t place, const TriangleMesh& object) {
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
  PassageFit fit;
  fit.margin = (environment.map.places[place].narrowness - slimmest) / 2.0;
  if (fit.margin < 0.0) fit.score = 0.9 * PassageFit::kFits * environment.map.places[place].narrowness / slimmest;
  return fit;
}

}  // namespace glissade
