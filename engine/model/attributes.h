#pragma once

#include <map>
#include <string>
#include <variant>

namespace glissade {

/// Value of a semantic attribute; integers are whole numbers, choices are one of the permitted texts.
using AttributeValue = std::variant<bool, double, std::string>;
using Attributes = std::map<std::string, AttributeValue>;

}  // namespace glissade
