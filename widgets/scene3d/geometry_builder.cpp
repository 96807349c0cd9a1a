#include "widgets/scene3d/geometry_builder.h"

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/LineWidth>
#include <osg/Point>
#include <osg/Stencil>

#include <algorithm>
#include <cmath>

#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

constexpr int kDiscSegments = 48;
constexpr int kMark = 1;  ///< in the stencil buffer

void setOneColour(osg::Geometry& geometry, const osg::Vec4& colour) {
  auto* colours = new osg::Vec4Array;
  colours->push_back(colour);
  geometry.setColorArray(colours, osg::Array::BIND_OVERALL);
}

}  // namespace

osg::ref_ptr<osg::Geometry> makeFlatSurface(const TriangleMesh& mesh, const osg::Vec4& colour) {
  osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
  corners->reserve(3 * mesh.triangles.size());
  for (const TriangleIndices& triangle : mesh.triangles) {
    for (const auto vertex : triangle) corners->push_back(toOsg(mesh.vertices[vertex]));
  }
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setVertexArray(corners);
  setOneColour(*geometry, colour);
  geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<int>(corners->size())));
  geometry->setUseVertexBufferObjects(true);
  makeUnlit(*geometry);
  return geometry;
}

osg::ref_ptr<osg::Geometry> makeSurface(const ShapeDetail& shape, const osg::Vec4& colour) {
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setVertexArray(shape.corners);
  geometry->setNormalArray(shape.normals, osg::Array::BIND_PER_VERTEX);
  setOneColour(*geometry, colour);
  geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<int>(shape.corners->size())));
  geometry->setUseVertexBufferObjects(true);
  return geometry;
}

osg::ref_ptr<osg::Geometry> makeLines(const std::vector<Vector3>& points, LineKind kind, const osg::Vec4& colour,
                                      float width) {
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  for (const Vector3& point : points) vertices->push_back(toOsg(point));
  return makeLines(vertices, kind, colour, width);
}

osg::ref_ptr<osg::Geometry> makeLines(const osg::ref_ptr<osg::Vec3Array>& points, LineKind kind,
                                      const osg::Vec4& colour, float width) {
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setVertexArray(points);
  setOneColour(*geometry, colour);
  const GLenum mode = kind == LineKind::Segments ? GL_LINES : GL_LINE_STRIP;
  geometry->addPrimitiveSet(new osg::DrawArrays(mode, 0, static_cast<int>(points->size())));
  geometry->setUseVertexBufferObjects(true);
  geometry->getOrCreateStateSet()->setAttributeAndModes(new osg::LineWidth(width));
  makeDrawing(*geometry);
  return geometry;
}

void addSeenThrough(const std::function<osg::ref_ptr<osg::Geometry>(float opacity)>& make, osg::Geode& geode) {
  geode.addDrawable(make(1.0F));
  osg::ref_ptr<osg::Geometry> hidden = make(kSeenThrough);
  hidden->getOrCreateStateSet()->setAttributeAndModes(new osg::Depth(osg::Depth::GREATER, 0.0, 1.0, false));
  geode.addDrawable(hidden);
}

void addLinesSeenThrough(const std::vector<Vector3>& points, LineKind kind, const osg::Vec4& colour, float width,
                         osg::Geode& geode) {
  const auto make = [&](float opacity) {
    return makeLines(points, kind, osg::Vec4(colour.r(), colour.g(), colour.b(), opacity * colour.a()), width);
  };
  addSeenThrough(make, geode);
}

osg::ref_ptr<osg::Geometry> makePoints(const std::vector<Vector3>& points, const osg::Vec4& colour, float size) {
  osg::ref_ptr<osg::Geometry> geometry = makeLines(points, LineKind::Segments, colour, 1.0F);
  geometry->removePrimitiveSet(0);
  geometry->addPrimitiveSet(new osg::DrawArrays(GL_POINTS, 0, static_cast<int>(points.size())));
  geometry->getOrCreateStateSet()->setAttributeAndModes(new osg::Point(size));
  geometry->setCullingActive(false);  // OSG would cull a single point, which has no extent
  return geometry;
}

osg::ref_ptr<osg::Geometry> makeDisc(const Vector3& centre, const Vector3& normal, double radius,
                                     const osg::Vec4& colour) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  const Vector3 u = normal.cross(Vector3::Unit(axis)).normalized();
  const Vector3 v = normal.cross(u);
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  vertices->push_back(toOsg(centre));
  for (int i = 0; i <= kDiscSegments; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / kDiscSegments;
    vertices->push_back(toOsg(centre + radius * (std::cos(angle) * u + std::sin(angle) * v)));
  }
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setVertexArray(vertices);
  setOneColour(*geometry, colour);
  geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, static_cast<int>(vertices->size())));
  makeUnlit(*geometry);
  makeTransparent(*geometry);
  return geometry;
}

std::vector<Vector3> boxEdges(const Box3& box) {
  std::vector<Vector3> points;
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      const int other = corner | (1 << axis);
      if (other == corner) continue;
      points.push_back(box.corner(static_cast<Box3::CornerType>(corner)));
      points.push_back(box.corner(static_cast<Box3::CornerType>(other)));
    }
  }
  return points;
}

void makeUnlit(osg::Node& node) { node.getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF); }

void makeDrawing(osg::Node& node) {
  constexpr int kAfterTransparent = 11;  // OSG's transparent bin is number 10
  makeUnlit(node);
  osg::StateSet* state = node.getOrCreateStateSet();
  state->setRenderBinDetails(kAfterTransparent, "RenderBin");
  state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
}

void makeOverlay(osg::Node& node) {
  node.getOrCreateStateSet()->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false),
                                                   osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
}

void makeTransparent(osg::Node& node) {
  osg::StateSet* state = node.getOrCreateStateSet();
  state->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
  state->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
  state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
}

void makeMarking(osg::Node& node) {
  osg::ref_ptr<osg::Stencil> stencil = new osg::Stencil;
  stencil->setFunction(osg::Stencil::ALWAYS, kMark, ~0U);
  stencil->setOperation(osg::Stencil::KEEP, osg::Stencil::KEEP, osg::Stencil::REPLACE);
  node.getOrCreateStateSet()->setAttributeAndModes(stencil);
}

void makeAvoidMarks(osg::Node& node) {
  osg::ref_ptr<osg::Stencil> stencil = new osg::Stencil;
  stencil->setFunction(osg::Stencil::NOTEQUAL, kMark, ~0U);
  node.getOrCreateStateSet()->setAttributeAndModes(stencil);
}

}  // namespace glissade
