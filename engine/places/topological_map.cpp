#include "engine/places/topological_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {
namespace {

/// Distances from points to the surface of a mesh, for few points near each other.
class PointClearance {
 public:
  /// Keeps the triangles that come within `reach` of `about`.
  PointClearance(const TriangleMesh& mesh_W, const Vector3& about, double reach);

  /// Distance to the triangles kept, at most `reach`.
  double operator()(const Vector3& p_W) const;
  /// Goes uphill from p in ever smaller steps, at most `reach` / 2 away and not out of `within`;
  /// returns the widest spot found.
  Vector3 widestNear(const Vector3& p_W, double step, const Box3& within) const;

 private:
  std::vector<std::array<Vector3, 3>> triangles_;
  Vector3 about_;
  double reach_;
};

/// The point of a triangle nearest to p (Ericson 2005, section 5.1.5).
Vector3 nearestOnTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double scale = 1.0 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

PointClearance::PointClearance(const TriangleMesh& mesh_W, const Vector3& about, double reach)
    : about_(about), reach_(reach) {
  for (const auto& [a, b, c] : mesh_W.triangles) {
    const std::array<Vector3, 3> triangle{mesh_W.vertices[a], mesh_W.vertices[b], mesh_W.vertices[c]};
    Box3 box;
    for (const Vector3& corner : triangle) box.extend(corner);
    if (box.exteriorDistance(about) <= 1.5 * reach) triangles_.push_back(triangle);
  }
}

double PointClearance::operator()(const Vector3& p_W) const {
  double least = reach_ * reach_;
  for (const auto& [a, b, c] : triangles_) {
    least = std::min(least, (nearestOnTriangle(p_W, a, b, c) - p_W).squaredNorm());
  }
  return std::sqrt(least);
}

Vector3 PointClearance::widestNear(const Vector3& p_W, double step, const Box3& within) const {
  Vector3 best = p_W;
  double widest = (*this)(best);
  for (double s = step; s > step / 64.0;) {
    bool better = false;
    // Diagonals, too: between two walls at a right angle no axis alone leads uphill.
    for (int direction = 0; direction < 27; ++direction) {
      const Eigen::Vector3i cell(direction / 9 - 1, direction / 3 % 3 - 1, direction % 3 - 1);
      const Vector3 way = cell.cast<double>();
      const Vector3 next = best + s * way;
      if ((next - about_).norm() > reach_ / 2.0 || !within.contains(next)) continue;
      const double clearance = (*this)(next);
      if (clearance <= widest * (1.0 + 1e-9)) continue;
      widest = clearance;
      best = next;
      better = true;
    }
    if (!better) s /= 2.0;
  }
  return best;
}

std::vector<Place> gatherPlaces(const CellGrid& grid, const PlaceLabels& labels, const std::vector<double>& clearance,
                                const std::vector<Passage>& passages) {
  const int last = labels.empty() ? kNoPlace : *std::max_element(labels.begin(), labels.end());
  std::vector<Place> places(last == kNoPlace ? 0 : static_cast<std::size_t>(last) + 1);
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    if (labels[cell] == kNoPlace) continue;
    const auto label = static_cast<std::size_t>(labels[cell]);
    places[label].cells.push_back(cell);
    places[label].box.extend(grid.box(cell));
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    Place& place = places[i];
    place.volume = std::pow(grid.cellSize(), 3) * static_cast<double>(place.cells.size());
    place.passage = i < passages.size();
    if (place.passage) place.axis = passages[i].axis;
    const Vector3 middle = place.box.center();
    std::size_t widest = place.cells.front();
    for (const std::size_t cell : place.cells) {
      const double gain = clearance[cell] - clearance[widest];
      const bool nearer =
          (grid.centre(cell) - middle).squaredNorm() < (grid.centre(widest) - middle).squaredNorm() - 1e-12;
      if (gain > 1e-12 || (gain > -1e-12 && nearer)) widest = cell;
    }
    place.anchor = grid.centre(widest);
    place.narrowness = 2.0 * clearance[widest];
  }
  return places;
}

