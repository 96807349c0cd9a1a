#pragma once

#include <string>
#include <vector>

#include "engine/assembly/node_names.h"

namespace glissade {

/// As one step of a path: printable, without '/', ASCII's control characters and blanks at its ends. May be empty.
std::string asStep(std::string name);

/// The step from a node to one below it, with the names of that one.
struct NodeStep {
  std::string step;    ///< never empty, each once among its siblings
  std::string former;  ///< the step that earlier versions gave
  NodeNames names;
};

/// A step for each of the nodes below another one, of the name of its product. `formerNames`: of which earlier versions
/// made the steps. A step that a sibling had there is not given to another one.
std::vector<NodeStep> stepsFor(const std::vector<NodeNames>& names, const std::vector<std::string>& formerNames);

}  // namespace glissade
