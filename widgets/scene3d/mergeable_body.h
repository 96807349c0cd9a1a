#pragma once

#include <osg/Array>
#include <osg/Referenced>
#include <osg/ref_ptr>

#include <optional>

#include "widgets/scene3d/shape_detail.h"

namespace glissade {

/// What an opaque body of few triangles is drawn with, so that several can be drawn as one: user data of its transform.
struct MergeableBody final : osg::Referenced {
  ShapeDetail shape;                    ///< of the body's frame
  osg::ref_ptr<osg::Vec4Array> colour;  ///< one, that of the surface; it may be changed
  std::optional<osg::Vec4> edgeColour;  ///< nothing: it has no edges
  float edgeWidth = 0.0F;               ///< device pixels
};

}  // namespace glissade
