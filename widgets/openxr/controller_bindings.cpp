#include "widgets/openxr/controller_bindings.h"

namespace glissade {
namespace {

/// An action and its component, the same for both hands.
struct Component {
  ControllerAction action;
  const char* name;
};

/// A profile with poses and pulse, which all controllers have.
ControllerProfile profile(const char* path, std::vector<Component> ofBoth) {
  ofBoth.insert(ofBoth.end(), {{ControllerAction::Grip, "/input/grip/pose"},
                               {ControllerAction::Aim, "/input/aim/pose"},
                               {ControllerAction::Pulse, "/output/haptic"}});
  ControllerProfile made{path, {}};
  for (const ControllerSide side : {ControllerSide::Left, ControllerSide::Right}) {
    for (const Component& component : ofBoth) made.bindings.push_back({side, component.action, component.name});
  }
  return made;
}

ControllerProfile simple() {
  return profile("/interaction_profiles/khr/simple_controller", {{ControllerAction::Squeeze, "/input/select/click"},
                                                                 {ControllerAction::Trigger, "/input/select/click"},
                                                                 {ControllerAction::Menu, "/input/menu/click"}});
}

/// The profile of Oculus Touch. The menu button of its right hand belongs to the runtime.
ControllerProfile touch() {
  ControllerProfile made = profile("/interaction_profiles/oculus/touch_controller",
                                   {{ControllerAction::Squeeze, "/input/squeeze/value"},
                                    {ControllerAction::Trigger, "/input/trigger/value"},
                                    {ControllerAction::Stick, "/input/thumbstick"},
                                    {ControllerAction::StickClick, "/input/thumbstick/click"}});
  made.bindings.insert(made.bindings.end(), {{ControllerSide::Left, ControllerAction::Menu, "/input/menu/click"},
                                             {ControllerSide::Left, ControllerAction::Lower, "/input/x/click"},
                                             {ControllerSide::Left, ControllerAction::Upper, "/input/y/click"},
                                             {ControllerSide::Right, ControllerAction::Lower, "/input/a/click"},
                                             {ControllerSide::Right, ControllerAction::Menu, "/input/b/click"}});
  return made;
}

ControllerProfile index() {
  return profile("/interaction_profiles/valve/index_controller",
                 {{ControllerAction::Squeeze, "/input/squeeze/value"},
                  {ControllerAction::Trigger, "/input/trigger/value"},
                  {ControllerAction::Stick, "/input/thumbstick"},
                  {ControllerAction::StickClick, "/input/thumbstick/click"},
                  {ControllerAction::Lower, "/input/a/click"},
                  {ControllerAction::Menu, "/input/b/click"}});
}

ControllerProfile vive() {
  return profile("/interaction_profiles/htc/vive_controller", {{ControllerAction::Squeeze, "/input/squeeze/click"},
                                                               {ControllerAction::Trigger, "/input/trigger/value"},
                                                               {ControllerAction::Stick, "/input/trackpad"},
                                                               {ControllerAction::StickClick, "/input/trackpad/click"},
                                                               {ControllerAction::Menu, "/input/menu/click"}});
}

ControllerProfile motion() {
  return profile("/interaction_profiles/microsoft/motion_controller",
                 {{ControllerAction::Squeeze, "/input/squeeze/click"},
                  {ControllerAction::Trigger, "/input/trigger/value"},
                  {ControllerAction::Stick, "/input/thumbstick"},
                  {ControllerAction::StickClick, "/input/thumbstick/click"},
                  {ControllerAction::Menu, "/input/menu/click"}});
}

}  // namespace

std::vector<ControllerProfile> controllerProfiles() { return {simple(), touch(), index(), vive(), motion()}; }

}  // namespace glissade