/// Measures the narrowness of a place on the static surfaces, because the clearance of cells has the error of a cell.
void measureNarrowness(const TriangleMesh& statics_W, const CellGrid& grid, Place& place) {
  const double wall = (Box3(grid.box(0).min(), grid.box(grid.size() - 1).max())).exteriorDistance(place.anchor);
  const double reach = place.narrowness / 2.0 + 2.0 * grid.cellSize() + wall;
  const PointClearance clearanceAt(statics_W, place.anchor, reach);
  Box3 within = place.box;
  // The anchor of a passage does not move along its axis, where the clearance grows; the passage is measured at its
  // narrow part.
  if (place.passage) within.min()[place.axis] = within.max()[place.axis] = place.anchor[place.axis];
  place.anchor = clearanceAt.widestNear(place.anchor, grid.cellSize() / 2.0, within);
  // Passages are measured on the surfaces alone. Rooms also end at the workspace, which the cells include.
  const double exact = 2.0 * clearanceAt(place.anchor);
  place.narrowness = std::min(exact, place.narrowness + 2.0 * grid.cellSize());
}

/// Assigns complexity levels by the paper's halving of cells, from the size of the widest cell that fits.
void rateComplexity(double side, std::vector<Place>& places) {
  const auto level = [&](const Place& place) {
    return std::max(0, static_cast<int>(std::floor(std::log2(side / std::max(place.narrowness, 1e-9 * side)) + 1e-6)));
  };
  int coarsest = std::numeric_limits<int>::max();
  for (const Place& place : places) coarsest = std::min(coarsest, level(place));
  for (Place& place : places) place.complexity = 1 + level(place) - coarsest;
}

/// The order of places: by complexity, then along x, y, z (in whole cells, so that rounding does not matter).
std::vector<std::size_t> orderOf(const CellGrid& grid, const std::vector<Place>& places) {
  std::vector<std::size_t> order(places.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Place& p = places[a];
    const Place& q = places[b];
    if (p.complexity != q.complexity) return p.complexity < q.complexity;
    if (p.passage != q.passage) return q.passage;
    const auto key = [&](const Place& place) {
      return ((place.box.center() - grid.frame.origin) / grid.cellSize()).eval();
    };
    const Vector3 u = key(p);
    const Vector3 v = key(q);
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(u[axis] - v[axis]) > 0.25) return u[axis] < v[axis];
    }
    return p.cells.front() < q.cells.front();
  });
  return order;
}

/// A face between two places: the cells on both sides, that of the lower place first.
struct SharedFace {
  std::size_t a;
  std::size_t b;
};
using SharedFaces = std::map<std::pair<int, int>, std::vector<SharedFace>>;

SharedFaces sharedFaces(const CellGrid& grid, const PlaceLabels& labels) {
  SharedFaces faces;
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    if (labels[cell] == kNoPlace) continue;
    grid.forEachNeighbour(cell, [&](std::size_t next) {
      if (labels[next] > labels[cell]) faces[{labels[cell], labels[next]}].push_back({cell, next});
    });
  }
  return faces;
}

/// Groups faces whose lower cells touch, also at edges and corners, into borders.
std::vector<std::vector<SharedFace>> connectedFaces(const CellGrid& grid, const std::vector<SharedFace>& faces) {
  std::map<std::size_t, std::vector<std::size_t>> byCell;
  for (std::size_t i = 0; i < faces.size(); ++i) byCell[faces[i].a].push_back(i);
  std::vector<char> taken(faces.size(), 0);
  std::vector<std::vector<SharedFace>> groups;
  for (std::size_t seed = 0; seed < faces.size(); ++seed) {
    if (taken[seed] != 0) continue;
    taken[seed] = 1;
    std::vector<std::size_t> group{seed};
    for (std::size_t i = 0; i < group.size(); ++i) {
      const auto c = grid.coordinates(faces[group[i]].a);
      for (int n = 0; n < 27; ++n) {
        const std::array<int, 3> next{c[0] + n / 9 - 1, c[1] + n / 3 % 3 - 1, c[2] + n % 3 - 1};
        if (!grid.contains(next)) continue;
        const auto beside = byCell.find(grid.at(next[0], next[1], next[2]));
        if (beside == byCell.end()) continue;
        for (const std::size_t face : beside->second) {
          if (taken[face] != 0) continue;
          taken[face] = 1;
          group.push_back(face);
        }
      }
    }
    groups.emplace_back();
    for (const std::size_t face : group) groups.back().push_back(faces[face]);
  }
  return groups;
}

