#include "engine/import/node_steps.h"

#include <algorithm>

#include "engine/base/printable_text.h"
#include "engine/model/unique_names.h"

namespace glissade {

std::string asStep(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  name.erase(std::remove_if(name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }),
             name.end());
  name = printableLine(name);
  const auto first = name.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return name.substr(first, name.find_last_not_of(' ') - first + 1);
}

std::vector<NodeStep> stepsFor(const std::vector<NodeNames>& names, const std::vector<std::string>& formerNames) {
  const auto stepOf = [](const std::string& name) {
    const std::string step = asStep(name);
    return step.empty() ? std::string("part") : step;
  };
  UniqueNames unique;
  std::vector<NodeStep> steps;
  for (std::size_t i = 0; i < names.size(); ++i) steps.push_back({"", unique.take(stepOf(formerNames[i])), names[i]});
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string step = stepOf(names[i].product);
    steps[i].step = step == stepOf(formerNames[i]) ? steps[i].former : unique.take(step);
  }
  return steps;
}

}  // namespace glissade
