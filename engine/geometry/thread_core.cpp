#include "engine/geometry/thread_core.h"

#include <algorithm>

#include "engine/geometry/continued_cones.h"

namespace glissade {
namespace {

constexpr double kStrip = 2.0 / 3.0;

std::vector<bool> cornersOf(const TriangleMesh& mesh, const std::vector<bool>& triangles) {
  std::vector<bool> isCorner(mesh.vertices.size(), false);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!triangles[t]) continue;
    for (const std::uint32_t vertex : mesh.triangles[t]) isCorner[vertex] = true;
  }
  return isCorner;
}

/// Adds the triangles of faces that are strips between those of the thread, where they are `near` enough to it.
void addStrips(const TriangleMesh& mesh, const std::vector<bool>& near, std::vector<bool>& ofThread) {
  const std::vector<bool> isCorner = cornersOf(mesh, ofThread);
  std::vector<double> between(mesh.faces.size(), 0.0);
  std::vector<double> all(mesh.faces.size(), 0.0);
  for (std::size_t t = 0; t < mesh.faceOf.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    all[mesh.faceOf[t]] += 1.0;
    if (isCorner[a] && isCorner[b] && isCorner[c]) between[mesh.faceOf[t]] += 1.0;
  }
  for (std::size_t t = 0; t < mesh.faceOf.size(); ++t) {
    const std::uint32_t face = mesh.faceOf[t];
    if (near[t] && between[face] >= kStrip * all[face]) ofThread[t] = true;
  }
}

}  // namespace

std::vector<bool> trianglesOfThread(const TriangleMesh& mesh, const std::vector<double>& allowances,
                                    const ThreadCore& core) {
  std::vector<double> distances;
  for (const Vector3& vertex : mesh.vertices) distances.push_back(core.distanceOf(vertex));
  const double most = *std::max_element(allowances.begin(), allowances.end());
  std::vector<bool> near;
  std::vector<bool> ofThread;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    near.push_back(std::max({distances[a], distances[b], distances[c]}) <= core.radius + most);
    ofThread.push_back(near.back() && allowances[t] > 0.0);
  }
  addStrips(mesh, near, ofThread);
  return ofThread;
}

void moveOntoCore(const TriangleMesh& mesh, const std::vector<bool>& ofThread, const ThreadCore& core,
                  std::vector<Vector3>& moves) {
  std::vector<bool> isTaken = cornersOf(mesh, ofThread);
  std::vector<bool> isCrest(mesh.faces.size(), false);
  for (std::size_t t = 0; t < mesh.faceOf.size(); ++t) isCrest[mesh.faceOf[t]] = isCrest[mesh.faceOf[t]] || ofThread[t];
  for (const ConeVertex& chamfer : coneVertices(mesh)) {
    if (isCrest[chamfer.cylinder]) isTaken[chamfer.vertex] = true;
  }
  for (std::size_t i = 0; i < isTaken.size(); ++i) {
    const Vector3 arm = mesh.vertices[i] - core.point;
    const Vector3 across = arm - arm.dot(core.direction) * core.direction;
    const double distance = across.norm();
    if (isTaken[i] && distance > core.radius) moves[i] -= (1.0 - core.radius / distance) * across;
  }
}

}  // namespace glissade
