#pragma once

#include <map>
#include <string>
#include <variant>

namespace glissade {

/// A semantic attribute's value; integers are whole numbers, choices one of the texts allowed.
using AttributeValue = std::variant<bool, double, std::string>;
using Attributes = std::map<std::string, AttributeValue>;

}  // namespace glissade
