#pragma once

#include <string>
#include <vector>

#include "engine/model/node_names.h"

namespace glissade {

/// The name as a step of a path: printable, without '/', ASCII control characters, and blanks at its ends. May be
/// empty.
std::string asStep(std::string name);

/// The step from a node to a node below it, with the names of the latter.
struct NodeStep {
  std::string step;    ///< never empty, unique among siblings
  std::string former;  ///< the step in earlier versions
  NodeNames names;
};

/// A step for each node below a common node, from the name of its product. `formerNames`: the names from which earlier
/// versions made the steps. A step that a sibling had in earlier versions is not given to another node.
std::vector<NodeStep> stepsFor(const std::vector<NodeNames>& names, const std::vector<std::string>& formerNames);

}  // namespace glissade
