#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "engine/session/session.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// The nearest obstacle as the operator needs it: P_o, P_n and the gap between them; nearer than d
/// also the tangent plane on which contact samples are shot, filled while contact mode is on.
osg::ref_ptr<osg::Group> makeContact(const SessionSnapshot& snapshot, const ScenePalette& palette);

/// The path: the way of the reference point, and ghosts of the object along it.
/// `byAuthor`: each segment in the colour of who made it.
osg::ref_ptr<osg::Group> makePath(const Path& path, const BodyShape& object, const ScenePalette& palette,
                                  bool byAuthor);

/// A path that does not hold here: what is blocked of it, with the object in the way there; the rest fades.
osg::ref_ptr<osg::Group> makeRefusedPath(const PathExamination& refused, const BodyShape& object,
                                         const ScenePalette& palette);

}  // namespace glissade
