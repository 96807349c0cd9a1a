#include "widgets/scene3d/backdrop.h"

#include <osg/Depth>
#include <osg/Geometry>

#include "widgets/scene3d/geometry_builder.h"

namespace glissade {

osg::ref_ptr<osg::Camera> makeBackdrop(const ScenePalette& palette) {
  osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
  for (const auto& [x, y] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
    corners->push_back(osg::Vec3(static_cast<float>(x), static_cast<float>(y), 0));
    colours->push_back(y == 0 ? palette.backgroundBottom : palette.backgroundTop);
  }
  osg::ref_ptr<osg::Geometry> quad = new osg::Geometry;
  quad->setVertexArray(corners);
  quad->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
  quad->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
  makeUnlit(*quad);
  quad->getOrCreateStateSet()->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 1.0, 1.0, false));
  osg::ref_ptr<osg::Camera> camera = new osg::Camera;
  camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
  camera->setProjectionMatrixAsOrtho2D(0, 1, 0, 1);
  camera->setViewMatrix(osg::Matrix::identity());
  camera->setClearMask(0);
  camera->setRenderOrder(osg::Camera::NESTED_RENDER);
  camera->getOrCreateStateSet()->setRenderBinDetails(-100, "RenderBin");
  camera->setNodeMask(kWindowOnly);
  camera->addChild(quad);
  return camera;
}

}  // namespace glissade
