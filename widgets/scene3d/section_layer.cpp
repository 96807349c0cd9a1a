#include "widgets/scene3d/section_layer.h"

#include <osg/ClipPlane>
#include <osg/MatrixTransform>
#include <osgUtil/Tessellator>

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

/// Cut faces are darker than the surface, so that they are told apart from it.
constexpr float kCapShade = 0.72F;
constexpr float kOutlineWidth = 1.8F;

using Polygons = std::vector<std::vector<Vector3>>;

/// The inside of polygons by the even-odd rule.
osg::ref_ptr<osg::Geometry> fillOf(const Polygons& polygons, const osg::Vec4& colour) {
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
  for (const std::vector<Vector3>& polygon : polygons) {
    const auto first = static_cast<int>(points->size());
    for (const Vector3& point : polygon) points->push_back(toOsg(point));
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_LINE_LOOP, first, static_cast<int>(polygon.size())));
  }
  geometry->setVertexArray(points);
  osg::ref_ptr<osgUtil::Tessellator> tessellator = new osgUtil::Tessellator;
  tessellator->setTessellationType(osgUtil::Tessellator::TESS_TYPE_GEOMETRY);
  tessellator->setWindingType(osgUtil::Tessellator::TESS_WINDING_ODD);
  tessellator->setBoundaryOnly(false);
  tessellator->retessellatePolygons(*geometry);
  osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
  colours->push_back(colour);
  geometry->setColorArray(colours, osg::Array::BIND_OVERALL);
  makeUnlit(*geometry);
  return geometry;
}

}  // namespace

SectionClip::SectionClip() : clip_(new osg::ClipNode) {}

void SectionClip::setSections(const std::vector<Plane>& sections, const std::vector<osg::Group*>& layers) {
  for (osg::Group* layer : layers) {
    for (std::size_t i = 0; i < kMostSections; ++i) {
      layer->getOrCreateStateSet()->removeMode(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
    }
  }
  clip_->getClipPlaneList().clear();
  for (std::size_t i = 0; i < std::min(sections.size(), kMostSections); ++i) {
    const Plane& section = sections[i];
    const osg::Vec4d kept(-section.normal.x(), -section.normal.y(), -section.normal.z(), section.offset);
    clip_->addClipPlane(new osg::ClipPlane(static_cast<unsigned>(i), kept));
    for (osg::Group* layer : layers) {
      layer->getOrCreateStateSet()->setMode(GL_CLIP_PLANE0 + static_cast<GLenum>(i), osg::StateAttribute::ON);
    }
  }
  // The planes are set for the layers only: what is beside them is not cut.
  clip_->setLocalStateSetModes(osg::StateAttribute::OFF);
}

osg::ref_ptr<osg::Group> makeCap(const RigidBody& body, const Plane& section, const ScenePalette& palette) {
  const Polygons polygons = planeSection(*body.mesh, planeInBody(section, body.X_WB));
  if (polygons.empty()) return nullptr;
  osg::ref_ptr<osg::MatrixTransform> cap = new osg::MatrixTransform(toOsg(body.X_WB));
  osg::Vec4 colour = toOsg(body.colour) * kCapShade;
  colour.a() = 1.0F;
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->addDrawable(fillOf(polygons, colour));
  for (std::vector<Vector3> outline : polygons) {
    outline.push_back(outline.front());
    geode->addDrawable(makeLines(outline, LineKind::Strip, palette.lines, kOutlineWidth * palette.pixelScale));
  }
  cap->addChild(geode);
  return cap;
}

}  // namespace glissade
