#include "engine/import/step_parts.h"

#include <algorithm>
#include <set>

namespace glissade {
namespace {

/// The parts and the assemblies that they are in.
std::set<std::string> nodesOf(const std::vector<std::string>& parts) {
  std::set<std::string> nodes;
  for (const std::string& part : parts) {
    for (const std::string& assembly : assembliesAbove(part)) nodes.insert(assembly);
    nodes.insert(part);
  }
  return nodes;
}

/// As many as a person reads.
std::string nameList(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 30;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > kMost) text += " and " + std::to_string(names.size() - kMost) + " more";
  return text;
}

}  // namespace

std::vector<std::string> namesOf(const LoadedGeometry& wholeFile) {
  std::vector<std::string> names;
  for (const GeometryPart& part : wholeFile.parts) names.push_back(part.name);
  return names;
}

Result<std::string> nodeNamed(const std::string& name, const std::vector<std::string>& parts, const std::string& file) {
  const std::set<std::string> nodes = nodesOf(parts);
  if (name.empty() || nodes.count(name) > 0) return name;
  std::vector<std::string> found;
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(found),
               [&](const std::string& node) { return endsInPath(node, name); });
  if (found.empty()) return noSuchPart(file, name, parts);
  if (found.size() == 1) return found.front();
  return Diagnostic{ErrorKind::MalformedInput, file, "part '" + name + "'", "is the name of several parts",
                    "Give the whole name: " + nameList(found) + "."};
}

Diagnostic noSuchPart(const std::string& file, const std::string& name, const std::vector<std::string>& parts) {
  const bool single = parts.size() == 1 && parts.front().empty();
  return {ErrorKind::MalformedInput, file, "part '" + name + "'", "is not in the file",
          single ? "The file holds one part: leave out the name." : "It holds: " + nameList(parts) + "."};
}

}  // namespace glissade
