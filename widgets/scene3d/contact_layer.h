#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "engine/session/session.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// The nearest obstacle as the operator needs it: P_o, P_n and the gap between them; nearer than d
/// also the tangent plane on which contact samples are shot, filled while contact mode is on.
osg::ref_ptr<osg::Group> makeContact(const SessionSnapshot& snapshot, const ScenePalette& palette);

}  // namespace glissade
