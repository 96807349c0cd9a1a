#include "engine/import/step_parts.h"

#include <algorithm>
#include <set>

#include "engine/assembly/product_tree.h"

namespace glissade {
namespace {

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
  for (const Occurrence& part : wholeFile.parts) names.push_back(part.path);
  return names;
}

Result<std::string> nodeNamed(const std::string& name, const std::vector<std::string>& parts, const std::string& file) {
  if (name.empty()) return name;
  const ProductTree tree(parts);
  std::set<std::string> found;
  for (const std::size_t node : tree.named(name)) found.insert(tree.nodes()[node].path);
  if (found.count(name) > 0) return name;
  if (found.empty()) return noSuchPart(file, name, parts);
  if (found.size() == 1) return *found.begin();
  return Diagnostic{ErrorKind::MalformedInput, file, "part '" + name + "'", "is the name of several parts",
                    "Give the whole name: " + nameList({found.begin(), found.end()}) + "."};
}

Diagnostic noSuchPart(const std::string& file, const std::string& name, const std::vector<std::string>& parts) {
  const bool single = parts.size() == 1 && parts.front().empty();
  return {ErrorKind::MalformedInput, file, "part '" + name + "'", "is not in the file",
          single ? "The file holds one part: leave out the name." : "It holds: " + nameList(parts) + "."};
}

}  // namespace glissade
