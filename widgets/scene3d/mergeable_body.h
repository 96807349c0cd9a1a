#pragma once

#include <osg/Array>
#include <osg/Referenced>
#include <osg/ref_ptr>

#include <optional>

#include "widgets/scene3d/shape_detail.h"

namespace glissade {

/// The arrays and colours of an opaque body of few triangles, by which several bodies can be drawn as one. It is user
/// data of the body's transform.
struct MergeableBody final : osg::Referenced {
  ShapeDetail shape;                    ///< in the body's frame
  osg::ref_ptr<osg::Vec4Array> colour;  ///< one colour, that of the surface; it may be changed
  std::optional<osg::Vec4> edgeColour;  ///< nothing: it has no edges
  float edgeWidth = 0.0F;               ///< device pixels
};

}  // namespace glissade
