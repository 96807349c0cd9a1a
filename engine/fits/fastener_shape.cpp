#include "engine/fits/fastener_shape.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/fits/surface_regions.h"

namespace glissade {
namespace {

/// Least ratio of the least to the largest radius of a round section; a box of two to one has less.
constexpr double kLeastRound = 0.42;
constexpr double kLeastRoundShaft = 0.7;
/// Share of the directions in which a shaft has a surface.
constexpr double kShaftAround = 0.8;
/// Share of the length in which sections have to be round.
constexpr double kRoundLength = 0.8;
/// Relative difference within which radii are equal.
constexpr double kOneRadius = 0.06;
constexpr double kLeastHeadRadius = 1.22;
constexpr double kMostHeadRadius = 4.0;
constexpr double kMostHeadLength = 0.8;
constexpr double kMostDome = 0.15;      ///< share of the length
constexpr double kMostNutHeight = 1.6;  ///< ratio to the outer diameter
constexpr double kMostRingRadius = 6.0;
/// Least ratio of length to radius of a screw without a head.
constexpr double kLeastSetScrew = 0.8;
/// Least length of a prism, as a share of the nut or the head.
constexpr double kPrismShare = 0.25;
/// Spreads of a surface within this ratio are about equal, and give no direction.
constexpr double kCompactShare = 0.4;
constexpr std::size_t kMostDirections = 6;
/// Bodies of more are no small fasteners, and finding their cylinders takes long.
constexpr std::size_t kMostTriangles = 5000;
/// Grooves are at most so wide, by the radius: threads for plastic have a pitch of 0.8 radii.
constexpr double kWidestGroove = 0.9;
/// Axes of cylinders that may be the main axis: sine of the angle, share of the radius.
constexpr double kNearAxisSine = 0.1;
constexpr double kNearAxisShare = 0.3;

struct MainAxes {
  Vector3 centre = Vector3::Zero();
  double share = 1.0;                   ///< ratio of the least to the largest of the three spreads
  std::array<Vector3, 3> directions{};  ///< the direction that is most unlike the others comes first
};

/// The main axes of the surface. If a body is symmetric about an axis, that axis is one of them.
MainAxes mainAxesOf(const TriangleTree& tree) {
  const Vector3 about = tree.box().center();
  double area = 0.0;
  Vector3 first = Vector3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const auto& [a, b, c] : tree.triangles()) {
    const Vector3 sum = a + b + c - 3.0 * about;
    const double part = 0.5 * (b - a).cross(c - a).norm();
    area += part;
    first += part * sum / 3.0;
    Eigen::Matrix3d outer = sum * sum.transpose();
    for (const Vector3& p : {a, b, c}) outer += (p - about) * (p - about).transpose();
    second += part / 12.0 * outer;
  }
  MainAxes axes;
  if (!(area > 0.0)) return axes;
  const Vector3 middle = first / area;
  axes.centre = about + middle;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second / area - middle * middle.transpose());
  const Vector3& values = solver.eigenvalues();  // ascending
  axes.share = values[0] / values[2];
  const bool lowFirst = values[1] - values[0] > values[2] - values[1];
  const std::array<int, 3> order = lowFirst ? std::array<int, 3>{0, 2, 1} : std::array<int, 3>{2, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) axes.directions[i] = solver.eigenvectors().col(order[i]);
  return axes;
}

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double radius = 0.0;
};

Extent extentAbout(const TriangleMesh& mesh, const AxisLine& axis) {
  Extent extent;
  for (const Vector3& vertex : mesh.vertices) {
    const double height = axis.heightOf(vertex);
    extent.low = std::min(extent.low, height);
    extent.high = std::max(extent.high, height);
    extent.radius = std::max(extent.radius, axis.distanceOf(vertex));
  }
  return extent;
}

