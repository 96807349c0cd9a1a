// glissade-offscreen: the same window without a display, drawn by OSMesa, in lockstep time.
#include <QtGlobal>

#include <exception>
#include <iostream>

#include "app/window/application.h"
#include "engine/base/diagnostic.h"

int main(int argc, char** argv) {
  glissade::prepareProcess();
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qputenv("QT_FONT_DPI", "96");
  try {
    return glissade::runApplication(argc, argv, glissade::makeOffscreenSceneWidget, glissade::SessionClock::Lockstep);
  } catch (const std::exception& error) {
    std::cerr << "glissade-offscreen: " << error.what() << "\n";
    return glissade::exitCode(glissade::ErrorKind::Internal);
  }
}
