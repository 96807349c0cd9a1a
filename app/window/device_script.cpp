#include "app/window/device_script.h"

#include "engine/base/number_text.h"

namespace glissade {
namespace {

Diagnostic usage(const std::string& reason, const std::string& advice = "") {
  return {ErrorKind::MalformedInput, "", "", reason, advice};
}

}  // namespace

std::optional<Outcome> DeviceScript::carryOut(const ScriptCommand& command) {
  const auto& words = command.arguments;
  if (command.name == "plug") return plug(words[0], words[1]);
  if (command.name == "unplug") return unplug(words[0]);
  if (command.name == "deflect") return deflect(words);
  if (command.name == "press") return press(words[0], words[1]);
  if (command.name == "expect-steering") return expectSteering(words[0]);
  return std::nullopt;
}

Result<HandInput*> DeviceScript::find(const std::string& device) const {
  HandInputs& hand = *window_.bridge().hand();
  if (device == "keyboard") return &hand.keyboard;
  if (device == "mouse6d") return &hand.mouse6d;
  if (device == "gamepad") return &hand.gamepad;
  return usage("there is no device '" + device + "'", "Use keyboard, mouse6d or gamepad.");
}

Outcome DeviceScript::plug(const std::string& device, const std::string& name) {
  const auto input = find(device);
  if (!input) return input.error();
  (*input)->mailbox.connect(name);
  return Done{};
}

Outcome DeviceScript::unplug(const std::string& device) {
  const auto input = find(device);
  if (!input) return input.error();
  (*input)->mailbox.disconnect();
  return Done{};
}

Outcome DeviceScript::deflect(const std::vector<std::string>& words) {
  const auto input = find(words[0]);
  if (!input) return input.error();
  RawAxes axes{};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto value = toNumber(words[i + 1]);
    if (!value) return usage("'" + words[i + 1] + "' is not a number");
    axes[i] = *value;
  }
  (*input)->mailbox.setAxes(axes);
  return Done{};
}

Outcome DeviceScript::press(const std::string& device, const std::string& button) {
  const auto input = find(device);
  if (!input) return input.error();
  const auto which = toNumber(button);
  if (!which || *which < 0 || *which >= static_cast<double>(kInputButtons)) {
    return usage("'" + button + "' is not a button", "Count from 0 to 15.");
  }
  (*input)->mailbox.press(static_cast<std::size_t>(*which));
  return Done{};
}

Outcome DeviceScript::expectSteering(const std::string& target) const {
  const bool camera = window_.bridge().hand()->target == SteeringTarget::Camera;
  if (target == (camera ? "camera" : "object")) return Done{};
  return Diagnostic{ErrorKind::NoPath, "", "", std::string("the devices move the ") + (camera ? "camera" : "object"),
                    ""};
}

}  // namespace glissade
