#pragma once

#include <optional>
#include <string_view>

#include "engine/base/message.h"

namespace glissade {

/// The first fault of the lines of an IGES text; nothing if it has none. In a text without a fault, lines have 80
/// columns, are numbered without gaps in each section, and are as many as the last line states. OpenCASCADE silently
/// leaves out entities of a text with such a fault.
std::optional<Message> faultOfIgesText(std::string_view text);

}  // namespace glissade
