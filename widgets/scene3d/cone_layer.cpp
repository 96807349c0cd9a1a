#include "widgets/scene3d/cone_layer.h"

#include <cmath>
#include <numbers>

#include "engine/base/tolerances.h"
#include "widgets/scene3d/geometry_builder.h"

namespace glissade {
namespace {

constexpr std::uint32_t kConeSides = 48;
constexpr float kConeOpacity = 0.3F;
constexpr float kConeRimWidth = 1.5F;

/// A cone: the vertices are the apex, then the rim.
TriangleMesh coneOf(const ForbiddenCone& cone) {
  const double radius = cone.length * std::sqrt(1.0 - tolerance::kForbiddenCone * tolerance::kForbiddenCone);
  const Vector3 across = cone.direction.unitOrthogonal();
  const Vector3 other = cone.direction.cross(across);
  TriangleMesh mesh;
  mesh.vertices.push_back(cone.apex_W);
  for (std::uint32_t i = 0; i < kConeSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kConeSides;
    mesh.vertices.push_back(cone.apex_W + cone.length * tolerance::kForbiddenCone * cone.direction +
                            radius * (std::cos(angle) * across + std::sin(angle) * other));
    mesh.triangles.push_back({0, i + 1, (i + 1) % kConeSides + 1});
  }
  return mesh;
}

}  // namespace

osg::ref_ptr<osg::Group> makeForbiddenCones(const std::vector<ForbiddenCone>& cones, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  osg::ref_ptr<osg::Geode> surfaces = new osg::Geode;
  osg::ref_ptr<osg::Geode> rims = new osg::Geode;
  const osg::Vec4& colour = palette.penetration;
  for (const ForbiddenCone& cone : cones) {
    const TriangleMesh mesh = coneOf(cone);
    surfaces->addDrawable(makeFlatSurface(mesh, {colour.r(), colour.g(), colour.b(), kConeOpacity}));
    std::vector<Vector3> rim(mesh.vertices.begin() + 1, mesh.vertices.end());
    rim.push_back(rim.front());
    rims->addDrawable(makeLines(rim, LineKind::Strip, colour, kConeRimWidth * palette.pixelScale));
  }
  makeTransparent(*surfaces);
  makeDrawing(*rims);
  group->addChild(surfaces);
  group->addChild(rims);
  return group;
}

}  // namespace glissade
