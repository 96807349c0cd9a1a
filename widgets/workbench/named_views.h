#pragma once

#include <QString>

#include <vector>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {

/// A camera pose that a user has given a name.
struct NamedView {
  QString name;
  CameraPose pose;
};

/// Views with different names, in the order in which they were saved.
using NamedViews = std::vector<NamedView>;

/// Replaces the pose of the view of this name, or adds a new view.
inline void putView(NamedViews& views, const NamedView& view) {
  for (NamedView& known : views) {
    if (known.name != view.name) continue;
    known = view;
    return;
  }
  views.push_back(view);
}

}  // namespace glissade
