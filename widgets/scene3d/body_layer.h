#pragma once

#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include "engine/environment/rigid_body.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// How a rigid body is drawn.
enum class BodyStyle {
  Solid,       ///< the object in the operator's hand
  SeeThrough,  ///< obstacles: what happens between and behind them matters
  Ghost        ///< start, goal, and the object along the path
};

/// A body's surface and feature edges under one transform; the style fixes its transparency.
osg::ref_ptr<osg::MatrixTransform> makeBody(const TriangleMesh& mesh, const Pose& X_WB, const osg::Vec4& colour,
                                            BodyStyle style, const ScenePalette& palette);

/// Another colour for a body that makeBody made; its transparency stays.
void setBodyColour(osg::MatrixTransform& body, const osg::Vec4& colour);

}  // namespace glissade
