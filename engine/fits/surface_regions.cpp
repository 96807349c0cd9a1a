#include "engine/fits/surface_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "engine/fits/cylinder_fit.h"
#include "engine/geometry/mesh_volume.h"
#include "engine/geometry/surface_deviation.h"

namespace glissade {
namespace {

using Kind = SurfaceRegions::Kind;

/// Largest distance of vertices from a fitted surface, metres and share of the mesh's diagonal: exporters approximate
/// edges, and write single precision.
constexpr double kOffSurface = 2e-6;
constexpr double kOffSurfaceShare = 1e-7;
/// Cosine between facets of one smooth surface, which has at least ten facets a turn.
constexpr double kSmoothCosine = 0.809;
/// Number of triangles to which a cylinder is first fitted.
constexpr std::size_t kPatch = 8;
/// Largest cosine between the normals of a cylinder's facets and its axis.
constexpr double kAlongAxis = 0.3;
/// Least number of facet directions of a cylinder.
constexpr std::size_t kFewestFacets = 3;
/// Cosine between the normals of triangles in one plane.
constexpr double kFlatCosine = 0.9;
/// A flat region is a facet of a free surface if smooth edges form this share of its border, and its neighbours over
/// them are not much smaller.
constexpr double kSmoothBorder = 0.6;
constexpr double kFacetSize = 3.0;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Direction outwards: from the axis of a cone across it, from a sphere's centre, or from the nearest point of a
/// torus's circle.
Vector3 outwardsAt(const SurfaceFace& surface, const Vector3& p) {
  const Vector3 from = p - surface.point;
  if (surface.kind == SurfaceFace::Kind::Sphere) return from;
  const Vector3 across = (from - from.dot(surface.axis) * surface.axis).stableNormalized();
  if (surface.kind == SurfaceFace::Kind::Torus) return from - surface.radius * across;
  return std::cos(surface.second) * across - std::sin(surface.second) * surface.axis;
}

class RegionFinder {
 public:
  explicit RegionFinder(const TriangleMesh& mesh) : mesh_(mesh) {
    const double diagonal = mesh.vertices.empty() ? 0.0 : boundingBox(mesh).diagonal().norm();
    tolerance_ = std::min(kOffSurface, 1e-4 * diagonal) + kOffSurfaceShare * diagonal;
    result_.labels.resize(mesh.triangles.size());
    curved_.assign(mesh.triangles.size(), false);
    measure();
    connect();
    if (closed_ && signedVolume(mesh_) < 0.0) {
      for (Vector3& normal : normals_) normal = -normal;
    }
  }

  SurfaceRegions find() {
    takeStatedFaces();
    findCylinders();
    findPlanes();
    return std::move(result_);
  }

 private:
  void measure() {
    for (const auto& [a, b, c] : mesh_.triangles) {
      const Vector3 across = (mesh_.vertices[b] - mesh_.vertices[a]).cross(mesh_.vertices[c] - mesh_.vertices[a]);
      areas_.push_back(0.5 * across.norm());
      normals_.push_back(across.stableNormalized());
    }
  }

