#include "widgets/headset/controller_link.h"

namespace glissade {
namespace {

std::size_t indexOf(ControllerSide side) { return static_cast<std::size_t>(side); }

std::optional<Pose> inWorld(const RoomPlacement& room, const std::optional<Pose>& X_RP) {
  return X_RP ? std::optional(glissade::inWorld(room, *X_RP)) : std::nullopt;
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
    hand_->controller(side).place.set(
        {inWorld(room, state.X_RG), inWorld(room, state.X_RA), state.squeeze, room.scale});
    press(side, state);
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

void ControllerLink::press(ControllerSide side, const ControllerState& state) {
  auto& pressed = pressed_[indexOf(side)];
  std::array<bool, kControllerButtons> now = state.pressed;
  constexpr auto kTrigger = static_cast<std::size_t>(ControllerButton::Trigger);
  now[kTrigger] = state.trigger >= (pressed[kTrigger] ? kTriggerReleased : kTriggerPressed);
  for (std::size_t button = 0; button < now.size(); ++button) {
    if (now[button] && !pressed[button]) hand_->controller(side).buttons.mailbox.press(button);
  }
  pressed = now;
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
