#pragma once

#include "app/window/workbench.h"

namespace glissade {

/// Which buttons and keys move the camera: a choice among navigation styles.
class NavigationController final : public QObject {
  Q_OBJECT

 public:
  explicit NavigationController(const Workbench& bench);
};

}  // namespace glissade
