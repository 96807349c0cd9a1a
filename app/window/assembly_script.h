#pragma once

#include <optional>

#include "app/window/main_window.h"
#include "app/window/part_import.h"
#include "app/window/script.h"

namespace glissade {

/// The script commands about parts, where they and the ends of the motion are, and rules.
class AssemblyScript {
 public:
  explicit AssemblyScript(MainWindow& window) : window_(window) {}

  /// Nothing where the command is another's.
  std::optional<Outcome> carryOut(const ScriptCommand& command);

 private:
  Outcome takePart(PartsDialog::Purpose purpose, PartRole role, const std::vector<std::string>& words);
  Outcome setRule(const std::string& which, const std::string& expression);
  Outcome place(const std::string& what, const std::string& position, const std::string& turn);
  Outcome expectPlace(const std::string& what, const std::string& position);

  MainWindow& window_;
};

}  // namespace glissade
