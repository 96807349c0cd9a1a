#pragma once

#include <optional>

#include "app/window/main_window.h"
#include "app/window/script.h"

namespace glissade {

/// The script commands about the path that was found or given.
class PathScript {
 public:
  explicit PathScript(MainWindow& window) : window_(window) {}

  /// Nothing where the command is another's.
  std::optional<Outcome> carryOut(const ScriptCommand& command);

 private:
  Outcome expect(const std::string& what);

  MainWindow& window_;
};

}  // namespace glissade
