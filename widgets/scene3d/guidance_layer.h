#pragma once

#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include "engine/planning/operator_sample.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// Strength of the guidance, in [0, 1]: the larger of force and torque.
float guidanceStrength(const Wrench& guidance);

/// The force that guides the hand as an arrow from the object's reference point, seen through whatever
/// lies in front: three radii of the object long at full strength. Null where there is none to speak of.
osg::ref_ptr<osg::MatrixTransform> makeGuidance(const OperatorSample& device, double objectRadius,
                                                const ScenePalette& palette);

/// The colour of an object that is guided so strongly.
osg::Vec4 guidanceTint(const osg::Vec4& objectColour, float strength, const ScenePalette& palette);

}  // namespace glissade