bool isRoundEnough(const std::vector<AxialSlab>& slabs) {
  double round = 0.0;
  double all = 0.0;
  for (const AxialSlab& slab : slabs) {
    all += slab.length();
    if (slab.outerLeast() >= kLeastRound * slab.outerMost()) round += slab.length();
  }
  return round >= kRoundLength * all;
}

/// The axis of the longest cylinder near the rough axis; the rough axis if there is none.
AxisLine exactAxis(const TriangleMesh& mesh, const AxisLine& rough, double radius) {
  const SurfaceRegions regions = findSurfaceRegions(welded(mesh));
  const CylinderRegion* longest = nullptr;
  for (const CylinderRegion& cylinder : regions.cylinders) {
    const Vector3 middle = cylinder.point + 0.5 * (cylinder.low + cylinder.high) * cylinder.direction;
    const bool isNear = cylinder.direction.cross(rough.direction).norm() < kNearAxisSine &&
                        rough.distanceOf(middle) < kNearAxisShare * std::min(radius, cylinder.radius);
    if (!isNear) continue;
    if (longest == nullptr || cylinder.high - cylinder.low > longest->high - longest->low) longest = &cylinder;
  }
  if (longest == nullptr) return rough;
  const double sense = longest->direction.dot(rough.direction) < 0.0 ? -1.0 : 1.0;
  const AxisLine exact{longest->point, sense * longest->direction};
  return {exact.point + exact.heightOf(rough.point) * exact.direction, exact.direction};
}

TurnedShape mirrored(TurnedShape shape) {
  shape.axis.direction = -shape.axis.direction;
  std::swap(shape.low, shape.high);
  shape.low = -shape.low;
  shape.high = -shape.high;
  std::reverse(shape.slabs.begin(), shape.slabs.end());
  for (AxialSlab& slab : shape.slabs) {
    std::swap(slab.low, slab.high);
    slab.low = -slab.low;
    slab.high = -slab.high;
  }
  return shape;
}

/// A radius, and the length that has it.
struct RadiusLength {
  double radius = 0.0;
  double length = 0.0;
};

/// The median radius by length.
double middleRadius(std::vector<RadiusLength> parts) {
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.radius < b.radius; });
  double all = 0.0;
  for (const RadiusLength& part : parts) all += part.length;
  double sum = 0.0;
  for (const RadiusLength& part : parts) {
    sum += part.length;
    if (sum >= 0.5 * all) return part.radius;
  }
  return 0.0;
}

/// True if the section has a surface all around, as a shaft has, except for grooves; false for two tabs side by side.
bool isAllAround(const AxialSlab& slab) {
  const auto met =
      std::count_if(slab.farthest.begin(), slab.farthest.end(), [](double distance) { return distance > 0.0; });
  return static_cast<double>(met) >= kShaftAround * static_cast<double>(slab.farthest.size());
}

/// The sections of a shaft that are about as wide as this radius.
RadiusLength alikeOf(const std::vector<AxialSlab>& slabs, double radius) {
  std::vector<RadiusLength> alike;
  double length = 0.0;
  for (const AxialSlab& slab : slabs) {
    if (std::abs(slab.outerMost() - radius) > kOneRadius * radius || !isAllAround(slab)) continue;
    alike.push_back({slab.outerMost(), slab.length()});
    length += slab.length();
  }
  return {middleRadius(std::move(alike)), length};
}

/// Possible radii of a shaft; the one with the greatest length first.
std::vector<double> shaftRadii(const std::vector<AxialSlab>& slabs) {
  std::vector<RadiusLength> lengths;
  for (const AxialSlab& slab : slabs) {
    const double radius = slab.outerMost();
    if (slab.isSolid && slab.outerLeast() >= kLeastRoundShaft * radius) lengths.push_back(alikeOf(slabs, radius));
  }
  std::stable_sort(lengths.begin(), lengths.end(), [](const auto& a, const auto& b) { return a.length > b.length; });
  std::vector<double> radii;
  for (const RadiusLength& one : lengths) {
    const auto isKnown = [&](double other) { return std::abs(other - one.radius) <= kOneRadius * one.radius; };
    if (std::none_of(radii.begin(), radii.end(), isKnown)) radii.push_back(one.radius);
  }
  return radii;
}

