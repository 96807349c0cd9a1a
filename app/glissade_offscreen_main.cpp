// glissade-offscreen: the same window without a display. OSMesa draws it, in lockstep time.
#include <QtGlobal>

#include <iostream>

#include "app/window/application.h"
#include "engine/base/guarded.h"

int main(int argc, char** argv) {
  glissade::prepareProcess();
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qputenv("QT_FONT_DPI", "96");
  int status = 0;
  const auto why = glissade::guarded(GLISSADE_TEXT("running the workbench"), [&] {
    status = glissade::runApplication(argc, argv, glissade::makeOffscreenSceneWidget, glissade::SessionClock::Lockstep);
  });
  if (!why) return status;
  std::cerr << "glissade-offscreen: " << glissade::toString(*why) << "\n";
  return glissade::exitCode(why->kind);
}
