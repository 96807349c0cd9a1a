#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "engine/session/session.h"
#include "widgets/scene3d/mark_size.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// The marks of the nearest obstacle that are shown.
enum class ContactShown { Nothing, Nearest, Contact };
ContactShown contactShown(const SessionSnapshot& snapshot);

/// Makes the marks of the nearest obstacle for the operator: P_o, P_n and the gap between them. Nearer than d there is
/// also a disc of the tangent plane on which contact samples are drawn, filled while contact mode is on. The disc shows
/// the plane and has the size of a mark; it does not show how far samples go.
osg::ref_ptr<osg::Group> makeContact(const SessionSnapshot& snapshot, const MarkScale& scale,
                                     const ScenePalette& palette);

}  // namespace glissade
