#include "engine/planning/automatic/contact_faces.h"

#include <algorithm>

namespace glissade {
namespace {

constexpr double kSameDirection = 0.9999;  // cosine of the largest angle between normals that count as equal
/// Most directions kept while areas are added up. More directions than a few belong to round surfaces, which are of no
/// use here.
constexpr std::size_t kMostDirections = 64;

}  // namespace

std::vector<Vector3> largestFaceNormals(const TriangleMesh& mesh, std::size_t count) {
  struct Direction {
    Vector3 normal;
    double area;
  };
  std::vector<Direction> directions;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vector3 cross = (mesh.vertices[j] - mesh.vertices[i]).cross(mesh.vertices[k] - mesh.vertices[i]);
    const double area = 0.5 * cross.norm();
    if (area <= 0.0) continue;
    const Vector3 normal = cross.normalized();
    const auto same = std::find_if(directions.begin(), directions.end(), [&](const Direction& direction) {
      return direction.normal.dot(normal) > kSameDirection;
    });
    if (same != directions.end()) {
      same->area += area;
    } else if (directions.size() < kMostDirections) {
      directions.push_back({normal, area});
    }
  }
  std::stable_sort(directions.begin(), directions.end(),
                   [](const Direction& a, const Direction& b) { return a.area > b.area; });
  std::vector<Vector3> normals;
  for (std::size_t i = 0; i < std::min(count, directions.size()); ++i) normals.push_back(directions[i].normal);
  return normals;
}

}  // namespace glissade
