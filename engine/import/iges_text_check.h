#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// What is wrong with an IGES text: lines that are missing, twice or damaged. Nothing: its lines have 80 columns, are
/// numbered without gaps in each section, and are as many as the last line states. OpenCASCADE leaves out entities
/// where they are not, without a message.
std::optional<std::string> faultOfIgesText(std::string_view text);

}  // namespace glissade
