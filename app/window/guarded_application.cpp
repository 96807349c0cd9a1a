#include "app/window/guarded_application.h"

#include <iostream>
#include <utility>

#include "engine/base/guarded.h"

namespace glissade {

bool GuardedApplication::notify(QObject* receiver, QEvent* event) {
  if (!handler_) return QApplication::notify(receiver, event);
  bool handled = false;
  const auto why = guarded(GLISSADE_TEXT("handling an event of the window"),
                           [&] { handled = QApplication::notify(receiver, event); });
  if (why) report(*why);
  return handled;
}

void GuardedApplication::report(const Diagnostic& why) {
  if (std::exchange(reporting_, true)) {
    std::cerr << "glissade: " << toString(why) << "\n";
    return;
  }
  const auto second = guarded(GLISSADE_TEXT("showing an error"), [&] { handler_(why); });
  if (second) std::cerr << "glissade: " << toString(why) << "\nglissade: " << toString(*second) << "\n";
  reporting_ = false;
}

}  // namespace glissade
