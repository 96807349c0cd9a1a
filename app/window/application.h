#pragma once

#include "widgets/document/session_bridge.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// The whole of `glissade` and `glissade-offscreen`: reads the command line, opens the window, runs a
/// script or the event loop, and returns the exit code (exitCode()).
int runApplication(int argc, char** argv, const SceneWidgetFactory& makeScene, SessionClock clock);

/// Prepares the process of both programs: ignores signals that would kill it, and prevents plugins of the current
/// folder from being loaded.
void prepareProcess();

}  // namespace glissade
