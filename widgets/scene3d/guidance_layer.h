#pragma once

#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include "engine/planning/operator_sample.h"
#include "widgets/scene3d/mark_size.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// Strength of the guidance, in [0, 1]: the larger of force and torque.
float guidanceStrength(const Wrench& guidance);

/// The force that guides the hand, as an arrow from the object's reference point. It shows through bodies, is two radii
/// of the object long at full strength, and never longer than a share of the view. Null if the force is too weak.
osg::ref_ptr<osg::MatrixTransform> makeGuidance(const OperatorSample& device, const MarkScale& scale,
                                                const ScenePalette& palette);

/// The motion from one pose to another: an arrow between their reference points, and a curved arrow about the axis of
/// the turn. Neither is drawn where it would be shorter than its head.
osg::ref_ptr<osg::Group> makeGuideArrow(const Pose& from, const Pose& to, const MarkScale& scale,
                                        const ScenePalette& palette);

/// The colour of an object that is guided with this strength.
osg::Vec4 guidanceTint(const osg::Vec4& objectColour, float strength, const ScenePalette& palette);

}  // namespace glissade
