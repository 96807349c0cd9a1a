#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "engine/planning/clearance_profile.h"
#include "engine/session/session.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// A path and its colouring.
struct PathPicture {
  const Path& path;
  const BodyShape& object;
  const ClearanceProfile* profile = nullptr;  ///< null: the path has one colour
  const std::vector<Pose>& ghosts;            ///< poses at which the object is drawn along it
  double tubeRadius;                          ///< metres: radius of the path in a headset
  bool byAuthor = false;                      ///< each segment in its author's colour, instead of by clearance
};

/// Draws the path of the reference point and ghosts of the object along it. It is coloured by clearance: from orange at
/// the tightest place to blue at the widest.
osg::ref_ptr<osg::Group> makePath(const PathPicture& picture, const ScenePalette& palette);

/// Draws a path that is not valid here: its blocked parts, with the object at the blocked places; the rest is faint.
osg::ref_ptr<osg::Group> makeRefusedPath(const PathExamination& refused, const BodyShape& object,
                                         const ScenePalette& palette);

/// The colour of a clearance: `share` is 0 at the tightest place and 1 at the widest.
osg::Vec4 clearanceColour(double share);

}  // namespace glissade
