#include "widgets/scene3d/shape_detail.h"

#include <osg/BoundingBox>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace glissade {
namespace {

/// Cells along the longest side of the finest grid; each coarser grid has half of them.
constexpr int kFinestCells = 128;
constexpr int kCoarsestCells = 4;
/// A level that has more triangles than this share of the level before is left out.
constexpr double kWorthwhile = 0.6;
/// The error is at least this share of a cell.
constexpr double kLeastError = 0.1;
/// Share of the corners that moved most and are not counted: a few corners do not make a level unfit.
constexpr double kNotCounted = 0.02;

using Index = std::uint32_t;

/// Triangles and edges by the numbers of their vertices. Corner i of triangle t has the normal 3 t + i.
struct IndexedShape {
  std::vector<osg::Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::array<osg::Vec3, 3>> normals;
  std::vector<std::array<Index, 2>> edges;
  std::vector<Index> vertexOfOriginal;  ///< for each vertex of the finest shape
};

/// The numbers from 0 to size - 1 in the order of `isBefore`.
template <class IsBefore>
std::vector<Index> sortedNumbers(std::size_t size, const IsBefore& isBefore) {
  std::vector<Index> order(size);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), isBefore);
  return order;
}

/// The shape in which equal points are one vertex.
IndexedShape indexed(const ShapeDetail& detail) {
  std::vector<osg::Vec3> points(detail.corners->begin(), detail.corners->end());
  points.insert(points.end(), detail.edges->begin(), detail.edges->end());
  const std::vector<Index> order =
      sortedNumbers(points.size(), [&](Index a, Index b) { return points[a] < points[b]; });
  IndexedShape shape;
  std::vector<Index> vertexOf(points.size());
  for (const Index point : order) {
    if (shape.vertices.empty() || shape.vertices.back() != points[point]) shape.vertices.push_back(points[point]);
    vertexOf[point] = static_cast<Index>(shape.vertices.size() - 1);
  }
  const std::size_t corners = detail.corners->size();
  for (std::size_t i = 0; i + 2 < corners; i += 3) {
    shape.triangles.push_back({vertexOf[i], vertexOf[i + 1], vertexOf[i + 2]});
    shape.normals.push_back({(*detail.normals)[i], (*detail.normals)[i + 1], (*detail.normals)[i + 2]});
  }
  for (std::size_t i = corners; i + 1 < points.size(); i += 2) shape.edges.push_back({vertexOf[i], vertexOf[i + 1]});
  shape.vertexOfOriginal.resize(shape.vertices.size());
  std::iota(shape.vertexOfOriginal.begin(), shape.vertexOfOriginal.end(), 0U);
  return shape;
}

/// The sum of squared distances to planes, weighted: p^T A p + 2 b p + c.
struct Quadric {
  std::array<double, 6> a{};  ///< xx xy xz yy yz zz
  osg::Vec3d b;
  double c = 0.0;

  void add(const osg::Vec3d& n, double d, double weight) {
    const std::array<double, 6> products{n.x() * n.x(), n.x() * n.y(), n.x() * n.z(),
                                         n.y() * n.y(), n.y() * n.z(), n.z() * n.z()};
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += weight * products[i];
    b += n * (weight * d);
    c += weight * d * d;
  }
  double at(const osg::Vec3d& p) const {
    const double square = a[0] * p.x() * p.x() + a[3] * p.y() * p.y() + a[5] * p.z() * p.z() +
                          2.0 * (a[1] * p.x() * p.y() + a[2] * p.x() * p.z() + a[4] * p.y() * p.z());
    return square + 2.0 * (b * p) + c;
  }
};

osg::Vec3d crossOf(const IndexedShape& shape, const std::array<Index, 3>& triangle) {
  const osg::Vec3d a = shape.vertices[triangle[0]];
  return (osg::Vec3d(shape.vertices[triangle[1]]) - a) ^ (osg::Vec3d(shape.vertices[triangle[2]]) - a);
}

