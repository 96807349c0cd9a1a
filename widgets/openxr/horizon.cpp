#include "widgets/openxr/horizon.h"

#include <osg/Depth>
#include <osg/Geometry>

#include <array>
#include <cmath>
#include <numbers>

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

constexpr int kSegments = 32;
/// Elevations of the rings of corners, radians: the lower two rings belong to the ground, the upper two to the sky.
constexpr std::array kRings{-0.5 * std::numbers::pi, 0.0, 0.25, 0.5 * std::numbers::pi};
constexpr int kGroundRings = 2;
/// Number of the render bin, which is drawn before everything.
constexpr int kFirst = -100;
/// Radius of the sphere, in distances of the near plane. It writes no depth.
constexpr double kRadius = 100.0;

osg::Vec3 corner(double elevation, int segment) {
  const double azimuth = 2.0 * std::numbers::pi * segment / kSegments;
  return {static_cast<float>(std::cos(elevation) * std::cos(azimuth)),
          static_cast<float>(std::cos(elevation) * std::sin(azimuth)), static_cast<float>(std::sin(elevation))};
}

/// A sphere with one strip of quads between neighbouring rings.
osg::ref_ptr<osg::Geometry> makeSphere() {
  osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
  osg::ref_ptr<osg::Geometry> sphere = new osg::Geometry;
  for (std::size_t ring = 0; ring + 1 < kRings.size(); ++ring) {
    const auto first = static_cast<int>(corners->size());
    for (int segment = 0; segment <= kSegments; ++segment) {
      corners->push_back(corner(kRings[ring + 1], segment));
      corners->push_back(corner(kRings[ring], segment));
    }
    sphere->addPrimitiveSet(new osg::DrawArrays(GL_QUAD_STRIP, first, static_cast<int>(corners->size()) - first));
  }
  sphere->setVertexArray(corners);
  sphere->setColorArray(new osg::Vec4Array(corners->size()), osg::Array::BIND_PER_VERTEX);
  makeUnlit(*sphere);
  osg::StateSet* state = sphere->getOrCreateStateSet();
  state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 1.0, 1.0, false));
  state->setRenderBinDetails(kFirst, "RenderBin");
  return sphere;
}

}  // namespace

Horizon::Horizon() : sphere_(new osg::MatrixTransform), geometry_(makeSphere()) {
  sphere_->addChild(geometry_);
  sphere_->setCullingActive(false);
}

void Horizon::setColours(const Colour& above, const Colour& below) {
  auto& colours = static_cast<osg::Vec4Array&>(*geometry_->getColorArray());
  constexpr std::size_t strip = 2 * (std::size_t{kSegments} + 1);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const std::size_t ring = i / strip + (i % 2 == 0 ? 1 : 0);
    colours[i] = toOsg(ring < kGroundRings ? below : above);
  }
  colours.dirty();
  geometry_->dirtyGLObjects();
}

void Horizon::moveTo(const EyeSight& sight) {
  const double radius = kRadius * sight.nearPlane;
  sphere_->setMatrix(osg::Matrixd::scale(radius, radius, radius) * osg::Matrixd::translate(toOsg(sight.X_WE.position)));
}

}  // namespace glissade
