#include "engine/sequence/work_position.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "engine/planning/coarse/passage_section.h"
#include "engine/sequence/solid_mass.h"

namespace glissade {
namespace {

/// A body stands on the ground if its lowest point is above it by less than this share of the product's height.
constexpr double kGround = 0.02;
/// How much more a body counts that stands on the ground.
constexpr double kStands = 1.5;
/// Height of the points on which a body rests, as a share of its size.
constexpr double kRests = 1e-3;
/// Least thickness of a box, metres.
constexpr double kThinnest = 1e-9;
/// Least factor of a position in which the body rests on little or nothing.
constexpr double kLeastLie = 0.35;
/// Factor of a neighbour that is a fastener: a part with many screws is no base for that.
constexpr double kFastenerTouch = 0.3;
/// Factors of directions: a product is turned only where it lies clearly better than in the file.
constexpr double kFileUp = 1.0;
constexpr double kOtherUsualUp = 0.9;
constexpr double kAxis = 0.75;
constexpr double kSlanted = 0.6;
/// Planes whose normals differ by less are one (cosine).
constexpr double kSamePlane = 0.9999;
/// Number of planes of a body that are told apart.
constexpr std::size_t kMostPlanes = 64;
/// Number of bodies whose slanted planes are asked, the largest first.
constexpr std::size_t kMostSlanted = 8;

/// A direction that may be up, with the factor of its positions.
struct UpDirection {
  Vector3 up;
  double factor;
};

std::vector<UpDirection> axes() {
  return {{Vector3::UnitZ(), kFileUp}, {Vector3::UnitY(), kOtherUsualUp}, {-Vector3::UnitZ(), kAxis},
          {-Vector3::UnitY(), kAxis},  {Vector3::UnitX(), kAxis},         {-Vector3::UnitX(), kAxis}};
}

/// A body where it is assembled.
struct PlacedBody {
  TriangleMesh mesh_W;
  SolidMass mass;
  Box3 box;
  double boxVolume = 0.0;    ///< of the box in the body's own frame
  double largestFace = 0.0;  ///< area of the largest face of that box
};

/// Height of the lowest point against gravity, metres.
double lowestOf(const TriangleMesh& mesh, const Vector3& up) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vector3& vertex : mesh.vertices) lowest = std::min(lowest, up.dot(vertex));
  return lowest;
}

/// Area of a counter-clockwise outline; 0 if the point is not inside.
double areaAround(const std::vector<Point2>& outline, const Point2& inside) {
  double area = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point2 a = outline[i] - inside;
    const Point2 b = outline[(i + 1) % outline.size()] - inside;
    const double part = 0.5 * (a.x() * b.y() - a.y() * b.x());
    if (part < 0.0) return 0.0;
    area += part;
  }
  return area;
}

/// Area of the convex hull of the points on which the body rests, square metres; 0 if it tips over.
double restingArea(const PlacedBody& body, const Vector3& up, double lowest) {
  const double limit = lowest + kRests * body.box.diagonal().norm();
  const Vector3 u = up.unitOrthogonal();
  const Vector3 v = up.cross(u);
  std::vector<Point2> points;
  for (const Vector3& vertex : body.mesh_W.vertices) {
    if (up.dot(vertex) <= limit) points.emplace_back(u.dot(vertex), v.dot(vertex));
  }
  if (points.size() < 3) return 0.0;
  return areaAround(convexHull(std::move(points)), {u.dot(body.mass.centre), v.dot(body.mass.centre)});
}

/// Normal of the largest plane of the body's surface; nothing if it is along an axis of the file.
std::optional<Vector3> slantedPlane(const TriangleMesh& mesh_W) {
  std::vector<std::pair<Vector3, double>> planes;
  for (const auto& [a, b, c] : mesh_W.triangles) {
    const auto& at = mesh_W.vertices;
    const Vector3 cross = (at[b] - at[a]).cross(at[c] - at[a]);
    if (!(cross.norm() > 0.0)) continue;
    const Vector3 normal = cross.normalized();
    const auto same = std::find_if(planes.begin(), planes.end(),
                                   [&](const auto& plane) { return plane.first.dot(normal) > kSamePlane; });
    if (same != planes.end()) {
      same->second += cross.norm();
    } else if (planes.size() < kMostPlanes) {
      planes.emplace_back(normal, cross.norm());
    }
  }
  if (planes.empty()) return std::nullopt;
  const Vector3 largest = std::max_element(planes.begin(), planes.end(), [](const auto& one, const auto& other) {
                            return one.second < other.second;
                          })->first;
  if (largest.cwiseAbs().maxCoeff() > kSamePlane) return std::nullopt;
  return largest;
}

class PositionChoice {
 public:
  explicit PositionChoice(const PositionQuestion& question) : question_(question) {
    for (const std::size_t body : bodiesIn(question.among)) {
      const RigidBody& own = question.product.bodies[body];
      PlacedBody placed{transformed(*own.mesh, own.X_WB), {}, {}, boxVolume(own), 0.0};
      placed.mass = solidMass(placed.mesh_W);
      placed.box = boundingBox(placed.mesh_W);
      const Vector3 sizes = boundingBox(*own.mesh).sizes();
      placed.largestFace = placed.boxVolume / std::max(sizes.minCoeff(), kThinnest);
      placed_.emplace(body, std::move(placed));
    }
    readJoints();
  }

