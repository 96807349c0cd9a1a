#pragma once

#include <QString>

#include <vector>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {

/// A camera that a user came back to by its name.
struct NamedView {
  QString name;
  CameraPose pose;
};

/// Names differ; in the order in which they were saved.
using NamedViews = std::vector<NamedView>;

/// The view of this name takes the pose, or a new one is added.
inline void putView(NamedViews& views, const NamedView& view) {
  for (NamedView& known : views) {
    if (known.name != view.name) continue;
    known = view;
    return;
  }
  views.push_back(view);
}

}  // namespace glissade