/// The cells of both places that are within `reach` of the shared faces, inside the two places.
std::vector<std::size_t> overlapCells(const CellGrid& grid, const PlaceLabels& labels, const Border& border,
                                      const std::vector<SharedFace>& faces, double reach) {
  std::unordered_map<std::size_t, int> layerOf;
  std::vector<std::size_t> front;
  const auto add = [&](std::size_t cell, int layer) {
    if (layerOf.emplace(cell, layer).second) front.push_back(cell);
  };
  for (const SharedFace& face : faces) {
    add(face.a, 1);
    add(face.b, 1);
  }
  const int layers = std::max(1, static_cast<int>(std::lround(reach / grid.cellSize())));
  for (std::size_t i = 0; i < front.size(); ++i) {
    const int layer = layerOf[front[i]];
    if (layer >= layers) continue;
    grid.forEachNeighbour(front[i], [&](std::size_t next) {
      if (labels[next] == border.placeA || labels[next] == border.placeB) add(next, layer + 1);
    });
  }
  std::sort(front.begin(), front.end());
  return front;
}

Border makeBorder(const TopologicalMap& map, std::pair<int, int> pair, std::size_t number,
                  const std::vector<SharedFace>& faces) {
  Border border;
  border.placeA = pair.first;
  border.placeB = pair.second;
  border.name = "B" + std::to_string(pair.first + 1) + "-" + std::to_string(pair.second + 1);
  if (number > 0) border.name += static_cast<char>('a' + static_cast<int>(std::min<std::size_t>(number, 25)));
  Vector3 sum = Vector3::Zero();
  Vector3 normal = Vector3::Zero();
  for (const SharedFace& face : faces) {
    const Vector3 a = map.grid.centre(face.a);
    const Vector3 b = map.grid.centre(face.b);
    sum += (a + b) / 2.0;
    normal += (b - a).normalized();
  }
  border.centre = sum / static_cast<double>(faces.size());
  if (normal.norm() > 1e-9) border.normal = normal.normalized();
  border.opening = std::pow(map.grid.cellSize(), 2) * static_cast<double>(faces.size());
  // The overlap has the size of the narrower place's cells, but at most half of the other place.
  const Place& a = map.places[static_cast<std::size_t>(pair.first)];
  const Place& b = map.places[static_cast<std::size_t>(pair.second)];
  const double reach = std::min(std::min(a.narrowness, b.narrowness), std::max(a.narrowness, b.narrowness) / 2.0);
  border.cells = overlapCells(map.grid, map.placeOf, border, faces, reach);
  return border;
}

}  // namespace

int TopologicalMap::placeAt(const Vector3& p_W) const {
  const auto cell = grid.find(p_W);
  return cell ? placeOf[*cell] : kNoPlace;
}

int TopologicalMap::placeNear(const Vector3& p_W) const {
  const int here = placeAt(p_W);
  if (here != kNoPlace) return here;
  double least = std::numeric_limits<double>::infinity();
  int nearest = kNoPlace;
  for (std::size_t cell = 0; cell < placeOf.size(); ++cell) {
    if (placeOf[cell] == kNoPlace) continue;
    const double distance = (grid.centre(cell) - p_W).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    nearest = placeOf[cell];
  }
  return nearest;
}

TopologicalMap makeTopologicalMap(const FreeSpace& space, const PlaceLabels& labels,
                                  const std::vector<double>& clearance, const std::vector<Passage>& passages,
                                  const TriangleMesh& statics_W, const StopToken& stop) {
  TopologicalMap map;
  map.grid = space.grid;
  std::vector<Place> places = gatherPlaces(space.grid, labels, clearance, passages);
  for (Place& place : places) {
    if (stop.stopRequested()) return map;
    measureNarrowness(statics_W, space.grid, place);
  }
  rateComplexity(space.grid.frame.side, places);
  const std::vector<std::size_t> order = orderOf(space.grid, places);
  std::vector<int> number(places.size());
  map.places.reserve(places.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    number[order[i]] = static_cast<int>(i);
    places[order[i]].name = "P" + std::to_string(i + 1);
    map.places.push_back(std::move(places[order[i]]));
  }
  map.placeOf = labels;
  for (int& label : map.placeOf) {
    if (label != kNoPlace) label = number[static_cast<std::size_t>(label)];
  }
  for (const auto& [pair, faces] : sharedFaces(map.grid, map.placeOf)) {
    if (stop.stopRequested()) return map;
    const auto groups = connectedFaces(map.grid, faces);
    for (std::size_t i = 0; i < groups.size(); ++i) map.borders.push_back(makeBorder(map, pair, i, groups[i]));
  }
  return map;
}

}  // namespace glissade
