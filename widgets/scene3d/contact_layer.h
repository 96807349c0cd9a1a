#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "engine/session/session.h"
#include "widgets/scene3d/mark_size.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// What the operator's marks say of the nearest obstacle.
enum class ContactShown { Nothing, Nearest, Contact };
ContactShown contactShown(const SessionSnapshot& snapshot);

/// The nearest obstacle as the operator needs it: P_o, P_n and the gap between them; nearer than d
/// also a disc of the tangent plane on which contact samples are shot, filled while contact mode is on. The disc shows
/// the plane, not how far samples go: it has the size of a mark.
osg::ref_ptr<osg::Group> makeContact(const SessionSnapshot& snapshot, const MarkScale& scale,
                                     const ScenePalette& palette);

}  // namespace glissade
