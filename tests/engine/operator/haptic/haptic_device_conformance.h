#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/operator/haptic/haptic_device.h"

namespace glissade {

/// A device that haptic_device_conformance_test.cpp holds to the contract.
struct HapticDeviceUnderTest {
  std::string name;
  std::function<std::unique_ptr<HapticDevice>()> make;
};

/// The devices to test. Every test program with the suite defines this function.
std::vector<HapticDeviceUnderTest> hapticDevicesUnderTest();

}  // namespace glissade