/// The number of the cell of each vertex; only cells with vertices are numbered, from 0.
std::vector<Index> cellsOf(const std::vector<osg::Vec3>& vertices, const osg::Vec3& origin, double cellSize,
                           std::size_t& cellCount) {
  std::vector<std::array<int, 3>> keys;
  keys.reserve(vertices.size());
  for (const osg::Vec3& p : vertices) {
    const osg::Vec3d inCells = osg::Vec3d(p - origin) / cellSize;
    keys.push_back({static_cast<int>(inCells.x()), static_cast<int>(inCells.y()), static_cast<int>(inCells.z())});
  }
  const std::vector<Index> order = sortedNumbers(keys.size(), [&](Index a, Index b) { return keys[a] < keys[b]; });
  std::vector<Index> cells(vertices.size());
  cellCount = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || keys[order[i]] != keys[order[i - 1]]) ++cellCount;
    cells[order[i]] = static_cast<Index>(cellCount - 1);
  }
  return cells;
}

/// The vertex of each cell that is nearest to the planes of the triangles at the cell.
std::vector<osg::Vec3> representatives(const IndexedShape& shape, const std::vector<Index>& cells,
                                       std::size_t cellCount) {
  std::vector<Quadric> quadrics(cellCount);
  for (const auto& triangle : shape.triangles) {
    osg::Vec3d normal = crossOf(shape, triangle);
    const double area = 0.5 * normal.normalize();
    const double offset = -(normal * osg::Vec3d(shape.vertices[triangle[0]]));
    for (const Index vertex : triangle) quadrics[cells[vertex]].add(normal, offset, area);
  }
  std::vector<osg::Vec3> chosen(cellCount);
  std::vector<double> least(cellCount, HUGE_VAL);
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const double error = quadrics[cells[i]].at(shape.vertices[i]);
    if (error >= least[cells[i]]) continue;
    least[cells[i]] = error;
    chosen[cells[i]] = shape.vertices[i];
  }
  return chosen;
}

/// The indices of the entries without repetitions. Entries with equal numbers in any order are one triangle or edge;
/// the first one stays.
template <std::size_t N>
std::vector<Index> firstOfEach(const std::vector<std::array<Index, N>>& all) {
  std::vector<std::array<Index, N>> keys = all;
  for (auto& key : keys) std::sort(key.begin(), key.end());
  const std::vector<Index> order =
      sortedNumbers(keys.size(), [&](Index a, Index b) { return std::tie(keys[a], a) < std::tie(keys[b], b); });
  std::vector<Index> first;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& key = keys[order[i]];
    const bool collapsed = std::adjacent_find(key.begin(), key.end()) != key.end();
    if (!collapsed && (i == 0 || keys[order[i - 1]] != key)) first.push_back(order[i]);
  }
  std::sort(first.begin(), first.end());
  return first;
}

template <std::size_t N>
std::vector<std::array<Index, N>> renumbered(std::vector<std::array<Index, N>> all, const std::vector<Index>& numbers) {
  for (auto& one : all) {
    for (Index& vertex : one) vertex = numbers[vertex];
  }
  return all;
}

IndexedShape clustered(const IndexedShape& shape, const osg::Vec3& origin, double cellSize) {
  std::size_t cellCount = 0;
  const std::vector<Index> cells = cellsOf(shape.vertices, origin, cellSize, cellCount);
  IndexedShape coarser;
  coarser.vertices = representatives(shape, cells, cellCount);
  const auto triangles = renumbered(shape.triangles, cells);
  for (const Index i : firstOfEach(triangles)) {
    coarser.triangles.push_back(triangles[i]);
    coarser.normals.push_back(shape.normals[i]);
    // The order of the corners determines the lit side.
    const osg::Vec3d normal = shape.normals[i][0] + shape.normals[i][1] + shape.normals[i][2];
    if (crossOf(coarser, triangles[i]) * normal >= 0.0) continue;
    std::swap(coarser.triangles.back()[1], coarser.triangles.back()[2]);
    std::swap(coarser.normals.back()[1], coarser.normals.back()[2]);
  }
  const auto edges = renumbered(shape.edges, cells);
  for (const Index i : firstOfEach(edges)) coarser.edges.push_back(edges[i]);
  coarser.vertexOfOriginal.reserve(shape.vertexOfOriginal.size());
  for (const Index vertex : shape.vertexOfOriginal) coarser.vertexOfOriginal.push_back(cells[vertex]);
  return coarser;
}

