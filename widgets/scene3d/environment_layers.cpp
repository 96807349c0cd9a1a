#include "widgets/scene3d/environment_layers.h"

#include <algorithm>
#include <cmath>

#include "widgets/scene3d/body_layer.h"
#include "widgets/scene3d/cell_surface.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

constexpr std::size_t kMostCells = 12000;

osg::ref_ptr<osg::Group> groupOf(const osg::ref_ptr<osg::Geometry>& geometry) {
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->addDrawable(geometry);
  osg::ref_ptr<osg::Group> group = new osg::Group;
  group->addChild(geode);
  return group;
}

osg::ref_ptr<osg::Group> transparentFaces(const std::vector<CellFace>& faces, const osg::Vec4& colour) {
  TriangleMesh mesh;
  for (const CellFace& face : faces) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), face.corners.begin(), face.corners.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  auto surface = makeFlatSurface(mesh, colour);
  makeTransparent(*surface);
  return groupOf(surface);
}

/// Lines along the rims of a set of rectangles.
std::vector<Vector3> outlines(const std::vector<CellFace>& faces) {
  std::vector<Vector3> points;
  for (const CellFace& face : faces) {
    for (std::size_t i = 0; i < 4; ++i) {
      points.push_back(face.corners[i]);
      points.push_back(face.corners[(i + 1) % 4]);
    }
  }
  return points;
}

}  // namespace

osg::Vec4 colourOfStep(std::size_t step) {
  static const std::array<osg::Vec4, 6> colours{{{0.00F, 0.45F, 0.70F, 1},
                                                 {0.84F, 0.37F, 0.00F, 1},
                                                 {0.00F, 0.62F, 0.45F, 1},
                                                 {0.80F, 0.47F, 0.65F, 1},
                                                 {0.90F, 0.62F, 0.00F, 1},
                                                 {0.34F, 0.71F, 0.91F, 1}}};
  return colours[step % colours.size()];
}

osg::Vec4 cellColour(CellKind kind, const osg::Vec4& lines) {
  switch (kind) {
    case CellKind::Free: return toOsg(Colour{0.0, 0.62, 0.45}, 0.35);
    case CellKind::Mobile: return toOsg(Colour{0.90, 0.62, 0.0}, 0.7);
    default: return {lines.r(), lines.g(), lines.b(), 0.35F};
  }
}

osg::ref_ptr<osg::Group> makeCells(const Octree& octree, CellKind kind, int finestLevel, const ScenePalette& palette) {
  std::vector<Cell> cells;
  octree.forEachLeaf([&](const Octree::Leaf& leaf) {
    if (leaf.kind == kind && leaf.cell.level <= finestLevel) cells.push_back(leaf.cell);
  });
  std::stable_sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.level < b.level; });
  if (cells.size() > kMostCells) cells.resize(kMostCells);
  std::vector<Vector3> points;
  for (const Cell& cell : cells) {
    const Box3 box = octree.frame().box(cell);
    const std::vector<Vector3> edges = boxEdges(box);
    points.insert(points.end(), edges.begin(), edges.end());
  }
  return groupOf(makeLines(points, LineKind::Segments, cellColour(kind, palette.lines), palette.pixelScale));
}

osg::ref_ptr<osg::Group> makePlaces(const EnvironmentPicture& picture, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  const TopologicalMap& map = picture.knowledge->environment->map;
  for (std::size_t i = 0; i < map.places.size(); ++i) {
    // Rooms are only tinted, because they would hide the passages.
    const double alpha = map.places[i].passage ? 0.55 : 0.07;
    const auto faces = outerSurface(map.grid, map.places[i].cells);
    group->addChild(transparentFaces(faces, toOsg(picture.placeColours[i], alpha)));
    const osg::Vec4 line = toOsg(picture.placeColours[i], map.places[i].passage ? 0.9 : 0.35);
    if (faces.size() < 64)
      group->addChild(groupOf(makeLines(outlines(faces), LineKind::Segments, line, palette.pixelScale)));
  }
  return group;
}

