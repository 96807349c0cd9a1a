#include "widgets/devices/device_script.h"

#include "engine/base/number_text.h"
#include "engine/operator/hand_inputs.h"
#include "widgets/devices/device_controller.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

Result<HandInput*> find(HandInputs& hand, const std::string& device) {
  if (device == "keyboard") return &hand.keyboard;
  if (device == "mouse6d") return &hand.mouse6d;
  if (device == "gamepad") return &hand.gamepad;
  return wrongCommand("there is no device '" + device + "'", "Use keyboard, mouse6d or gamepad.");
}

Outcome plug(HandInputs& hand, const std::string& device, const std::string& name) {
  const auto input = find(hand, device);
  if (!input) return input.error();
  (*input)->mailbox.connect(name);
  return Done{};
}

Outcome unplug(HandInputs& hand, const std::string& device) {
  const auto input = find(hand, device);
  if (!input) return input.error();
  (*input)->mailbox.disconnect();
  return Done{};
}

Outcome deflect(HandInputs& hand, const Words& words) {
  const auto input = find(hand, words[0]);
  if (!input) return input.error();
  RawAxes axes{};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto value = toNumber(words[i + 1]);
    if (!value) return wrongCommand("'" + words[i + 1] + "' is not a number");
    axes[i] = *value;
  }
  (*input)->mailbox.setAxes(axes);
  return Done{};
}

Outcome press(HandInputs& hand, const std::string& device, const std::string& button) {
  const auto input = find(hand, device);
  if (!input) return input.error();
  const auto which = toNumber(button);
  if (!which || *which < 0 || *which >= static_cast<double>(kInputButtons)) {
    return wrongCommand("'" + button + "' is not a button", "Count from 0 to 15.");
  }
  (*input)->mailbox.press(static_cast<std::size_t>(*which));
  return Done{};
}

Outcome expectSteering(const HandInputs& hand, const std::string& target) {
  const bool camera = hand.target == SteeringTarget::Camera;
  if (target == (camera ? "camera" : "object")) return Done{};
  return unmetExpectation(std::string("the devices move the ") + (camera ? "camera" : "object"));
}

Outcome expectFrame(const HandInputs& hand, const std::string& frame) {
  const std::string now = kMotionFrameNames.of(hand.keyboard.shaping.get().frame);
  if (frame == now) return Done{};
  return unmetExpectation("the keys move along the axes of " + now);
}

Outcome advance(SessionBridge& session, DeviceController& devices, const std::string& word) {
  const auto count = toNumber(word);
  if (!count || *count < 0) return wrongCommand("'" + word + "' is not a number of steps");
  if (session.clock() != SessionClock::Lockstep) {
    return wrongCommand("on screen time goes on by itself", "Use wait, or run with --offscreen.");
  }
  devices.advance(static_cast<std::uint64_t>(*count));
  session.advance(static_cast<std::uint64_t>(*count));
  return Done{};
}

}  // namespace

void addDeviceCommands(const Workbench& bench, DeviceController& devices) {
  ScriptCommands& scripts = bench.scripts;
  SessionBridge& session = bench.session;
  HandInputs& hand = *session.hand();
  scripts.add("plug", 2, [&hand](const Words& words) { return plug(hand, words[0], words[1]); });
  scripts.add("unplug", 1, [&hand](const Words& words) { return unplug(hand, words[0]); });
  scripts.add("deflect", 7, [&hand](const Words& words) { return deflect(hand, words); });
  scripts.add("press", 2, [&hand](const Words& words) { return press(hand, words[0], words[1]); });
  scripts.add("expect-steering", 1, [&hand](const Words& words) { return expectSteering(hand, words[0]); });
  scripts.add("expect-frame", 1, [&hand](const Words& words) { return expectFrame(hand, words[0]); });
  scripts.add("steps", 1, [&session, &devices](const Words& words) { return advance(session, devices, words[0]); });
}

}  // namespace glissade
