#pragma once

#include <string>
#include <vector>

#include "engine/operator/device_registry.h"

namespace glissade {

/// A registry, and the ids of its devices that device_conformance_test.cpp holds to the contract.
struct DevicesUnderTest {
  DeviceRegistry registry;
  std::vector<std::string> ids;
};

/// The devices to test. Every test program with the suite defines this function.
DevicesUnderTest devicesUnderTest();

}  // namespace glissade
