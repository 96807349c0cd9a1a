#pragma once

#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include "engine/planning/operator_sample.h"
#include "widgets/scene3d/mark_size.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// Strength of the guidance, in [0, 1]: the larger of force and torque.
float guidanceStrength(const Wrench& guidance);

/// The force that guides the hand as an arrow from the object's reference point, seen through whatever
/// lies in front: as long as two radii of the object at full strength, and never longer than a part of the view. Null
/// where there is none to speak of.
osg::ref_ptr<osg::MatrixTransform> makeGuidance(const OperatorSample& device, const MarkScale& scale,
                                                const ScenePalette& palette);

/// The same arrow from one point towards another: as long as the way, and no longer than at full strength. Null where
/// they are one.
osg::ref_ptr<osg::MatrixTransform> makeGuideArrow(const Vector3& from, const Vector3& to, const MarkScale& scale,
                                                  const ScenePalette& palette);

/// The colour of an object that is guided so strongly.
osg::Vec4 guidanceTint(const osg::Vec4& objectColour, float strength, const ScenePalette& palette);

}  // namespace glissade