/// Number of sides of a prism, six or four, that is long enough; for a nut, or the head above `from`.
int sidesOf(const std::vector<AxialSlab>& slabs, double from, double across, double* size) {
  for (const int sides : {6, 4}) {
    double length = 0.0;
    for (const AxialSlab& slab : slabs) {
      if (slab.low < from) continue;
      const auto flats = acrossFlats(slab.farthest, sides);
      if (!flats) continue;
      length += slab.length();
      *size = *flats;
    }
    if (length >= kPrismShare * across) return sides;
  }
  *size = 0.0;
  return 0;
}

/// True for a box: two pairs of flats at equal distances.
bool isRectangle(const AxialSlab& slab) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t flat = 0;
  for (const double radius : slab.farthest) least = std::min(least, radius);
  const double most = slab.outerMost();
  for (std::size_t turn = 0; turn < slab.farthest.size(); ++turn) {
    if (slab.farthest[turn] > least) continue;
    flat = turn;
    break;
  }
  const std::size_t quarter = slab.farthest.size() / 4;
  double other = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    other = std::min(other, slab.farthest[(flat + quarter - 1 + k) % slab.farthest.size()]);
  }
  return std::abs(std::hypot(least, other) - most) <= 0.04 * most && most > 1.25 * least;
}

/// Sets the recess that is open from the upper end.
void noteRecess(TurnedShape& shape, double head) {
  std::vector<DriveShape> seen;
  for (auto slab = shape.slabs.rbegin(); slab != shape.slabs.rend() && !slab->isSolid; ++slab) {
    shape.recess = shape.high - slab->low;
    seen.push_back(recessShape(slab->nearest, head));
  }
  const auto known =
      std::find_if(seen.begin(), seen.end(), [](const DriveShape& one) { return one.kind != DriveKind::None; });
  if (known != seen.end()) shape.drive = *known;
}

/// The screw with its head at the upper end.
std::optional<TurnedShape> screwOf(TurnedShape shape, double shaft) {
  shape.shaft = shaft;
  const double border = (1.0 + 2.0 * kOneRadius) * shaft;
  const auto isWide = [border](const AxialSlab& slab) { return slab.outerMost() > border; };
  auto head = std::find_if(shape.slabs.rbegin(), shape.slabs.rend(), isWide);
  // The dome of a button head is narrow at its end.
  if (head == shape.slabs.rend() || shape.high - head->high > kMostDome * shape.length()) return std::nullopt;
  double widest = 0.0;
  for (; head != shape.slabs.rend() && isWide(*head); ++head) widest = std::max(widest, head->outerMost());
  if (head == shape.slabs.rend()) return std::nullopt;
  shape.headLow = head->high;
  double shaftLength = 0.0;
  double solidLength = 0.0;
  for (; head != shape.slabs.rend(); ++head) {
    if (head->outerMost() > border) return std::nullopt;
    if (head->outerMost() > (1.0 - kOneRadius) * shaft && isAllAround(*head)) shaftLength += head->length();
    if (head->isSolid) solidLength += head->length();
  }
  const bool isHead = widest >= kLeastHeadRadius * shaft && widest <= kMostHeadRadius * shaft &&
                      shape.high - shape.headLow <= kMostHeadLength * shape.length();
  const double below = shape.headLow - shape.low;
  if (!isHead || shaftLength < 0.3 * below || solidLength < 0.5 * below) return std::nullopt;
  shape.kind = TurnedKind::Screw;
  shape.outer = widest;
  noteRecess(shape, widest);
  double size = 0.0;
  shape.sides = sidesOf(shape.slabs, shape.headLow - 1e-9, shape.high - shape.headLow, &size);
  if (shape.sides == 6 && shape.drive.kind == DriveKind::None) shape.drive = {DriveKind::HexOutside, size};
  return shape;
}

