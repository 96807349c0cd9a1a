// glissade: the window on screen. It links no OSMesa; --offscreen starts glissade-offscreen, which does.
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <iostream>

#include "app/window/application.h"
#include "engine/base/guarded.h"

namespace {

bool wantsOffscreen(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--offscreen") == 0) return true;
  }
  return false;
}

int startSibling(char** argv) {
  const auto sibling = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "glissade-offscreen";
  execv(sibling.c_str(), argv);
  std::cerr << "glissade: " << sibling.string() << " cannot be started: " << std::strerror(errno) << "\n";
  return glissade::exitCode(glissade::ErrorKind::MalformedInput);
}

}  // namespace

int main(int argc, char** argv) {
  glissade::prepareProcess();
  int status = 0;
  const auto why = glissade::guarded(GLISSADE_TEXT("running the workbench"), [&] {
    status = wantsOffscreen(argc, argv) ? startSibling(argv)
                                        : glissade::runApplication(argc, argv, glissade::makeOnscreenSceneWidget,
                                                                   glissade::SessionClock::RealTime);
  });
  if (!why) return status;
  std::cerr << "glissade: " << glissade::toString(*why) << "\n";
  return glissade::exitCode(why->kind);
}
