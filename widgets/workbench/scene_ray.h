#pragma once

#include <QPointF>

#include "widgets/scene3d/scene_pick.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// The ray through a point of the scene widget.
Ray rayThrough(SceneWidget& scene, const QPointF& position);

}  // namespace glissade
