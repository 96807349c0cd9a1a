#include "widgets/scene3d/scene_pick.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace glissade {
namespace {

/// Distance along the ray to a triangle (Moller and Trumbore 1997); nothing if it misses.
std::optional<double> hit(const Ray& ray, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 e1 = b - a;
  const Vector3 e2 = c - a;
  const Vector3 p = ray.direction.cross(e2);
  const double determinant = e1.dot(p);
  if (std::abs(determinant) < 1e-15) return std::nullopt;
  const Vector3 s = ray.origin - a;
  const double u = s.dot(p) / determinant;
  if (u < 0.0 || u > 1.0) return std::nullopt;
  const Vector3 q = s.cross(e1);
  const double v = ray.direction.dot(q) / determinant;
  if (v < 0.0 || u + v > 1.0) return std::nullopt;
  const double t = e2.dot(q) / determinant;
  return t > 0.0 ? std::optional<double>(t) : std::nullopt;
}

/// Distance along the ray to a box, 0 from inside; nothing if it misses.
std::optional<double> hit(const Ray& ray, const Box3& box) {
  double from = 0.0;
  double to = HUGE_VAL;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / ray.direction[axis];
    const double a = (box.min()[axis] - ray.origin[axis]) * inverse;
    const double b = (box.max()[axis] - ray.origin[axis]) * inverse;
    from = std::fmax(from, std::fmin(a, b));  // fmax and fmin ignore 0/0
    to = std::fmin(to, std::fmax(a, b));
  }
  return from <= to ? std::optional<double>(from) : std::nullopt;
}

bool isCutAway(const Vector3& p_W, const std::vector<Plane>& sections) {
  return std::any_of(sections.begin(), sections.end(),
                     [&](const Plane& section) { return section.normal.dot(p_W) > section.offset; });
}

/// The boxes of meshes in their own frames. Each is computed once, because many bodies share a mesh.
class MeshBoxes {
 public:
  const Box3& of(const MeshPtr& mesh) {
    const auto [entry, isNew] = boxes_.try_emplace(mesh.get());
    if (isNew) entry->second = boundingBox(*mesh);
    return entry->second;
  }

 private:
  std::map<const TriangleMesh*, Box3> boxes_;
};

}  // namespace

Ray rayThrough(const CameraController& camera, double x, double y) {
  const Eigen::Vector2d shift = camera.shift();
  if (camera.isOrthographic()) {
    // The ray begins at the near plane, which may lie behind the eye.
    const double depth = camera.nearPlane();
    const Vector3 origin_V((x - depth * shift.x()) * camera.viewHeight(),
                           (-y - depth * shift.y()) * camera.viewHeight(), -depth);
    const Vector3 direction_V(-shift.x() * camera.viewHeight(), -shift.y() * camera.viewHeight(), -1.0);
    return {camera.eye() + camera.R_WV() * origin_V, camera.R_WV() * direction_V.normalized()};
  }
  const double scale = 2.0 * std::tan(camera.verticalFieldOfView() / 2.0) / camera.magnification();
  const Vector3 direction_V((x - shift.x()) * scale, (-y - shift.y()) * scale, -1.0);
  return {camera.eye(), camera.R_WV() * direction_V.normalized()};
}

std::optional<BodyHit> pickBody(const std::vector<RigidBody>& bodies, const Ray& ray, const std::set<BodyId>& hidden,
                                const std::vector<Plane>& sections) {
  std::optional<BodyHit> nearest;
  MeshBoxes boxes;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (hidden.count(bodies[i].id) != 0) continue;
    const Pose X_BW = inverse(bodies[i].X_WB);
    const Ray ray_B{X_BW * ray.origin, X_BW.orientation * ray.direction};
    const auto box = hit(ray_B, boxes.of(bodies[i].mesh));
    if (!box || (nearest && *box > nearest->distance)) continue;
    const TriangleMesh& mesh = *bodies[i].mesh;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
      const auto& [a, b, c] = mesh.triangles[triangle];
      const auto distance = hit(ray_B, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
      if (!distance || (nearest && *distance >= nearest->distance)) continue;
      if (!isCutAway(ray.origin + *distance * ray.direction, sections)) nearest = BodyHit{i, *distance, triangle};
    }
  }
  return nearest;
}

int pickPlace(const TopologicalMap& map, const Ray& ray, double farthest) {
  const Box3 box(map.grid.box(0).min(), map.grid.box(map.grid.size() - 1).max());
  const double end = std::min(farthest, (box.center() - ray.origin).norm() + box.diagonal().norm());
  const double step = 0.5 * map.grid.cellSize();
  int narrowest = kNoPlace;
  for (double t = std::max(0.0, (box.center() - ray.origin).norm() - box.diagonal().norm()); t < end; t += step) {
    const int place = map.placeAt(ray.origin + t * ray.direction);
    if (place == kNoPlace) continue;
    const auto width = [&](int p) { return map.places[static_cast<std::size_t>(p)].narrowness; };
    if (narrowest == kNoPlace || width(place) < width(narrowest)) narrowest = place;
  }
  return narrowest;
}

}  // namespace glissade