ShapeDetail detailOf(const IndexedShape& shape) {
  ShapeDetail detail{new osg::Vec3Array, new osg::Vec3Array, new osg::Vec3Array};
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      detail.corners->push_back(shape.vertices[shape.triangles[t][i]]);
      detail.normals->push_back(shape.normals[t][i]);
    }
  }
  for (const auto& edge : shape.edges) {
    for (const Index vertex : edge) detail.edges->push_back(shape.vertices[vertex]);
  }
  detail.edgeDensity = edgeDensity(detail);
  return detail;
}

/// The distance by which the corners of the finest shape have moved along its normals; motion within a face is
/// invisible. The share of corners that moved most is not counted.
double errorOf(const IndexedShape& coarser, const IndexedShape& finest) {
  std::vector<double> moves;
  moves.reserve(3 * finest.triangles.size());
  for (std::size_t t = 0; t < finest.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index vertex = finest.triangles[t][i];
      const osg::Vec3 move = coarser.vertices[coarser.vertexOfOriginal[vertex]] - finest.vertices[vertex];
      moves.push_back(std::abs(static_cast<double>(move * finest.normals[t][i])));
    }
  }
  const auto last =
      moves.begin() + static_cast<std::ptrdiff_t>((1.0 - kNotCounted) * static_cast<double>(moves.size() - 1));
  std::nth_element(moves.begin(), last, moves.end());
  return *last;
}

}  // namespace

double edgeDensity(const ShapeDetail& detail) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < detail.edges->size(); i += 2) {
    length += ((*detail.edges)[i + 1] - (*detail.edges)[i]).length();
  }
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < detail.corners->size(); i += 3) {
    const osg::Vec3& a = (*detail.corners)[i];
    area += 0.5 * (((*detail.corners)[i + 1] - a) ^ ((*detail.corners)[i + 2] - a)).length();
  }
  return area > 0.0 ? length / area : 0.0;
}

std::vector<ShapeDetail> coarserDetails(const ShapeDetail& finest, const StopToken& stop) {
  std::vector<ShapeDetail> details;
  if (finest.corners->size() < 3 * kFewestTrianglesOfDetails) return details;
  const IndexedShape original = indexed(finest);
  IndexedShape shape = original;
  osg::BoundingBox box;
  for (const osg::Vec3& vertex : original.vertices) box.expandBy(vertex);
  const double side = std::max({box.xMax() - box.xMin(), box.yMax() - box.yMin(), box.zMax() - box.zMin()});
  std::size_t triangles = shape.triangles.size();
  for (int cells = kFinestCells; cells >= kCoarsestCells && !stop.stopRequested(); cells /= 2) {
    shape = clustered(shape, box._min, side / cells);
    if (static_cast<double>(shape.triangles.size()) > kWorthwhile * static_cast<double>(triangles)) continue;
    triangles = shape.triangles.size();
    details.push_back(detailOf(shape));
    // The error has a lower bound, because small features may be gone even if nearly all corners stay in place, as on
    // planes.
    const double least = std::max(kLeastError * side / cells, details.size() > 1 ? details.end()[-2].error : 0.0);
    details.back().error = std::max(errorOf(shape, original), least);
  }
  return details;
}

}  // namespace glissade
