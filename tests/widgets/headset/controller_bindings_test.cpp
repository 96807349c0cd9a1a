#include "widgets/openxr/controller_bindings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace glissade {
namespace {

bool isBound(const ControllerProfile& profile, ControllerSide side, ControllerAction action) {
  return std::any_of(profile.bindings.begin(), profile.bindings.end(), [&](const ControllerBinding& binding) {
    return binding.side == side && binding.action == action;
  });
}

TEST(ControllerBindings, EveryKindOfControllersIsThereOnce) {
  std::set<std::string> paths;
  for (const ControllerProfile& profile : controllerProfiles()) paths.insert(profile.path);
  const std::string root = "/interaction_profiles/";
  EXPECT_EQ(paths, (std::set<std::string>{root + "khr/simple_controller", root + "oculus/touch_controller",
                                          root + "valve/index_controller", root + "htc/vive_controller",
                                          root + "microsoft/motion_controller"}));
}

TEST(ControllerBindings, WithEveryOneAPersonTakesPointsPressesAndFeels) {
  for (const ControllerProfile& profile : controllerProfiles()) {
    for (const ControllerSide side : {ControllerSide::Left, ControllerSide::Right}) {
      for (const ControllerAction action :
           {ControllerAction::Grip, ControllerAction::Aim, ControllerAction::Squeeze, ControllerAction::Trigger,
            ControllerAction::Menu, ControllerAction::Pulse}) {
        EXPECT_TRUE(isBound(profile, side, action)) << profile.path << " " << static_cast<int>(action);
      }
    }
  }
}

}  // namespace
}  // namespace glissade
