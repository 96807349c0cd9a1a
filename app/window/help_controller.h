#pragma once

#include "app/window/workbench.h"

namespace glissade {

/// The commands of the menu Help that need nothing but the window: keys, shortcuts, "What's this?", the command
/// palette.
class HelpController final : public QObject {
  Q_OBJECT

 public:
  /// To be made when the panels are there.
  explicit HelpController(const Workbench& bench);

 private:
  void findCommand();
  void changeShortcuts();

  const Workbench& bench_;
};

}  // namespace glissade
