#pragma once

#include <optional>

#include "app/window/main_window.h"
#include "app/window/script.h"

namespace glissade {

/// The script commands about why no path was found.
class DifficultyScript {
 public:
  explicit DifficultyScript(MainWindow& window) : window_(window) {}

  /// Nothing where the command is another's.
  std::optional<Outcome> carryOut(const ScriptCommand& command);

 private:
  Outcome show(const std::string& part);
  Outcome expect(const std::string& part, const std::string& body);

  MainWindow& window_;
};

}  // namespace glissade