std::optional<TurnedShape> rodOf(TurnedShape shape) {
  double shaft = 0.0;
  double solid = 0.0;
  for (const AxialSlab& slab : shape.slabs) {
    if (slab.outerLeast() < kLeastRoundShaft * slab.outerMost()) return std::nullopt;
    shaft = std::max(shaft, slab.outerMost());
    if (slab.isSolid) solid += slab.length();
  }
  double wide = 0.0;
  for (const AxialSlab& slab : shape.slabs)
    wide += slab.outerMost() > (1.0 - 2.0 * kOneRadius) * shaft ? slab.length() : 0.0;
  if (wide < 0.6 * shape.length() || solid < 0.25 * shape.length()) return std::nullopt;
  shape.shaft = shape.outer = shaft;
  shape.headLow = shape.high;
  noteRecess(shape, shaft);
  if (shape.drive.kind == DriveKind::None) {
    TurnedShape other = mirrored(shape);
    other.headLow = other.high;
    other.recess = 0.0;
    noteRecess(other, shaft);
    if (other.drive.kind != DriveKind::None) shape = other;
  }
  const bool isSetScrew = shape.drive.kind != DriveKind::None && shape.length() >= kLeastSetScrew * shaft;
  if (!isSetScrew && solid < 0.9 * shape.length()) return std::nullopt;
  shape.kind = isSetScrew ? TurnedKind::SetScrew : TurnedKind::Rod;
  return shape;
}

/// True for a round hole, also with a modelled thread, which is narrower in some directions; a square hole is narrower
/// still.
bool isRoundHole(const AxialSlab& slab) {
  constexpr double kLeastRoundHole = 0.78;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const double distance : slab.nearest) {
    if (!std::isfinite(distance)) continue;
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  return least >= kLeastRoundHole * most;
}

/// The narrowest hole over a part of the length, so that chamfers and lips do not count.
double holeOf(const std::vector<AxialSlab>& slabs, double length) {
  std::vector<std::pair<double, double>> holes;  // radius and length
  for (const AxialSlab& slab : slabs) {
    if (slab.isSolid || slab.surroundedShare() <= 0.9 || !isRoundHole(slab)) continue;
    holes.emplace_back(slab.nearestAt(0.9), slab.length());
  }
  std::sort(holes.begin(), holes.end());
  double sum = 0.0;
  for (const auto& [radius, part] : holes) {
    sum += part;
    if (sum >= 0.15 * length) return radius;
  }
  return 0.0;
}

std::optional<TurnedShape> ringOf(TurnedShape shape) {
  double open = 0.0;
  for (const AxialSlab& slab : shape.slabs) {
    if (!slab.isSolid && slab.surroundedShare() > 0.7) open += slab.length();
    shape.outer = std::max(shape.outer, slab.outerMost());
  }
  const bool isThrough = open >= 0.97 * shape.length();
  if (open < 0.5 * shape.length()) return std::nullopt;
  shape.hole = holeOf(shape.slabs, shape.length());
  if (shape.hole <= 0.0 || shape.outer > kMostRingRadius * shape.hole) return std::nullopt;
  shape.headLow = shape.high;
  double size = 0.0;
  shape.sides = sidesOf(shape.slabs, shape.low - 1e-9, shape.length(), &size);
  if (shape.sides == 0 && std::all_of(shape.slabs.begin(), shape.slabs.end(), isRectangle)) shape.sides = 4;
  const bool isFlat = shape.length() <= kMostNutHeight * 2.0 * shape.outer;
  if (shape.sides != 0 && isFlat && shape.outer > 1.2 * shape.hole) {
    shape.kind = TurnedKind::Nut;
    shape.drive = {shape.sides == 6 ? DriveKind::HexOutside : DriveKind::None, shape.sides == 6 ? size : 0.0};
    return shape;
  }
  if (!isThrough) return std::nullopt;
  shape.kind = TurnedKind::Ring;
  return shape;
}

