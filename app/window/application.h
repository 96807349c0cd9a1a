#pragma once

#include "widgets/bridge/session_bridge.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// The whole of `glissade` and `glissade-offscreen`: reads the command line, opens the window, runs a
/// script or the event loop, and returns the exit code (exitCode()).
int runApplication(int argc, char** argv, const SceneWidgetFactory& makeScene, SessionClock clock);

/// What both programs do before anything else: signals that would kill them, plugins of the current
/// folder that must not be loaded.
void prepareProcess();

}  // namespace glissade