  WorkPosition best() {
    const BodyGroup fixed = bodiesIn(question_.bases);
    BodyGroup candidates;
    for (const auto& [body, placed] : placed_) candidates.push_back(body);
    if (!fixed.empty()) candidates = fixed;
    if (question_.up) {
      ask({question_.up->normalized(), 1.0}, candidates);
    } else {
      for (const UpDirection& direction : axes()) ask(direction, candidates);
      askSlantedPlanesOf(std::move(candidates));
    }
    return best_;
  }

 private:
  /// Touches another body; no fastener; worth; size.
  using Rank = std::tuple<bool, bool, double, double>;

  void readJoints() {
    mayBeBase_.assign(question_.product.bodies.size(), true);
    unitOf_.assign(question_.product.bodies.size(), nullptr);
    for (std::size_t body = 0; body < question_.fasteners.size(); ++body) {
      mayBeBase_[body] = question_.fasteners[body] == FastenerKind::None;
    }
    for (const Joint& joint : question_.joints) {
      const bool isUnit = joint.kind == JointKind::Unit || joint.kind == JointKind::Permanent;
      if (!isUnit && joint.kind != JointKind::Snap) mayBeBase_[joint.body] = false;
      if (!isUnit) continue;
      unitOf_[joint.body] = &joint;
      for (const std::size_t other : joint.others) unitOf_[other] = &joint;
    }
  }

  /// Asks both normals of the largest plane of large bodies that lie aslant in the file.
  void askSlantedPlanesOf(BodyGroup bodies) {
    std::stable_sort(bodies.begin(), bodies.end(), [&](std::size_t one, std::size_t other) {
      return placed_.at(one).boxVolume > placed_.at(other).boxVolume;
    });
    bodies.resize(std::min(bodies.size(), kMostSlanted));
    for (const std::size_t body : bodies) {
      const auto plane = slantedPlane(placed_.at(body).mesh_W);
      if (!plane) continue;
      ask({*plane, kSlanted}, {body});
      ask({-*plane, kSlanted}, {body});
    }
  }

  void ask(const UpDirection& direction, const BodyGroup& bodies) {
    const Vector3& up = direction.up;
    std::map<std::size_t, double> lowest;
    double ground = std::numeric_limits<double>::infinity();
    double top = -ground;
    for (const auto& [body, placed] : placed_) {
      lowest[body] = lowestOf(placed.mesh_W, up);
      ground = std::min(ground, lowest[body]);
      top = std::max(top, -lowestOf(placed.mesh_W, -up));
    }
    for (const std::size_t body : bodies) {
      const bool stands = lowest[body] - ground <= kGround * (top - ground);
      const Rank rank = rankOf(body, direction, lowest[body], stands);
      if (bestRank_ && rank <= *bestRank_) continue;
      bestRank_ = rank;
      best_ = {body, up};
    }
  }

  Rank rankOf(std::size_t body, const UpDirection& direction, double lowest, bool stands) const {
    const PlacedBody& placed = placed_.at(body);
    const double touching = touchingOf(body);
    const double lies = std::max(kLeastLie, std::sqrt(restingArea(placed, direction.up, lowest) / placed.largestFace));
    const double worth = std::sqrt(touching) * std::cbrt(placed.boxVolume) * std::sqrt(lies) * direction.factor *
                         (stands ? kStands : 1.0) * std::sqrt(0.5 + shareAbove(body, direction.up));
    return {touching > 0.0, mayBeBase_[body], worth, placed.boxVolume};
  }

  /// Number of neighbours outside of the body's unit; a fastener counts less.
  double touchingOf(std::size_t body) const {
    double touching = 0.0;
    for (const std::size_t other : question_.graph.neighboursOf(body)) {
      const bool isFastener = !question_.fasteners.empty() && question_.fasteners[other] != FastenerKind::None;
      const bool isOfItsUnit = unitOf_[body] != nullptr && unitOf_[body] == unitOf_[other];
      if (question_.among[other] && !isOfItsUnit) touching += isFastener ? kFastenerTouch : 1.0;
    }
    return touching;
  }

  /// Share of the other bodies, by the volumes of their boxes, whose centre is above that of the body.
  double shareAbove(std::size_t body, const Vector3& up) const {
    const Vector3 centre = placed_.at(body).box.center();
    double above = 0.0;
    double all = 0.0;
    for (const auto& [other, placed] : placed_) {
      if (other == body) continue;
      all += placed.boxVolume;
      if (up.dot(placed.box.center() - centre) > 0.0) above += placed.boxVolume;
    }
    return all > 0.0 ? above / all : 1.0;
  }

  const PositionQuestion& question_;
  std::map<std::size_t, PlacedBody> placed_;
  std::vector<bool> mayBeBase_;
  std::vector<const Joint*> unitOf_;  ///< the joint of the unit that contains the body; null: none
  std::optional<Rank> bestRank_;
  WorkPosition best_;
};

}  // namespace

WorkPosition workPosition(const PositionQuestion& question) { return PositionChoice(question).best(); }

}  // namespace glissade
