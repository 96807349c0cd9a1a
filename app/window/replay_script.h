#pragma once

#include <optional>

#include "app/window/main_window.h"
#include "app/window/script.h"

namespace glissade {

/// The script commands about recordings and replays.
class ReplayScript {
 public:
  explicit ReplayScript(MainWindow& window) : window_(window) {}

  /// Nothing where the command is another's.
  std::optional<Outcome> carryOut(const ScriptCommand& command);

 private:
  Outcome seek(const std::string& step);
  Outcome expectReplay(const std::string& verdict);

  MainWindow& window_;
};

}  // namespace glissade
