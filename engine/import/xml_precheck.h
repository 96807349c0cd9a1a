#pragma once

#include <cstddef>
#include <string>

#include "engine/base/result.h"

namespace glissade {

/// What a glance at an XML text tells before a parser sees it.
struct XmlFacts {
  std::size_t geometries = 0;  ///< <geometry> elements outside comments
};

/// Refuses what crashes TinyXML: nesting deeper than 100 elements (it recurses) and invalid UTF-8 (it
/// reads past the end).
Result<XmlFacts> precheckXml(const std::string& text, const std::string& file);

}  // namespace glissade
