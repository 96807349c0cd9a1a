#include "engine/operator/device_registry.h"

#include <gtest/gtest.h>

#include "tests/engine/operator/device_conformance.h"

namespace glissade {

/// Every device of the product.
DevicesUnderTest devicesUnderTest() {
  DevicesUnderTest devices{makeDeviceRegistry(), {}};
  addTaskOperators(devices.registry);
  for (const DeviceEntry& entry : devices.registry.entries()) devices.ids.push_back(entry.id);
  return devices;
}

namespace {

TEST(DeviceRegistry, WithoutAHandNobodyHoldsAnything) {
  for (const char* id :
       {"hand", "keyboard", "mouse6d", "gamepad", "left-controller", "right-controller", "simulated-haptic"}) {
    EXPECT_EQ(makeDeviceRegistry().find(id)->make(DeviceContext()), nullptr);
  }
  EXPECT_EQ(makeDeviceRegistry().find("telepathy"), nullptr);
}

}  // namespace
}  // namespace glissade
