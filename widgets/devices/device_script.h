#pragma once

#include "widgets/workbench/workbench.h"

namespace glissade {

class DeviceController;

/// Adds the script commands about devices: a script uses a mouse, a gamepad or keys as a person would. The command
/// `steps` advances devices and session.
void addDeviceCommands(const Workbench& bench, DeviceController& devices);

}  // namespace glissade
