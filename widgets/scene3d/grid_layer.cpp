#include "widgets/scene3d/grid_layer.h"

#include <algorithm>
#include <cmath>

#include "widgets/scene3d/axis_colours.h"
#include "widgets/scene3d/geometry_builder.h"

namespace glissade {
namespace {

/// Reach of the grid, as a multiple of the product's.
constexpr double kGridReach = 1.6;
/// Least number of lines from the centre to the end.
constexpr double kLeastLines = 12.0;
/// Depth of the grid below the product, as a share of the product's size, so that it does not stripe the lowest faces.
constexpr double kBelowProduct = 2e-3;
/// Lines are drawn in parts, each fainter than the part before.
constexpr int kFadeParts = 24;
constexpr int kStrongEvery = 10;
constexpr float kWeakLine = 0.16F;
constexpr float kStrongLine = 0.34F;
constexpr float kAxisLine = 0.7F;

double roundDown125(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= length) return factor * power;
  }
  return power;
}

osg::Vec4 axisColour(int axis) {
  const std::uint32_t rgb = kAxisColours[static_cast<std::size_t>(axis)];
  const auto share = [rgb](int shift) { return static_cast<float>((rgb >> shift) & 0xffU) / 255.0F; };
  return {share(16), share(8), share(0), kAxisLine};
}

/// Opacity of the grid: full in the middle, 0 at the end.
float fadeAt(double distance, double reach) {
  const double t = std::clamp(1.0 - distance / reach, 0.0, 1.0);
  return static_cast<float>(t * t * (3.0 - 2.0 * t));
}

struct GridLines {
  osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
  std::vector<Vector3> ends;
};

/// Adds the line along an axis whose other coordinate is `across`.
void addGridLine(const GroundGrid& grid, int along, double across, const osg::Vec4& colour, GridLines& lines) {
  const double off = across - grid.centre[1 - along];
  const double half = std::sqrt(std::max(0.0, grid.reach * grid.reach - off * off));
  for (int i = 0; i < kFadeParts; ++i) {
    for (const int end : {i, i + 1}) {
      Vector3 p = grid.centre;
      p[along] += half * (2.0 * end / kFadeParts - 1.0);
      p[1 - along] = across;
      lines.ends.push_back(p);
      const float fade = fadeAt((p - grid.centre).norm(), grid.reach);
      lines.colours->push_back({colour.r(), colour.g(), colour.b(), colour.a() * fade});
    }
  }
}

}  // namespace

GroundGrid groundGridUnder(const Box3& box, double unit) {
  const double size = std::max(1e-6, box.diagonal().norm());
  GroundGrid grid;
  grid.reach = kGridReach * std::max(1e-6, 0.5 * size);
  grid.spacing = unit * roundDown125(grid.reach / kLeastLines / unit);
  grid.centre = {box.center().x(), box.center().y(), box.min().z() - kBelowProduct * size};
  return grid;
}

osg::ref_ptr<osg::Group> makeGrid(const GroundGrid& grid, const ScenePalette& palette) {
  GridLines lines;
  for (const int along : {0, 1}) {
    const double centre = grid.centre[1 - along];
    const auto first = static_cast<long>(std::ceil((centre - grid.reach) / grid.spacing));
    const auto last = static_cast<long>(std::floor((centre + grid.reach) / grid.spacing));
    for (long i = first; i <= last; ++i) {
      osg::Vec4 colour = i == 0 ? axisColour(along) : palette.lines;
      if (i != 0) colour.a() = i % kStrongEvery == 0 ? kStrongLine : kWeakLine;
      addGridLine(grid, along, static_cast<double>(i) * grid.spacing, colour, lines);
    }
  }
  osg::ref_ptr<osg::Geometry> geometry = makeLines(lines.ends, LineKind::Segments, palette.lines, palette.pixelScale);
  geometry->setColorArray(lines.colours, osg::Array::BIND_PER_VERTEX);
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->addDrawable(geometry);
  osg::ref_ptr<osg::Group> group = new osg::Group;
  group->addChild(geode);
  return group;
}

}  // namespace glissade
