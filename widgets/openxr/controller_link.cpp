#include "widgets/openxr/controller_link.h"

#include <utility>

namespace glissade {
namespace {

std::size_t indexOf(ControllerSide side) { return static_cast<std::size_t>(side); }

std::optional<Pose> inWorld(const RoomPlacement& room, const std::optional<Pose>& X_RP) {
  return X_RP ? std::optional(glissade::inWorld(room, *X_RP)) : std::nullopt;
}

unsigned bitsOf(const std::array<bool, kControllerButtons>& pressed) {
  unsigned bits = 0;
  for (std::size_t button = 0; button < pressed.size(); ++button) bits |= pressed[button] ? 1U << button : 0U;
  return bits;
}

}  // namespace

ControllerLink::~ControllerLink() {
  for (const ControllerSide side : kBothSides) {
    hand_->controller(side).place.set({});
    hand_->controller(side).buttons.mailbox.disconnect();
  }
}

void ControllerLink::take(const BothControllers& states, const RoomPlacement& room) {
  for (const ControllerSide side : kBothSides) {
    const ControllerState& state = states[indexOf(side)];
    connect(side, state.name);
    const Buttons before = std::exchange(pressed_[indexOf(side)], pressedOf(side, state));
    hand_->controller(side).place.set({inWorld(room, state.X_RG), inWorld(room, state.X_RA), state.squeeze, room.scale,
                                       bitsOf(pressed_[indexOf(side)])});
    press(side, before);
  }
}

void ControllerLink::connect(ControllerSide side, const std::string& name) {
  std::string& known = names_[indexOf(side)];
  if (name == known) return;
  known = name;
  InputMailbox& mailbox = hand_->controller(side).buttons.mailbox;
  if (name.empty()) {
    mailbox.disconnect();
  } else {
    mailbox.connect(name);
  }
}

/// The state of the buttons; that of the trigger follows from its squeeze.
ControllerLink::Buttons ControllerLink::pressedOf(ControllerSide side, const ControllerState& state) const {
  constexpr auto kTrigger = static_cast<std::size_t>(ControllerButton::Trigger);
  Buttons now = state.pressed;
  now[kTrigger] = state.trigger >= (pressed_[indexOf(side)][kTrigger] ? kTriggerReleased : kTriggerPressed);
  return now;
}

void ControllerLink::press(ControllerSide side, const Buttons& before) {
  const Buttons& now = pressed_[indexOf(side)];
  for (std::size_t button = 0; button < now.size(); ++button) {
    if (now[button] && !before[button]) hand_->controller(side).buttons.mailbox.press(button);
  }
}

ShownControllers ControllerLink::shown() const {
  const auto of = [this](ControllerSide side) {
    const ControllerMailbox& place = hand_->controller(side).place;
    return ShownController{place.reading(), place.feedback()};
  };
  return {of(ControllerSide::Left), of(ControllerSide::Right)};
}

std::array<bool, 2> ControllerLink::holds() const {
  return {hand_->leftController.place.feedback().holds, hand_->rightController.place.feedback().holds};
}

double ControllerLink::push(ControllerSide side) const {
  const double push = hand_->controller(side).place.feedback().push;
  return push < kLeastPush ? 0.0 : push;
}

}  // namespace glissade