osg::ref_ptr<osg::Group> makeSelection(const EnvironmentPicture& picture, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  const TopologicalMap& map = picture.knowledge->environment->map;
  for (const int place : picture.selectedPlaces) {
    const auto p = static_cast<std::size_t>(place);
    const auto faces = outerSurface(map.grid, map.places[p].cells);
    group->addChild(transparentFaces(faces, toOsg(picture.placeColours[p], map.places[p].passage ? 0.8 : 0.25)));
    const auto outline = map.places[p].passage ? outlines(faces) : boxEdges(map.places[p].box);
    group->addChild(groupOf(makeLines(outline, LineKind::Segments, palette.nearest, 2.5F * palette.pixelScale)));
  }
  return group;
}

osg::ref_ptr<osg::Group> makeBorders(const TopologicalMap& map, const ScenePalette& /*palette*/) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  for (std::size_t place = 0; place < map.places.size(); ++place) {
    const auto faces =
        surfaceOf(map.grid, map.places[place].cells, [&](std::size_t, std::optional<std::size_t> beyond) {
          return beyond && map.placeOf[*beyond] > static_cast<int>(place);
        });
    if (!faces.empty()) group->addChild(transparentFaces(faces, kBorderColour));
  }
  return group;
}

osg::ref_ptr<osg::Group> makeGraph(const TopologicalGraph& graph, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  double dearest = 1e-12;
  for (const auto& edge : graph.edges) {
    if (std::isfinite(edge.cost)) dearest = std::max(dearest, edge.cost);
  }
  for (const auto& edge : graph.edges) {
    if (edge.from > edge.to || !std::isfinite(edge.cost)) continue;
    const float share = static_cast<float>(1.0 - 0.75 * edge.cost / dearest);
    const osg::Vec4 colour(palette.nearest.r(), palette.nearest.g(), palette.nearest.b(), 0.25F + 0.6F * share);
    const auto p = [&](int node) { return graph.nodes[static_cast<std::size_t>(node)].p_W; };
    group->addChild(
        groupOf(makeLines({p(edge.from), p(edge.to)}, LineKind::Segments, colour, 1.4F * palette.pixelScale)));
  }
  std::vector<Vector3> nodes;
  for (const auto& node : graph.nodes) nodes.push_back(node.p_W);
  group->addChild(groupOf(makePoints(nodes, palette.nearest, 7.0F * palette.pixelScale)));
  makeOverlay(*group);
  return group;
}

osg::ref_ptr<osg::Group> makeCoarsePath(const CoarsePlan& plan, const ScenePalette& palette) {
  std::vector<Vector3> way;
  for (const int node : plan.nodes) way.push_back(plan.graph->nodes[static_cast<std::size_t>(node)].p_W);
  osg::ref_ptr<osg::Group> group = new osg::Group;
  if (way.empty()) return group;
  group->addChild(groupOf(makeLines(way, LineKind::Strip, kCoarsePathColour, 3.0F * palette.pixelScale)));
  group->addChild(groupOf(makePoints(way, kCoarsePathColour, 10.0F * palette.pixelScale)));
  makeOverlay(*group);
  return group;
}

bool isMilestoneDrawn(const TopologicalStep& step) { return step.milestone && step.border >= 0; }

osg::ref_ptr<osg::Group> makeMilestones(const CoarsePlan& plan, const BodyShape& object, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  for (const TopologicalStep& step : plan.steps) {
    if (!isMilestoneDrawn(step)) continue;
    group->addChild(makeGhost(object, step.to, kMilestoneColour, palette));
  }
  return group;
}

osg::ref_ptr<osg::Group> makeRegion(const SamplingRegion& region, const ScenePalette& palette) {
  const auto faces = outerSurface(region.grid(), region.cells());
  osg::ref_ptr<osg::Group> group = transparentFaces(faces, osg::Vec4(0.0F, 0.62F, 0.45F, 0.22F));
  constexpr std::size_t kMostOutlined = 4000;
  if (faces.size() <= kMostOutlined) {
    group->addChild(groupOf(
        makeLines(outlines(faces), LineKind::Segments, osg::Vec4(0.0F, 0.45F, 0.33F, 0.35F), palette.pixelScale)));
  }
  return group;
}

osg::ref_ptr<osg::Group> makeSteppedPath(const CoarsePlan& plan, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    std::vector<Vector3> way;
    for (const PathPoint& point : plan.steps[i].points) way.push_back(point.q.position);
    if (way.size() < 2) continue;
    group->addChild(groupOf(makeLines(way, LineKind::Strip, colourOfStep(i), 4.0F * palette.pixelScale)));
  }
  return group;
}

}  // namespace glissade