std::optional<TurnedShape> classified(const TurnedShape& shape) {
  const std::vector<double> radii = shaftRadii(shape.slabs);
  for (std::size_t i = 0; i < std::min<std::size_t>(3, radii.size()); ++i) {
    if (auto screw = screwOf(shape, radii[i])) return screw;
    if (auto screw = screwOf(mirrored(shape), radii[i])) return screw;
  }
  if (auto ring = ringOf(shape)) return ring;
  return rodOf(shape);
}

/// Outer surfaces in each direction, each the largest or the least of those that are as near along the axis.
using Outline = std::vector<std::vector<double>>;

Outline spread(const Outline& outline, const std::vector<AxialSlab>& slabs, double reach, bool isLargest) {
  const auto middleOf = [&](std::size_t i) { return 0.5 * (slabs[i].low + slabs[i].high); };
  Outline result = outline;
  std::size_t first = 0;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    while (middleOf(first) < middleOf(i) - reach) ++first;
    for (std::size_t near = first; near < slabs.size() && middleOf(near) <= middleOf(i) + reach; ++near) {
      for (std::size_t k = 0; k < outline[i].size(); ++k) {
        result[i][k] = isLargest ? std::max(result[i][k], outline[near][k]) : std::min(result[i][k], outline[near][k]);
      }
    }
  }
  return result;
}

/// With grooves filled: the turns of a thread and rings are a cylinder. Steps stay where they are (morphological
/// closing along the axis).
TurnedShape withoutGrooves(TurnedShape shape) {
  std::vector<RadiusLength> radii;
  Outline outline;
  for (const AxialSlab& slab : shape.slabs) {
    radii.push_back({slab.outerMost(), slab.length()});
    outline.push_back(slab.farthest);
  }
  const double reach = 0.5 * kWidestGroove * middleRadius(std::move(radii));
  const Outline filled = spread(spread(outline, shape.slabs, reach, true), shape.slabs, reach, false);
  for (std::size_t i = 0; i < filled.size(); ++i) shape.slabs[i].farthest = filled[i];
  return shape;
}

/// A body that has a shaft once its grooves are filled.
std::optional<TurnedShape> classifiedWithoutGrooves(const TurnedShape& shape) {
  const TurnedShape filled = withoutGrooves(shape);
  for (const double radius : shaftRadii(filled.slabs)) {
    if (auto screw = screwOf(filled, radius)) return screw;
    if (auto screw = screwOf(mirrored(filled), radius)) return screw;
  }
  return rodOf(filled);
}

TurnedShape lookedAt(const TriangleMesh& mesh, const AxialMesh& axial, const AxisLine& axis) {
  const Extent extent = extentAbout(mesh, axis);
  TurnedShape shape;
  shape.axis = axis;
  shape.low = extent.low;
  shape.high = extent.high;
  shape.slabs = axial.slabsAbout(axis, {extent.low, extent.high, 1.001 * extent.radius});
  return shape;
}

/// The sections about an axis near this one; nothing where they are not round.
std::optional<TurnedShape> roundAbout(const TriangleMesh& mesh, const AxialMesh& axial, const AxisLine& rough) {
  const TurnedShape first = lookedAt(mesh, axial, rough);
  if (!isRoundEnough(first.slabs)) return std::nullopt;
  double radius = 0.0;
  for (const AxialSlab& slab : first.slabs) radius = std::max(radius, slab.outerMost());
  return lookedAt(mesh, axial, exactAxis(mesh, rough, radius));
}

