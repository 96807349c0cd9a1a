#include "engine/environment/topological_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "engine/environment/point_clearance.h"

namespace glissade {
namespace {

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
