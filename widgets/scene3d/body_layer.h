#pragma once

#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include <vector>

#include "engine/geometry/pose.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/display_mode.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// Makes a body's surface and feature edges under one transform.
osg::ref_ptr<osg::MatrixTransform> makeBody(const BodyShape& shape, const Pose& X_WB, const osg::Vec4& colour,
                                            DisplayMode mode, const ScenePalette& palette);

/// Makes a ghost of the object at a pose where it is not: start, goal, a pose of the path. It is fainter if the body
/// has many edges.
osg::ref_ptr<osg::MatrixTransform> makeGhost(const BodyShape& shape, const Pose& X_WB, const osg::Vec4& colour,
                                             const ScenePalette& palette);

/// Makes a ghost whose silhouette shows through the bodies before it.
osg::ref_ptr<osg::MatrixTransform> makeSeenGhost(const BodyShape& shape, const Pose& X_WB, const osg::Vec4& colour,
                                                 const ScenePalette& palette);

/// Makes ghosts at many poses, all of one drawing: each is fainter the more there are, so that they do not hide the
/// bodies beside them.
osg::ref_ptr<osg::Group> makeGhosts(const BodyShape& shape, const std::vector<Pose>& poses, const osg::Vec4& colour,
                                    const ScenePalette& palette);

/// Makes a mark over a body that is drawn: a bright skin and its edges. It shows through the bodies before it.
osg::ref_ptr<osg::MatrixTransform> makeHighlight(const BodyShape& shape, const Pose& X_WB, const osg::Vec4& colour,
                                                 const ScenePalette& palette);

/// Makes the object that moves: shaded with edges; its silhouette shows through the bodies before it. Drawings that
/// avoid marks, such as the roadmap, leave it and a rim around it free.
osg::ref_ptr<osg::MatrixTransform> makeMovedBody(const BodyShape& shape, const Pose& X_WB, const osg::Vec4& colour,
                                                 const ScenePalette& palette);

/// The colour of a body that one of these functions made.
osg::Vec4 bodyColour(osg::MatrixTransform& body);
/// Changes the colour of a body that one of these functions made; its transparency stays.
void setBodyColour(osg::MatrixTransform& body, const osg::Vec4& colour);

}  // namespace glissade
