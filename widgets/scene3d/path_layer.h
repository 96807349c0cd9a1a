#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "engine/planning/clearance_profile.h"
#include "engine/session/session.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// A path, and how it is coloured.
struct PathPicture {
  const Path& path;
  const BodyShape& object;
  const ClearanceProfile* profile = nullptr;  ///< null: the path has one colour
  const std::vector<Pose>& ghosts;            ///< where the object is drawn beside it
  double tubeRadius;                          ///< metres: of the way as a headset shows it
  bool byAuthor = false;                      ///< each segment in the colour of who made it, instead of by clearance
};

/// The way of the reference point and ghosts of the object along it. The way is coloured by clearance: from orange at
/// the tightest place to blue at the widest.
osg::ref_ptr<osg::Group> makePath(const PathPicture& picture, const ScenePalette& palette);

/// A path that does not hold here: what is blocked of it, with the object at the places that are blocked; the rest is
/// faint.
osg::ref_ptr<osg::Group> makeRefusedPath(const PathExamination& refused, const BodyShape& object,
                                         const ScenePalette& palette);

/// The colour of a clearance: `share` is 0 at the tightest place and 1 at the widest.
osg::Vec4 clearanceColour(double share);

}  // namespace glissade
