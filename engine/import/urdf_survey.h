#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace glissade {

/// What a URDF file says, counted without urdfdom, which drops elements that it cannot read.
struct UrdfSurvey {
  struct Link {
    std::string name;
    std::size_t collisions = 0;
    std::size_t visuals = 0;
  };
  std::vector<Link> links;  ///< in the order of the file
  std::size_t joints = 0;
};

/// Reads the XML in one pass without recursion (Expat). Refuses, with line and column as place: XML
/// that is not well-formed or not UTF-8, document type declarations, nesting deeper than 32, and
/// more than 20,000 elements. The diagnostic has no file.
Result<UrdfSurvey> surveyUrdf(std::string_view xml);

}  // namespace glissade
