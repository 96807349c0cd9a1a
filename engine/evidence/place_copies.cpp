#include "engine/evidence/place_copies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade::evidence {
namespace {

/// Least distance of two surfaces that are apart, metres.
constexpr double kLeastApart = 1e-6;
/// Largest difference of the volumes of copies, as a share.
constexpr double kSameVolume = 0.01;
/// Largest tolerance, as a share of the mean thickness (twice the volume for the area): two sheets that lie on each
/// other are not in one place.
constexpr double kThin = 0.1;

double largestDeflectionOf(const Body& body) {
  double largest = body.mesh->faces.empty() ? body.deflection : 0.0;
  for (const SurfaceFace& face : body.mesh->faces) largest = std::max(largest, face.deflection);
  return largest;
}

double surfaceAreaOf(const TriangleTree& surface) {
  double area = 0.0;
  for (const Triangle& t : surface.triangles()) area += 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
  return area;
}

/// A placed body whose surface is closed.
struct ClosedBody {
  ClosedBody(const TriangleMesh& mesh_W, double volume_)
      : surface(mesh_W), volume(volume_), thickness(2.0 * volume / surfaceAreaOf(surface)) {}

  TriangleTree surface;
  double volume;
  double thickness;  ///< mean thickness, metres
};

/// True if the corners and middles of all triangles are on the surface.
bool liesOn(const TriangleTree& surface, const TriangleTree& body, double tolerance) {
  const double limit = 2.0 * tolerance;
  const auto isOn = [&](const Vector3& p) { return surface.nearest(p, limit, tolerance).distance <= tolerance; };
  return std::all_of(body.triangles().begin(), body.triangles().end(), [&](const Triangle& t) {
    return isOn((t[0] + t[1] + t[2]) / 3.0) && std::all_of(t.begin(), t.end(), isOn);
  });
}

class CopyFinder {
 public:
  CopyFinder(const std::vector<Body>& bodies, const StopToken& stop) : bodies_(bodies), stop_(stop) {
    for (const Body& body : bodies) {
      boxes_.push_back(boundingBox(*body.mesh, body.X_WB));
      deflections_.push_back(largestDeflectionOf(body));
    }
  }

  std::vector<PlaceCopies> find(const std::vector<BodyId>& named) {
    const std::set<BodyId> kept(named.begin(), named.end());
    std::vector<bool> isCopy(bodies_.size(), false);
    std::vector<PlaceCopies> places;
    for (std::size_t body = 0; body < bodies_.size() && !stop_.stopRequested(); ++body) {
      if (isCopy[body]) continue;
      PlaceCopies place{body};
      for (std::size_t other = body + 1; other < bodies_.size(); ++other) {
        if (isCopy[other] || kept.count(bodies_[other].id) > 0 || !areOnePlace(body, other)) continue;
        isCopy[other] = true;
        place.copies.push_back(other);
      }
      if (!place.copies.empty()) places.push_back(std::move(place));
    }
    return places;
  }

 private:
  bool areOnePlace(std::size_t one, std::size_t other) {
    const double tolerance = deflections_[one] + deflections_[other] + kLeastApart;
    const auto isNear = [&](const Vector3& a, const Vector3& b) { return (a - b).cwiseAbs().maxCoeff() <= tolerance; };
    if (!isNear(boxes_[one].min(), boxes_[other].min()) || !isNear(boxes_[one].max(), boxes_[other].max())) {
      return false;
    }
    const ClosedBody* a = closed(one);
    const ClosedBody* b = a == nullptr ? nullptr : closed(other);
    if (b == nullptr || std::abs(a->volume - b->volume) > kSameVolume * a->volume) return false;
    return tolerance <= kThin * a->thickness && liesOn(a->surface, b->surface, tolerance) &&
           liesOn(b->surface, a->surface, tolerance);
  }

  /// Null if the surface is not closed.
  const ClosedBody* closed(std::size_t body) {
    const auto [known, isNew] = closed_.try_emplace(body);
    if (isNew) {
      const MeshAudit facts = audit(*bodies_[body].mesh);
      if (facts.closed() && facts.volume != 0.0) {
        known->second.emplace(transformed(*bodies_[body].mesh, bodies_[body].X_WB), std::abs(facts.volume));
      }
    }
    return known->second ? &*known->second : nullptr;
  }

  const std::vector<Body>& bodies_;
  const StopToken& stop_;
  std::vector<Box3> boxes_;
  std::vector<double> deflections_;
  std::map<std::size_t, std::optional<ClosedBody>> closed_;
};

}  // namespace

std::vector<PlaceCopies> placeCopiesIn(const std::vector<Body>& bodies, const std::vector<BodyId>& named,
                                       const StopToken& stop) {
  return CopyFinder(bodies, stop).find(named);
}

std::vector<bool> areCopies(const std::vector<PlaceCopies>& places, std::size_t bodies) {
  std::vector<bool> are(bodies, false);
  for (const PlaceCopies& place : places) {
    for (const std::size_t copy : place.copies) are[copy] = true;
  }
  return are;
}

Warnings warningsOf(const std::vector<PlaceCopies>& places, const std::vector<Body>& bodies) {
  Warnings warnings;
  for (const PlaceCopies& place : places) {
    std::vector<Message> names;
    for (const std::size_t copy : place.copies) names.emplace_back(bodies[copy].name);
    warnings.push_back({ErrorKind::MalformedInput,
                        "",
                        {GLISSADE_TEXT("'%1'"), {bodies[place.body].name}},
                        {GLISSADE_TEXT("is drawn %1 times in one place, and stands for: %2"),
                         {place.copies.size() + 1, joined(names, ", ")}},
                        GLISSADE_TEXT("Delete the copies in the CAD program.")});
  }
  return warnings;
}

}  // namespace glissade::evidence
