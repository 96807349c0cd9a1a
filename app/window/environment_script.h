#pragma once

#include <optional>

#include "app/window/main_window.h"
#include "app/window/script.h"

namespace glissade {

/// The script commands about places, bodies, attributes and the coarse plan.
class EnvironmentScript {
 public:
  explicit EnvironmentScript(MainWindow& window) : window_(window) {}

  /// Nothing where the command is another's.
  std::optional<Outcome> carryOut(const ScriptCommand& command);

 private:
  Outcome select(const std::string& kind, const std::string& name);
  Outcome showBody(const std::string& id, const std::string& visible);
  Outcome press(const std::vector<std::string>& pixels);
  Outcome setAttribute(const std::string& name, const std::string& value);
  Outcome type(const std::string& name, const std::string& text);
  Outcome define(const std::string& name, const std::string& type, const std::string& owner);
  Outcome expectAttribute(const std::string& name, const std::string& value);
  Outcome expectWay(const std::string& names);
  Outcome expectStep(const std::string& name);
  Outcome expectPlan(const std::string& what);
  Outcome identify(const std::string& identifier);
  Outcome clickStep(const std::string& name);

  MainWindow& window_;
};

}  // namespace glissade
