#pragma once

#include "app/window/workbench.h"

namespace glissade {

class DeviceController;

/// The script commands about devices: a script holds a mouse, a gamepad or the keys as a person would. Among them is
/// `steps`, which lets devices and session go on.
void addDeviceCommands(const Workbench& bench, DeviceController& devices);

}  // namespace glissade
