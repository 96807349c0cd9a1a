#pragma once

#include <QPointF>

#include <optional>

#include "app/window/workbench.h"
#include "widgets/scene3d/scene_pick.h"

namespace glissade {

/// What lies under a point of the scene widget.
struct SceneTarget {
  int place = kNoPlace;         ///< where places are shown
  std::optional<QString> body;  ///< id of an obstacle, where places are not shown
  bool isObject = false;        ///< the object lies before all of that
};

/// Precondition: a scenario is open.
SceneTarget targetAt(const Workbench& bench, const QPointF& position);

}  // namespace glissade