/// Directions of the cylinders of a mesh, the longest cylinder first.
std::vector<Vector3> cylinderDirections(const TriangleMesh& mesh) {
  SurfaceRegions regions = findSurfaceRegions(welded(mesh));
  std::stable_sort(regions.cylinders.begin(), regions.cylinders.end(),
                   [](const auto& a, const auto& b) { return a.high - a.low > b.high - b.low; });
  std::vector<Vector3> directions;
  for (const CylinderRegion& cylinder : regions.cylinders) {
    const auto isAlong = [&](const Vector3& one) { return one.cross(cylinder.direction).norm() < kNearAxisSine; };
    if (directions.size() < kMostDirections && std::none_of(directions.begin(), directions.end(), isAlong)) {
      directions.push_back(cylinder.direction);
    }
  }
  return directions;
}

}  // namespace

std::optional<double> wrenchFlats(const TurnedShape& shape) {
  constexpr double kLeastHexagon = 0.08;  // share of the length
  constexpr double kLeastNarrow = 0.2;
  double flats = 0.0;
  double prism = 0.0;
  for (const AxialSlab& slab : shape.slabs) {
    const auto across = acrossFlats(slab.farthest, 6);
    if (!across) continue;
    flats = *across;
    prism += slab.length();
  }
  double narrow = 0.0;
  for (const AxialSlab& slab : shape.slabs) narrow += slab.outerMost() < 0.5 * flats ? slab.length() : 0.0;
  const bool isCollar = prism >= kLeastHexagon * shape.length() && narrow >= kLeastNarrow * shape.length();
  return isCollar ? std::optional(flats) : std::nullopt;
}

bool hasCapHead(const TurnedShape& shape, double diameter) {
  constexpr double kLeastHeight = 0.88;
  constexpr double kMostHeight = 1.12;
  constexpr double kLeastRadius = 0.7;
  constexpr double kMostRadius = 1.0;
  if (shape.kind != TurnedKind::Screw || shape.recess > 0.0 || shape.sides != 0) return false;
  const double height = (shape.high - shape.headLow) / diameter;
  const double radius = shape.outer / diameter;
  return height >= kLeastHeight && height <= kMostHeight && radius >= kLeastRadius && radius <= kMostRadius;
}

bool hasTeeth(const TurnedShape& shape) {
  constexpr int kFewestTeeth = 5;
  constexpr double kLeastDepth = 0.02;  // of the radius
  constexpr double kLeastShare = 0.3;   // of the length of the shaft
  double toothed = 0.0;
  for (const AxialSlab& slab : shape.slabs) {
    if (slab.high > shape.headLow) break;
    const double most = slab.outerMost();
    const double middle = 0.5 * (most + slab.outerLeast());
    if (most - middle < 0.5 * kLeastDepth * most) continue;
    int teeth = 0;
    for (std::size_t i = 0; i < slab.farthest.size(); ++i) {
      const double next = slab.farthest[(i + 1) % slab.farthest.size()];
      teeth += slab.farthest[i] < middle && next >= middle ? 1 : 0;
    }
    toothed += teeth >= kFewestTeeth ? slab.length() : 0.0;
  }
  return toothed >= kLeastShare * (shape.headLow - shape.low);
}

std::optional<TurnedShape> turnedShapeOf(const TriangleMesh& mesh, const AxialMesh& axial) {
  const MainAxes axes = mainAxesOf(axial.tree());
  std::vector<TurnedShape> round;
  const auto known = [&](const Vector3& direction) -> std::optional<TurnedShape> {
    auto about = roundAbout(mesh, axial, {axes.centre, direction});
    if (!about) return std::nullopt;
    round.push_back(std::move(*about));
    return classified(round.back());
  };
  for (const Vector3& direction : axes.directions) {
    if (auto shape = known(direction)) return shape;
  }
  const bool isSmall = mesh.triangles.size() <= kMostTriangles;
  const bool isCompact = axes.share >= kCompactShare;
  for (const Vector3& direction : isCompact&& isSmall ? cylinderDirections(mesh) : std::vector<Vector3>()) {
    if (auto shape = known(direction)) return shape;
  }
  for (const TurnedShape& shape : round) {
    if (auto grooved = classifiedWithoutGrooves(shape)) return grooved;
  }
  return std::nullopt;
}

}  // namespace glissade
