#pragma once

#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include "engine/places/rigid_body.h"
#include "widgets/openxr/eye_sight.h"

namespace glissade {

/// Ground and sky behind everything, infinitely far: they do not shift with the head, and their border is level.
class Horizon {
 public:
  Horizon();

  osg::Node* node() const { return sphere_; }
  /// Sets the colours, in sRGB.
  void setColours(const Colour& above, const Colour& below);
  /// Moves the sphere to this eye, before its picture.
  void moveTo(const EyeSight& sight);

 private:
  osg::ref_ptr<osg::MatrixTransform> sphere_;
  osg::ref_ptr<osg::Geometry> geometry_;
};

}  // namespace glissade
