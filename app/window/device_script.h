#pragma once

#include <optional>

#include "app/window/main_window.h"
#include "app/window/script.h"
#include "engine/operator/hand_inputs.h"

namespace glissade {

/// The script commands about devices: a script holds a mouse, a gamepad or the keys as a person would.
class DeviceScript {
 public:
  explicit DeviceScript(MainWindow& window) : window_(window) {}

  /// Nothing where the command is another's.
  std::optional<Outcome> carryOut(const ScriptCommand& command);

 private:
  Outcome plug(const std::string& device, const std::string& name);
  Outcome unplug(const std::string& device);
  Outcome deflect(const std::vector<std::string>& words);
  Outcome press(const std::string& device, const std::string& button);
  Outcome expectSteering(const std::string& target) const;
  Result<HandInput*> find(const std::string& device) const;

  MainWindow& window_;
};

}  // namespace glissade
