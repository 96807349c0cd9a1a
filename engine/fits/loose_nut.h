#pragma once

#include "engine/base/stop_token.h"
#include "engine/fits/contact_report.h"

namespace glissade {

/// True if the body with the hole of a thread would turn with its shaft: a nut (compact about the axis and not round)
/// that no other body keeps from turning. A shaft is not turned out of such a body; the nut is turned off first.
/// `others`: all bodies except the shaft; those out of the nut's reach are ignored.
bool isLooseNut(const RigidBody& nut, const ContactAxis& axis, const std::vector<const RigidBody*>& others,
                const StopToken& stop);

}  // namespace glissade