  /// Finds the triangle across each edge; none if the edge does not have exactly two.
  void connect() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::uint32_t, int>>> uses;
    neighbours_.assign(mesh_.triangles.size(), {kNone, kNone, kNone});
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) uses[std::minmax(corner(t, i), corner(t, (i + 1) % 3))].push_back({t, i});
    }
    for (const auto& [edge, users] : uses) {
      closed_ = closed_ && users.size() == 2;
      if (users.size() != 2) continue;
      neighbours_[users[0].first][static_cast<std::size_t>(users[0].second)] = users[1].first;
      neighbours_[users[1].first][static_cast<std::size_t>(users[1].second)] = users[0].first;
    }
  }

  std::uint32_t corner(std::uint32_t t, int i) const { return mesh_.triangles[t][static_cast<std::size_t>(i)]; }
  const Vector3& vertex(std::uint32_t t, int i) const { return mesh_.vertices[corner(t, i)]; }
  bool isFree(std::uint32_t t) const { return result_.labels[t].kind == Kind::Free && !curved_[t]; }
  bool isSmooth(std::uint32_t a, std::uint32_t b) const { return normals_[a].dot(normals_[b]) > kSmoothCosine; }

  /// Triangles that are reached from the seed over edges that `accept` permits (from, to).
  template <class Accept>
  std::vector<std::uint32_t> grow(std::uint32_t seed, std::size_t most, const Accept& accept) {
    ++visit_;
    visited_.resize(mesh_.triangles.size(), 0);
    std::vector<std::uint32_t> region{seed};
    visited_[seed] = visit_;
    for (std::size_t i = 0; i < region.size() && region.size() < most; ++i) {
      for (const std::uint32_t next : neighbours_[region[i]]) {
        if (next == kNone || visited_[next] == visit_ || !isFree(next) || !accept(region[i], next)) continue;
        visited_[next] = visit_;
        region.push_back(next);
        if (region.size() == most) break;
      }
    }
    return region;
  }

  std::vector<Vector3> verticesOf(const std::vector<std::uint32_t>& region) const {
    std::vector<std::uint32_t> indices;
    for (const std::uint32_t t : region)
      indices.insert(indices.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    std::vector<Vector3> points;
    for (const std::uint32_t index : indices) points.push_back(mesh_.vertices[index]);
    return points;
  }

  std::vector<Vector3> normalsOf(const std::vector<std::uint32_t>& region) const {
    std::vector<Vector3> normals;
    for (const std::uint32_t t : region) normals.push_back(normals_[t]);
    return normals;
  }

  const SurfaceFace& faceOf(std::uint32_t t) const { return mesh_.faces[mesh_.faceOf[t]]; }

  void takeStatedFaces() {
    if (mesh_.faces.empty()) return;
    for (std::uint32_t seed = 0; seed < mesh_.triangles.size(); ++seed) {
      if (isFree(seed) && areas_[seed] > 0.0 && isStatedRound(seed)) addStatedRound(seed);
    }
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) curved_[t] = isFree(t) && isStatedRound(t);
    for (std::uint32_t seed = 0; seed < mesh_.triangles.size(); ++seed) {
      if (!isFree(seed) || areas_[seed] <= 0.0) continue;
      if (faceOf(seed).kind == SurfaceFace::Kind::Plane) addStatedPlane(seed);
      if (faceOf(seed).kind == SurfaceFace::Kind::Cylinder) addStatedCylinder(seed);
    }
  }

  bool isStatedRound(std::uint32_t t) const {
    using Stated = SurfaceFace::Kind;
    const Stated kind = faceOf(t).kind;
    return kind == Stated::Cone || kind == Stated::Sphere || kind == Stated::Torus;
  }

  /// Adds the stated round surface of the seed, with neighbouring faces of the same surface.
  void addStatedRound(std::uint32_t seed) {
    const SurfaceFace& surface = faceOf(seed);
    if (!isOnStated(seed)) return;
    const bool shaft = isOutside(surface, seed);
    const auto region = grow(seed, mesh_.triangles.size(), [&](std::uint32_t, std::uint32_t t) {
      return isSameSurface(surface, t) && isOnStated(t) && isOutside(surface, t) == shaft;
    });
    RoundRegion round{surface, shaft, std::numeric_limits<double>::infinity()};
    round.high = -round.low;
    for (const std::uint32_t t : region) {
      for (int i = 0; i < 3; ++i) {
        const double height = (vertex(t, i) - surface.point).dot(surface.axis);
        round.low = std::min(round.low, height);
        round.high = std::max(round.high, height);
      }
      round.sagitta = std::max(round.sagitta, faceOf(t).deflection);
      result_.labels[t] = {Kind::Round, static_cast<std::uint32_t>(result_.rounds.size())};
    }
    result_.rounds.push_back(round);
  }

  /// True if the vertices are on the stated surface of the triangle's face.
  bool isOnStated(std::uint32_t t) const {
    const SurfaceFace& surface = faceOf(t);
    const double off = offStated(surface);
    for (int i = 0; i < 3; ++i) {
      if (std::abs(signedDistance(surface, vertex(t, i))) > off) return false;
    }
    return true;
  }

  /// True if the triangle's face is stated to be of the surface, or of one that does not differ from it there.
  bool isSameSurface(const SurfaceFace& surface, std::uint32_t t) const {
    const SurfaceFace& other = faceOf(t);
    if (&other == &surface) return true;
    if (other.kind != surface.kind) return false;
    for (int i = 0; i < 3; ++i) {
      const double difference = signedDistance(surface, vertex(t, i)) - signedDistance(other, vertex(t, i));
      if (std::abs(difference) > tolerance_) return false;
    }
    return true;
  }

  /// True if the material of the triangle is on the inner side of the surface.
  bool isOutside(const SurfaceFace& surface, std::uint32_t t) const {
    return normals_[t].dot(outwardsAt(surface, (vertex(t, 0) + vertex(t, 1) + vertex(t, 2)) / 3.0)) > 0.0;
  }

  /// Largest distance of a face's vertices from its stated surface, metres.
  double offStated(const SurfaceFace& face) const { return std::max(tolerance_, face.deflection); }

  /// True if the vertices are within `off` of the plane, and the triangle faces the same way. The normal of a sliver
  /// beside a larger triangle, the seed, is unreliable: its vertices decide.
  bool isInPlane(std::uint32_t t, std::uint32_t seed, const PlaneRegion& plane, double off) const {
    for (int i = 0; i < 3; ++i) {
      if (std::abs(plane.normal.dot(vertex(t, i)) - plane.offset) > off) return false;
    }
    return normals_[t].dot(plane.normal) > kFlatCosine || areas_[t] < 1e-6 * areas_[seed];
  }

  /// Adds the stated plane of the seed, with neighbouring faces in the same plane.
  void addStatedPlane(std::uint32_t seed) {
    const SurfaceFace& face = faceOf(seed);
    Vector3 normal = face.axis.normalized();
    if (normal.dot(normals_[seed]) < 0.0) normal = -normal;
    const double offset = normal.dot(face.point);
    const double off = offStated(face);
    if (!isInPlane(seed, seed, {normal, offset}, off)) return;
    const auto region = grow(seed, mesh_.triangles.size(), [&](std::uint32_t, std::uint32_t t) {
      return faceOf(t).kind == SurfaceFace::Kind::Plane && isInPlane(t, seed, {normal, offset}, off);
    });
    addPlane(region, {normal, offset});
  }

  void addPlane(const std::vector<std::uint32_t>& region, const PlaneRegion& plane) {
    for (const std::uint32_t t : region) {
      result_.labels[t] = {Kind::Plane, static_cast<std::uint32_t>(result_.planes.size())};
    }
    result_.planes.push_back(plane);
  }

  /// Adds the stated cylinder of the seed, with neighbouring faces of the same cylinder.
  void addStatedCylinder(std::uint32_t seed) {
    const SurfaceFace& face = faceOf(seed);
    const FittedCylinder stated{face.point, face.axis.normalized(), face.radius};
    const double off = offStated(face);
    const auto isOnIt = [&](std::uint32_t t) {
      for (int i = 0; i < 3; ++i) {
        if (std::abs(stated.distanceFromAxis(vertex(t, i)) - stated.radius) > off) return false;
      }
      return true;
    };
    if (!isOnIt(seed)) return;
    const bool shaft = isShaft(stated, seed);
    const auto region = grow(seed, mesh_.triangles.size(), [&](std::uint32_t, std::uint32_t t) {
      return faceOf(t).kind == SurfaceFace::Kind::Cylinder && isOnIt(t) && isShaft(stated, t) == shaft;
    });
    addCylinder(region, stated, shaft);
  }

  void findCylinders() {
    for (std::uint32_t seed = 0; seed < mesh_.triangles.size(); ++seed) {
      if (!isFree(seed) || areas_[seed] <= 0.0) continue;
      const auto patch =
          grow(seed, kPatch, [&](std::uint32_t a, std::uint32_t b) { return areas_[b] > 0.0 && isSmooth(a, b); });
      if (patch.size() < 4) continue;
      const auto first = fitCylinder(verticesOf(patch), normalsOf(patch), tolerance_);
      if (first) addFittedCylinder(seed, *first);
    }
  }

  bool isOn(const FittedCylinder& cylinder, std::uint32_t t) const {
    if (std::abs(normals_[t].dot(cylinder.direction)) > kAlongAxis) return false;
    for (int i = 0; i < 3; ++i) {
      if (std::abs(cylinder.distanceFromAxis(vertex(t, i)) - cylinder.radius) > tolerance_) return false;
    }
    return true;
  }

  void addFittedCylinder(std::uint32_t seed, const FittedCylinder& first) {
    if (!isOn(first, seed)) return;
    const auto accept = [&](std::uint32_t a, std::uint32_t b) { return isSmooth(a, b) && isOn(first, b); };
    const auto region = grow(seed, mesh_.triangles.size(), accept);
    if (facetsOf(region) < kFewestFacets) return;
    const auto fitted = fitCylinder(verticesOf(region), normalsOf(region), tolerance_);
    if (fitted) addCylinder(region, *fitted, isShaft(*fitted, seed));
  }

  void addCylinder(const std::vector<std::uint32_t>& region, const FittedCylinder& surface, bool shaft) {
    CylinderRegion cylinder{surface.point, surface.direction, surface.radius, shaft};
    cylinder.low = std::numeric_limits<double>::infinity();
    cylinder.high = -cylinder.low;
    for (const std::uint32_t t : region) {
      for (int i = 0; i < 3; ++i) {
        const double height = (vertex(t, i) - surface.point).dot(surface.direction);
        cylinder.low = std::min(cylinder.low, height);
        cylinder.high = std::max(cylinder.high, height);
        const Vector3 middle = 0.5 * (vertex(t, i) + vertex(t, (i + 1) % 3));
        cylinder.sagitta = std::max(cylinder.sagitta, surface.radius - surface.distanceFromAxis(middle));
      }
      result_.labels[t] = {Kind::Cylinder, static_cast<std::uint32_t>(result_.cylinders.size())};
    }
    result_.cylinders.push_back(cylinder);
  }

  std::size_t facetsOf(const std::vector<std::uint32_t>& region) const {
    std::vector<Vector3> directions;
    for (const std::uint32_t t : region) {
      const bool known = std::any_of(directions.begin(), directions.end(),
                                     [&](const Vector3& d) { return d.dot(normals_[t]) > 0.9999; });
      if (!known) directions.push_back(normals_[t]);
      if (directions.size() >= kFewestFacets) break;
    }
    return directions.size();
  }

  bool isShaft(const FittedCylinder& cylinder, std::uint32_t t) const {
    const Vector3 from = (vertex(t, 0) + vertex(t, 1) + vertex(t, 2)) / 3.0 - cylinder.point;
    return normals_[t].dot(from - from.dot(cylinder.direction) * cylinder.direction) > 0.0;
  }

  void findPlanes() {
    const auto first = static_cast<std::uint32_t>(result_.planes.size());  // after the stated planes
    std::vector<std::uint32_t> seeds(mesh_.triangles.size());
    std::iota(seeds.begin(), seeds.end(), 0U);
    std::stable_sort(seeds.begin(), seeds.end(), [&](auto a, auto b) { return areas_[a] > areas_[b]; });
    std::vector<std::vector<std::uint32_t>> regions;
    for (const std::uint32_t seed : seeds) {
      if (!isFree(seed) || areas_[seed] <= 0.0) continue;
      const Vector3 normal = normals_[seed];
      const double offset = normal.dot(vertex(seed, 0));
      const auto region = grow(seed, mesh_.triangles.size(), [&](std::uint32_t, std::uint32_t t) {
        return isInPlane(t, seed, {normal, offset}, tolerance_);
      });
      addPlane(region, {normal, offset});
      regions.push_back(region);
    }
    freeFacets(regions, first);
  }

  /// Removes planes that are facets of a free surface. `first`: the number of the first region's plane.
  void freeFacets(const std::vector<std::vector<std::uint32_t>>& regions, std::uint32_t first) {
    std::vector<double> area(result_.planes.size(), 0.0);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (result_.labels[t].kind == Kind::Plane) area[result_.labels[t].index] += areas_[t];
    }
    std::vector<std::size_t> facets;
    for (std::size_t r = 0; r < regions.size(); ++r) {
      if (isFacet(regions[r], first + r, area)) facets.push_back(r);
    }
    for (const std::size_t r : facets) {
      for (const std::uint32_t t : regions[r]) result_.labels[t] = {};
    }
  }

  bool isFacet(const std::vector<std::uint32_t>& region, std::size_t r, const std::vector<double>& area) const {
    double border = 0.0;
    double smooth = 0.0;
    double areaAcross = 0.0;
    for (const std::uint32_t t : region) {
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t next = neighbours_[t][static_cast<std::size_t>(i)];
        const SurfaceRegions::Label across = next == kNone ? SurfaceRegions::Label{} : result_.labels[next];
        if (next != kNone && across.kind == Kind::Plane && across.index == r) continue;
        const double length = (vertex(t, i) - vertex(t, (i + 1) % 3)).norm();
        border += length;
        if (next == kNone || across.kind != Kind::Plane || !isSmooth(t, next)) continue;
        smooth += length;
        areaAcross += length * area[across.index];
      }
    }
    return smooth > kSmoothBorder * border && area[r] * smooth <= kFacetSize * areaAcross;
  }

  const TriangleMesh& mesh_;
  double tolerance_ = 0.0;
  std::vector<double> areas_;
  std::vector<Vector3> normals_;
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  std::vector<bool> curved_;  ///< for each triangle: its stated round face contradicts it
  bool closed_ = true;        ///< every edge has two triangles
  std::vector<std::uint32_t> visited_;
  std::uint32_t visit_ = 0;
  SurfaceRegions result_;
};

}  // namespace

SurfaceRegions findSurfaceRegions(const TriangleMesh& mesh) { return RegionFinder(mesh).find(); }

double coneRadiusAt(const SurfaceFace& cone, double height) { return cone.radius + std::tan(cone.second) * height; }

SurfaceRegions transformed(SurfaceRegions regions, const Pose& X_WB) {
  const auto rotated = [&](const Vector3& v) -> Vector3 { return X_WB.orientation * v; };
  for (PlaneRegion& plane : regions.planes) {
    plane.normal = rotated(plane.normal);
    plane.offset += plane.normal.dot(X_WB.position);
  }
  for (CylinderRegion& cylinder : regions.cylinders) {
    cylinder.point = X_WB * cylinder.point;
    cylinder.direction = rotated(cylinder.direction);
  }
  for (RoundRegion& round : regions.rounds) round.surface = transformed(round.surface, X_WB);
  return regions;
}

}  // namespace glissade
