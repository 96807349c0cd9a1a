#include "engine/evidence/face_regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "engine/geometry/vertex_welder.h"

namespace glissade::evidence {
namespace {

/// Angles, radians: 36 degrees (sharp); a tenth of a degree (one piece: single precision bends flat faces by less);
/// flat.
constexpr double kSharp = 0.6283185307179586;
constexpr double kOnePiece = 1.7453292519943296e-3;
constexpr double kFlatAngle = 1e-6;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

struct EdgeUse {
  std::uint32_t triangle;
  bool forwards;
};

std::uint32_t rootIn(std::vector<std::uint32_t>& parent, std::uint32_t at) {
  while (parent[at] != at) at = parent[at] = parent[parent[at]];
  return at;
}

struct MeshEdges {
  std::map<Edge, std::vector<EdgeUse>> uses;
  std::vector<Vector3> positions;  ///< positions of the ends
};

MeshEdges edgesOf(const TriangleMesh& mesh) {
  VertexWelder welder(mesh.vertices.size());
  std::vector<std::uint32_t> numbers;
  for (const Vector3& vertex : mesh.vertices) numbers.push_back(welder.indexOf(vertex));
  MeshEdges edges;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = numbers[mesh.triangles[t][i]];
      const std::uint32_t b = numbers[mesh.triangles[t][(i + 1) % 3]];
      if (a != b) edges.uses[std::minmax(a, b)].push_back({t, a < b});
    }
  }
  edges.positions = std::move(welder).takeVertices();
  return edges;
}

/// Sagitta of a chord across a strip of this width, if neighbouring strips are turned by the angle against each other.
double sagittaOf(double width, double angle) { return 0.5 * width * std::tan(0.25 * angle); }

void numberRegions(const TriangleMesh& mesh, std::vector<std::uint32_t>& parent, FaceRegions& regions) {
  std::map<std::uint32_t, std::uint32_t> numberOf;
  for (std::uint32_t t = 0; t < parent.size(); ++t) {
    const auto next = static_cast<std::uint32_t>(numberOf.size());
    const std::uint32_t face = mesh.faces.empty() ? rootIn(parent, t) : mesh.faceOf[t];
    regions.of.push_back(numberOf.try_emplace(face, next).first->second);
  }
  regions.count = static_cast<std::uint32_t>(numberOf.size());
}

void findNext(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& smooth, FaceRegions& regions) {
  regions.next.resize(regions.count);
  for (const auto& [one, other] : smooth) {
    const std::uint32_t a = regions.of[one];
    const std::uint32_t b = regions.of[other];
    if (a == b) continue;
    regions.next[a].push_back(b);
    regions.next[b].push_back(a);
  }
}

}  // namespace

FaceRegions faceRegionsOf(const TriangleMesh& mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  std::vector<Vector3> doubled;  // normals with the length of twice the area
  std::vector<std::uint32_t> parent(count);
  std::iota(parent.begin(), parent.end(), 0U);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3& corner = mesh.vertices[a];
    doubled.emplace_back((mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner));
  }
  FaceRegions regions;
  regions.curved.assign(count, false);
  std::vector<double> sagittas(count, 0.0);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> smooth;
  const MeshEdges edges = edgesOf(mesh);
  for (const auto& [ends, uses] : edges.uses) {
    for (std::size_t i = 0; i < uses.size(); ++i) {
      for (std::size_t k = i + 1; k < uses.size(); ++k) {
        const auto [one, forwards] = uses[i];
        const auto [other, otherForwards] = uses[k];
        const Vector3 normal = forwards == otherForwards ? Vector3(-doubled[other]) : doubled[other];
        const double angle = std::atan2(doubled[one].cross(normal).norm(), doubled[one].dot(normal));
        const bool isFlat = doubled[one].isZero(0.0) || doubled[other].isZero(0.0);
        if (!isFlat && angle >= kSharp) continue;
        if (isFlat || angle <= kOnePiece) parent[rootIn(parent, one)] = rootIn(parent, other);
        smooth.emplace_back(one, other);
        if (isFlat || angle <= kFlatAngle) continue;
        const double width = std::min(doubled[one].norm(), doubled[other].norm()) /
                             (edges.positions[ends.second] - edges.positions[ends.first]).norm();
        for (const std::uint32_t t : {one, other}) {
          regions.curved[t] = true;
          sagittas[t] = std::max(sagittas[t], sagittaOf(width, angle));
        }
      }
    }
  }
  numberRegions(mesh, parent, regions);
  findNext(smooth, regions);
  regions.sagitta.assign(regions.count, 0.0);
  for (std::uint32_t t = 0; t < count; ++t) {
    double& sagitta = regions.sagitta[regions.of[t]];
    sagitta = std::max(sagitta, sagittas[t]);
  }
  return regions;
}

}  // namespace glissade::evidence
