#pragma once

#include <QPointF>

#include <optional>

#include "widgets/scene3d/scene_pick.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The item that a ray, or the ray through a point of the scene widget, meets first.
struct SceneTarget {
  int place = kNoPlace;         ///< the place, if places are shown
  std::optional<QString> body;  ///< id of the obstacle or of a body of the object, if places are not shown
  bool isObject = false;        ///< the object is in front of obstacles at this point
};

/// Preconditions of both functions: a scenario is open.
SceneTarget targetAlong(const Workbench& bench, const Ray& ray);
SceneTarget targetAt(const Workbench& bench, const QPointF& position);

}  // namespace glissade
