#include "engine/places/changed_boxes.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace glissade {
namespace {

/// An edge of a face that slides in the plane where coordinate `axis` is `value`.
struct FaceEdge {
  int axis;
  double value;
  std::uint32_t from;  ///< the lesser vertex
  std::uint32_t to;
  int side;  ///< side of the edge on which the face's triangle lies: -1 or 1

  auto key() const { return std::tie(axis, value, from, to); }
};

class Motion {
 public:
  Motion(const TriangleMesh& before_W, const TriangleMesh& after_W) : before_(before_W), after_(after_W) {}

  template <std::size_t N>
  Box3 box(const std::array<std::uint32_t, N>& vertices) const {
    Box3 box;
    for (const std::uint32_t v : vertices) box.extend(before_.vertices[v]).extend(after_.vertices[v]);
    return box;
  }

  /// Twice the signed area of a triangle before the motion, seen along an axis.
  double turn(const std::array<std::uint32_t, 3>& triangle, int axis) const {
    const Vector3& a = before_.vertices[triangle[0]];
    return (before_.vertices[triangle[1]] - a).cross(before_.vertices[triangle[2]] - a)[axis];
  }

 private:
  const TriangleMesh& before_;
  const TriangleMesh& after_;
};

/// The axis across which the contents of the box lie in one plane.
std::optional<int> axisAcross(const Box3& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (box.sizes()[axis] == 0.0) return axis;
  }
  return std::nullopt;
}

bool isAlongAnAxis(const Box3& box) { return (box.sizes().array() == 0.0).count() >= 2; }

void addEdges(const Motion& motion, const TriangleMesh& mesh_W, const TriangleIndices& triangle, int axis,
              std::vector<FaceEdge>& edges) {
  const double turn = motion.turn(triangle, axis);
  if (turn == 0.0) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = triangle[i];
    const std::uint32_t b = triangle[(i + 1) % 3];
    edges.push_back({axis, mesh_W.vertices[a][axis], std::min(a, b), std::max(a, b), (a < b) == (turn > 0.0) ? 1 : -1});
  }
}

/// Adds boxes around the rim of a face, which consists of the edges with triangles on one side only. An edge that
/// slides along itself changes the face only at its ends, which the rest of the rim covers.
void addRims(const Motion& motion, std::vector<FaceEdge> edges, std::vector<Box3>& boxes) {
  std::sort(edges.begin(), edges.end(), [](const FaceEdge& a, const FaceEdge& b) { return a.key() < b.key(); });
  for (auto edge = edges.begin(); edge != edges.end();) {
    int sides = 0;
    auto next = edge;
    for (; next != edges.end() && next->key() == edge->key(); ++next) sides += next->side;
    const Box3 box = motion.box(std::array<std::uint32_t, 2>{edge->from, edge->to});
    if (sides != 0 && !isAlongAnAxis(box)) boxes.push_back(box);
    edge = next;
  }
}

}  // namespace

std::vector<Box3> changedBoxes(const TriangleMesh& before_W, const TriangleMesh& after_W) {
  const Motion motion(before_W, after_W);
  std::vector<Box3> boxes;
  std::vector<FaceEdge> edges;
  for (const TriangleIndices& triangle : before_W.triangles) {
    const Box3 box = motion.box(triangle);
    if (const auto axis = axisAcross(box)) {
      addEdges(motion, before_W, triangle, *axis, edges);
    } else {
      boxes.push_back(box);
    }
  }
  addRims(motion, std::move(edges), boxes);
  return boxes;
}

}  // namespace glissade
