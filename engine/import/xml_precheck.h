#pragma once

#include <cstddef>
#include <string>

#include "engine/base/result.h"

namespace glissade {

/// Results of a scan of a URDF text before a parser reads it.
struct XmlFacts {
  std::size_t geometries = 0;  ///< <geometry> elements of <visual> and <collision> in links
  std::size_t links = 0;       ///< <link> elements of the robot
};

/// Scans an XML text in linear time and refuses texts that TinyXML and urdfdom cannot handle: invalid UTF-8 (TinyXML
/// reads past the end), elements nested deeper than 100 (it recurses), more than 200,000 elements, more than 100
/// attributes in an element (its time is quadratic in them), and a document type. A text that XML and TinyXML read
/// differently ('<' in an attribute's value, '>' in a processing instruction, end tags of another element) is refused,
/// so that the depth counted here is the depth that the parser sees.
Result<XmlFacts> precheckXml(const std::string& text, const std::string& file);

}  // namespace glissade
