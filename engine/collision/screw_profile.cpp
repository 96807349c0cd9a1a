#include "engine/collision/screw_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/geometry/range.h"

namespace glissade {
namespace {

using Flat = Eigen::Vector2d;

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kTwoPi = 2.0 * std::numbers::pi;
/// Pairs whose bound is above this share of the least bound found are not refined.
constexpr double kNearLeast = 0.8;
/// Triangles are divided until the error of their (r, s) is below this share of `enough`, or this many times.
constexpr double kErrorOfEnough = 0.05;
constexpr int kMostDivisions = 5;
/// Share of `enough` that suffices: no triangle is divided to prove more.
constexpr double kWantedShare = 0.75;
/// Largest half angle of a triangle, radians; a wider one has no (r, s).
constexpr double kWidest = 0.5;
/// Share of the bore. Points nearer to the axis have no (r, s).
constexpr double kCore = 0.5;
/// Relative rounding errors of lengths, and of coordinates.
constexpr double kRoundingShare = 1e-9;
constexpr double kCoordinateRounding = 1e-14;
constexpr std::size_t kElementsOfLeaf = 4;
/// Rounding error of a number of turns.
constexpr double kTurnRounding = 1e-9;

double sizeOf(const Range& range) { return range.high - range.low; }

double gapOf(const Range& a, const Range& b) { return std::max({0.0, a.low - b.high, b.low - a.high}); }

/// A triangle, or several triangles. Its (r, s) lie within `error` of a convex polygon.
struct ProfileShape {
  std::vector<Flat> corners;  ///< counter-clockwise; empty: (r, s) is not known
  double error = 0.0;
  Range radius;
  Range height;
  Range shift;  ///< range of s of the corners
  Range angle;  ///< angle about the axis in radians, including the turns that bring s below the pitch
};

double cross(const Flat& a, const Flat& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Convex hull by Andrew's monotone chain.
std::vector<Flat> convexHull(std::vector<Flat> points) {
  std::sort(points.begin(), points.end(),
            [](const Flat& a, const Flat& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  std::vector<Flat> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t begin = hull.size();
    for (const Flat& p : points) {
      while (hull.size() >= begin + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  if (hull.empty()) hull.push_back(points.front());
  return hull;
}

/// Largest distance by which the other polygon, moved by `by`, lies beyond an edge of the polygon along the edge's
/// normal; below 0: beyond none.
double beyondEdges(const std::vector<Flat>& polygon, const std::vector<Flat>& other, const Flat& by) {
  double most = -kNever;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Flat edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    const double length = edge.norm();
    if (length <= 0.0) continue;
    const Flat outwards(edge.y() / length, -edge.x() / length);
    double least = kNever;
    for (const Flat& p : other) least = std::min(least, outwards.dot(p + by - polygon[i]));
    most = std::max(most, least);
  }
  return most;
}

/// The axis, and the scaling of (r, s): s is divided by `slope`, so that (r, s) changes by no more than points move.
struct ProfileFrame {
  ScrewAxis screw;
  Vector3 u;
  Vector3 v;
  double core;   ///< least r of points that have (r, s)
  double slope;  ///< scale of s, >= 1
  double pitch;  ///< period of s, divided by the slope; below 0: left-handed

  ProfileFrame(const ScrewAxis& axis, double bore)
      : screw(axis), u(axis.axis_W.unitOrthogonal()), v(axis.axis_W.cross(u)), core(kCore * bore) {
    // Points whose distance is at most the core's radius are joined by a line that stays farther from the axis than
    // half of it.
    slope = core > 0.0 ? std::hypot(1.0, screw.pitch / (kTwoPi * 0.5 * core)) : 1.0;
    pitch = screw.pitch / slope;
  }

  Vector3 placed(const Vector3& p_W) const {
    const Vector3 p = p_W - screw.point_W;
    return {p.dot(u), p.dot(v), p.dot(screw.axis_W)};
  }
};

Flat flatOf(const Vector3& p) { return p.head<2>(); }

double nearestOfSegment(const Flat& a, const Flat& b) {
  const Flat way = b - a;
  const double length = way.squaredNorm();
  const double t = length > 0.0 ? std::clamp(-a.dot(way) / length, 0.0, 1.0) : 0.0;
  return (a + t * way).norm();
}

using PlacedTriangle = std::array<Vector3, 3>;

/// Distances of the triangle's points from the z axis.
Range radiusOf(const PlacedTriangle& corners) {
  const Flat a = flatOf(corners[0]);
  const Flat b = flatOf(corners[1]);
  const Flat c = flatOf(corners[2]);
  const std::array<double, 3> sides{cross(a, b), cross(b, c), cross(c, a)};
  const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
  Range radius;
  for (const Flat& p : {a, b, c}) radius.take(p.norm());
  const bool around = (*least >= 0.0 || *most <= 0.0) && *least != *most;
  radius.low = around ? 0.0 : std::min({nearestOfSegment(a, b), nearestOfSegment(b, c), nearestOfSegment(c, a)});
  return radius;
}

/// The shape of a triangle, with (r, s) where they are defined.
ProfileShape shapeOf(const PlacedTriangle& corners, const ProfileFrame& frame) {
  ProfileShape shape;
  shape.radius = radiusOf(corners);
  for (const Vector3& p : corners) shape.height.take(p.z());
  if (frame.core <= 0.0 || shape.radius.low < frame.core) return shape;
  const Flat middle = flatOf(corners[0] + corners[1] + corners[2]).normalized();
  const double angle = std::atan2(middle.y(), middle.x());
  double widest = 0.0;
  Range lever;  // r cos(angle) of the corners, which bounds the deviation of the triangle's angles from linear ones
  std::vector<Flat> profile;
  Range turns;
  for (const Vector3& p : corners) {
    const Flat flat = flatOf(p);
    const double turn = std::atan2(cross(middle, flat), middle.dot(flat));
    widest = std::max(widest, std::abs(turn));
    turns.take(angle + turn);
    lever.take(middle.dot(flat));
    profile.emplace_back(flat.norm(), (p.z() - frame.screw.pitch * (angle + turn) / kTwoPi) / frame.slope);
  }
  if (widest > kWidest) return shape;
  const double ratio = std::sqrt(lever.high / lever.low);
  const double turnError = 2.0 * widest * (ratio - 1.0) / (ratio + 1.0) + 2.0 * (std::tan(widest) - widest);
  // r is below its linear interpolation by at most the sagitta.
  const double sagitta = shape.radius.high * (1.0 - std::cos(widest));
  shape.error = std::hypot(0.5 * sagitta, turnError * std::abs(frame.pitch) / kTwoPi);
  for (Flat& p : profile) p.x() -= 0.5 * sagitta;
  const double centre = (profile[0].y() + profile[1].y() + profile[2].y()) / 3.0;
  const double whole = std::floor(centre / frame.pitch);
  for (Flat& p : profile) {
    p.y() -= whole * frame.pitch;
    shape.shift.take(p.y());
  }
  shape.angle = {turns.low + kTwoPi * whole, turns.high + kTwoPi * whole};
  shape.corners = convexHull(std::move(profile));
  return shape;
}

/// The triangles of one body, as a tree. Triangles are divided on demand.
class ScrewProfile {
 public:
  ScrewProfile(const std::vector<PlacedTriangle>& triangles, const ProfileFrame& frame) : frame_(frame) {
    for (const PlacedTriangle& triangle : triangles) add(triangle, kMostDivisions);
    const auto known = std::partition(elements_.begin(), elements_.end(),
                                      [](const Element& element) { return element.shape.corners.empty(); });
    const auto split = static_cast<std::uint32_t>(known - elements_.begin());
    const auto count = static_cast<std::uint32_t>(elements_.size());
    nodes_.emplace_back();
    if (split > 0 && split < count) {
      const std::uint32_t first = build(0, split);
      const std::uint32_t second = build(split, count);
      nodes_[0] = {together({nodes_[first].shape, nodes_[second].shape}), first, second, 0};
    } else {
      build(0, count);
      nodes_[0] = nodes_[1];
    }
  }

  struct Node {
    ProfileShape shape;
    std::uint32_t first = 0;   ///< element of a leaf, else index of a node
    std::uint32_t second = 0;  ///< index of a node
    std::uint32_t count = 0;   ///< number of a leaf's elements; 0: no leaf
  };
  const Node& node(std::uint32_t index) const { return nodes_[index]; }
  /// Shape of an element; valid until the next call of partsOf().
  const ProfileShape& shape(std::uint32_t element) const { return elements_[element].shape; }

  /// Improvement of the element's (r, s) by a division; 0: it is not divided.
  double coarseness(std::uint32_t element, double mostError) const {
    const Element& own = elements_[element];
    if (own.divisions == 0) return 0.0;
    if (own.shape.corners.empty()) return own.shape.radius.high > frame_.core ? kNever : 0.0;
    return own.shape.error > mostError ? own.shape.error : 0.0;
  }

  /// Improvement of the element's radii and heights by a division; 0: it is not divided.
  double extent(std::uint32_t element, double mostError) const {
    const Element& own = elements_[element];
    const double size = std::max(sizeOf(own.shape.radius), sizeOf(own.shape.height));
    return own.divisions > 0 && size > mostError ? size : 0.0;
  }

  /// Divides an element into four, and returns the first of them.
  std::uint32_t partsOf(std::uint32_t element) {
    if (elements_[element].parts == 0) {
      elements_[element].parts = static_cast<std::uint32_t>(elements_.size());
      const int divisions = elements_[element].divisions - 1;
      const auto [a, b, c] = elements_[element].triangle;
      const Vector3 ab = 0.5 * (a + b);
      const Vector3 bc = 0.5 * (b + c);
      const Vector3 ca = 0.5 * (c + a);
      for (const PlacedTriangle& part : {PlacedTriangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
        add(part, divisions);
      }
    }
    return elements_[element].parts;
  }

 private:
  struct Element {
    ProfileShape shape;
    PlacedTriangle triangle;
    int divisions = 0;        ///< divisions that are left
    std::uint32_t parts = 0;  ///< index of the first of four parts; 0: it is not divided
  };

  void add(const PlacedTriangle& triangle, int divisions) {
    elements_.push_back({shapeOf(triangle, frame_), triangle, divisions});
  }

  ProfileShape shapeOfLeaf(std::uint32_t first, std::uint32_t last) const {
    std::vector<ProfileShape> shapes;
    for (std::uint32_t i = first; i < last; ++i) shapes.push_back(elements_[i].shape);
    return together(shapes);
  }

  static ProfileShape together(const std::vector<ProfileShape>& shapes) {
    ProfileShape all;
    bool known = true;
    std::vector<Flat> points;
    for (const ProfileShape& shape : shapes) {
      all.radius.take(shape.radius);
      all.height.take(shape.height);
      all.angle.take(shape.angle);
      all.error = std::max(all.error, shape.error);
      known = known && !shape.corners.empty();
      points.insert(points.end(), shape.corners.begin(), shape.corners.end());
    }
    if (!known) return all;
    for (const Flat& p : points) all.shift.take(p.y());
    all.corners = convexHull(std::move(points));
    return all;
  }

  static Flat middleOf(const ProfileShape& shape) {
    if (shape.corners.empty()) {
      return {0.5 * (shape.radius.low + shape.radius.high), 0.5 * (shape.height.low + shape.height.high)};
    }
    Flat sum = Flat::Zero();
    for (const Flat& p : shape.corners) sum += p;
    return sum / static_cast<double>(shape.corners.size());
  }

  std::uint32_t build(std::uint32_t first, std::uint32_t last) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    if (last - first <= kElementsOfLeaf) {
      nodes_[index] = {shapeOfLeaf(first, last), first, 0, last - first};
      return index;
    }
    Eigen::AlignedBox2d box;
    for (std::uint32_t i = first; i < last; ++i) box.extend(middleOf(elements_[i].shape));
    const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(
        elements_.begin() + first, elements_.begin() + middle, elements_.begin() + last,
        [&](const Element& a, const Element& b) { return middleOf(a.shape)[axis] < middleOf(b.shape)[axis]; });
    const std::uint32_t below = build(first, middle);
    const std::uint32_t above = build(middle, last);
    nodes_[index] = {together({nodes_[below].shape, nodes_[above].shape}), below, above, 0};
    return index;
  }

  const ProfileFrame& frame_;
  std::vector<Element> elements_;
  std::vector<Node> nodes_;
};

/// Branch and bound over the pairs of two profiles.
class ProfileDistance {
 public:
  ProfileDistance(ScrewProfile& moving, ScrewProfile& fixed, const ProfileFrame& frame, double advance)
      : moving_(moving),
        fixed_(fixed),
        frame_(frame),
        pitch_(frame.pitch),
        rise_{std::min(0.0, advance), std::max(0.0, advance)} {}

  /// Lower bound on the distance. Triangles with a bound below `target` are divided. Precondition: `enough` is at most
  /// the core.
  double least(double enough, double target) {
    found_ = shown_ = enough;
    target_ = target;
    mostError_ = kErrorOfEnough * enough;
    const double aside = frame_.core > 0.0 ? 2.0 * std::asin(0.5 * enough / frame_.core) : 0.0;
    turned_ = {};
    for (const double rise : {rise_.low, rise_.high}) turned_.take(frame_.screw.turnFor(rise));
    turned_ = {turned_.low - aside, turned_.high + aside};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, 0}};
    while (!open.empty() && shown_ > 0.0) {
      const auto [a, b] = open.back();
      open.pop_back();
      const ScrewProfile::Node& one = moving_.node(a);
      const ScrewProfile::Node& other = fixed_.node(b);
      if (isFar(apart(one.shape, other.shape))) continue;
      if (one.count > 0 && other.count > 0) {
        compare(one, other);
      } else if (other.count > 0 || (one.count == 0 && sizeOf(one.shape) >= sizeOf(other.shape))) {
        open.emplace_back(one.first, b);
        open.emplace_back(one.second, b);
      } else {
        open.emplace_back(a, other.first);
        open.emplace_back(a, other.second);
      }
    }
    return std::max(0.0, shown_);
  }

 private:
  static double sizeOf(const ProfileShape& shape) {
    const double size = shape.radius.high - shape.radius.low;
    return shape.corners.empty() ? size + shape.height.high - shape.height.low
                                 : size + shape.shift.high - shape.shift.low;
  }

  bool isFar(double bound) {
    if (bound < kNearLeast * found_) return false;
    shown_ = std::min(shown_, bound);
    return true;
  }

  void compare(const ScrewProfile::Node& one, const ScrewProfile::Node& other) {
    for (std::uint32_t i = one.first; i < one.first + one.count; ++i) {
      for (std::uint32_t k = other.first; k < other.first + other.count && shown_ > 0.0; ++k) compareElements(i, k);
    }
  }

  /// Compares two elements and divides the less accurate one: by its (r, s) as long as these can be improved, else by
  /// its radii and heights.
  void compareElements(std::uint32_t i, std::uint32_t k) {
    const double bound = apart(moving_.shape(i), fixed_.shape(k));
    if (bound >= found_) return;
    std::array coarse{moving_.coarseness(i, mostError_), fixed_.coarseness(k, mostError_)};
    if (std::max(coarse[0], coarse[1]) == 0.0) coarse = {moving_.extent(i, mostError_), fixed_.extent(k, mostError_)};
    if (bound >= target_ || std::max(coarse[0], coarse[1]) == 0.0) {
      found_ = std::min(found_, bound);
      shown_ = std::min(shown_, bound);
      return;
    }
    const bool dividesMoving = coarse[0] >= coarse[1];
    const std::uint32_t first = dividesMoving ? moving_.partsOf(i) : fixed_.partsOf(k);
    for (std::uint32_t part = first; part < first + 4 && shown_ > 0.0; ++part) {
      dividesMoving ? compareElements(part, k) : compareElements(i, part);
    }
  }

  /// Lower bound on the distance of any two points of the shapes during the motion.
  double apart(const ProfileShape& a, const ProfileShape& b) const {
    const Range height{a.height.low + rise_.low, a.height.high + rise_.high};
    const double radial = gapOf(a.radius, b.radius);
    const double boxes = std::hypot(radial, gapOf(height, b.height));
    if (a.corners.empty() || b.corners.empty()) return boxes;
    return std::max(boxes, apartInProfile(a, b, radial) - a.error - b.error);
  }

  /// Lower bound by (r, s). Points that are nearer to each other than the limit have nearly the same angle, after a
  /// number of turns. The advance bounds the numbers of turns in the motion.
  double apartInProfile(const ProfileShape& a, const ProfileShape& b, double radial) const {
    const double slack = found_ + a.error + b.error;
    const double ends[]{(b.shift.low - a.shift.high - slack) / pitch_, (b.shift.high - a.shift.low + slack) / pitch_};
    const double first = std::max(std::ceil((a.angle.low - b.angle.high + turned_.low) / kTwoPi - kTurnRounding),
                                  std::ceil(std::min(ends[0], ends[1])));
    const double last = std::min(std::floor((a.angle.high - b.angle.low + turned_.high) / kTwoPi + kTurnRounding),
                                 std::floor(std::max(ends[0], ends[1])));
    double least = slack;
    for (double turn = first; turn <= last; turn += 1.0) {
      const Flat by(0.0, turn * pitch_);
      const Range moved{a.shift.low + by.y(), a.shift.high + by.y()};
      const double boxes = std::hypot(radial, gapOf(moved, b.shift));
      if (boxes >= least) continue;
      const double edges = std::max(beyondEdges(a.corners, b.corners, -by), beyondEdges(b.corners, a.corners, by));
      least = std::min(least, std::max(boxes, edges));
    }
    return least;
  }

  ScrewProfile& moving_;
  ScrewProfile& fixed_;
  const ProfileFrame& frame_;
  double pitch_;
  double target_ = 0.0;
  double mostError_ = 0.0;  ///< largest error of (r, s) of triangles that are not divided
  Range rise_;
  Range turned_;        ///< angle by which the first body turns, radians, extended by the angle between near points
  double found_ = 0.0;  ///< least bound of two triangles
  double shown_ = 0.0;  ///< least bound of all pairs that were excluded or compared
};

/// All triangles of a body, in the frame of the axis.
struct PlacedBody {
  std::vector<PlacedTriangle> triangles;
  Range radius;
  double coordinates = 0.0;

  PlacedBody(const std::vector<Triangle>& body, const ProfileFrame& frame) {
    for (const Triangle& triangle : body) {
      triangles.push_back({frame.placed(triangle[0]), frame.placed(triangle[1]), frame.placed(triangle[2])});
      radius.take(radiusOf(triangles.back()));
      for (const Vector3& p : triangle) coordinates = std::max(coordinates, p.cwiseAbs().maxCoeff());
    }
  }
};

}  // namespace

double screwDistance(const std::vector<Triangle>& moving, const std::vector<Triangle>& fixed, const ScrewAxis& screw,
                     double advance, double enough, double wanted) {
  if (moving.empty() || fixed.empty()) return enough;
  const ProfileFrame axes(screw, 0.0);
  const PlacedBody one(moving, axes);
  const PlacedBody other(fixed, axes);
  const ProfileFrame frame(screw, std::max(one.radius.low, other.radius.low));
  const double limit = frame.core > 0.0 ? std::min(enough, frame.core) : enough;
  ScrewProfile profile(one.triangles, frame);
  ScrewProfile others(other.triangles, frame);
  const double least =
      ProfileDistance(profile, others, frame, advance).least(limit, std::min(wanted, kWantedShare * limit));
  const double rounding = kCoordinateRounding * (one.coordinates + other.coordinates + screw.point_W.norm());
  return std::max(0.0, least * (1.0 - kRoundingShare) - rounding);
}

}  // namespace glissade
