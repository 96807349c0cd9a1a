#pragma once

#include "widgets/workbench/workbench.h"

namespace glissade {

/// The commands of the menu Help that use only the window: keys, shortcuts, "What's this?", the command palette.
class HelpController final : public QObject {
  Q_OBJECT

 public:
  /// Precondition: the panels exist.
  explicit HelpController(const Workbench& bench);

 private:
  void findCommand();
  void changeShortcuts();

  const Workbench& bench_;
};

}  // namespace glissade
