#include "widgets/scene3d/scene_lights.h"

#include <osg/LightSource>

namespace glissade {
namespace {

/// `towards_V` is the direction to the light in view coordinates: x right, y up, z to the viewer.
osg::ref_ptr<osg::LightSource> makeLight(int number, const osg::Vec3& towards_V, float diffuse, float ambient) {
  osg::ref_ptr<osg::Light> light = new osg::Light(static_cast<unsigned>(number));
  light->setPosition(osg::Vec4(towards_V, 0.0F));
  light->setDiffuse(osg::Vec4(diffuse, diffuse, diffuse, 1.0F));
  light->setAmbient(osg::Vec4(ambient, ambient, ambient, 1.0F));
  light->setSpecular(osg::Vec4(0.0F, 0.0F, 0.0F, 1.0F));
  osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
  source->setReferenceFrame(osg::LightSource::ABSOLUTE_RF);
  source->setLight(light);
  return source;
}

}  // namespace

osg::ref_ptr<osg::Group> makeLights() {
  osg::ref_ptr<osg::Group> lit = new osg::Group;
  lit->addChild(makeLight(0, {-0.35F, 0.55F, 0.75F}, 0.70F, 0.34F));
  lit->addChild(makeLight(1, {0.75F, -0.25F, 0.60F}, 0.22F, 0.0F));
  for (const GLenum mode : {GL_LIGHTING, GL_LIGHT0, GL_LIGHT1})
    lit->getOrCreateStateSet()->setMode(mode, osg::StateAttribute::ON);
  return lit;
}

}  // namespace glissade
