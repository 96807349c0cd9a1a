#pragma once

#include <optional>

#include "app/window/main_window.h"
#include "app/window/script.h"

namespace glissade {

/// The commands of a script that concern studies.
class StudyScript {
 public:
  explicit StudyScript(MainWindow& window) : window_(window) {}

  /// Nothing where the command is not one of these. Errors name no file and line yet.
  std::optional<Outcome> carryOut(const ScriptCommand& command);

 private:
  Outcome choose(const ScriptCommand& command);
  Outcome zoom(const std::vector<std::string>& words);
  Outcome start(const std::string& cell, const std::string& seed);

  MainWindow& window_;
};

}  // namespace glissade
