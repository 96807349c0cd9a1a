#include "engine/import/step_parts.h"

#include <algorithm>
#include <set>

namespace glissade {
namespace {

/// A list of limited length for people.
Message nameList(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 30;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() <= kMost) return Message(text);
  return {GLISSADE_TEXT("%1 and %2 more"), {text, names.size() - kMost}};
}

std::vector<std::string> bodiesOf(const Product& tree) {
  std::vector<std::string> paths;
  for (const Product::Node& node : tree.nodes()) {
    if (!node.isAssembly) paths.push_back(node.path);
  }
  return paths;
}

}  // namespace

std::vector<std::string> namesOf(const LoadedGeometry& wholeFile) {
  std::vector<std::string> names;
  for (const Occurrence& part : wholeFile.parts) names.push_back(part.path);
  return names;
}

Product treeOf(const std::vector<Occurrence>& parts) {
  std::vector<ProductBody> bodies;
  for (const Occurrence& part : parts) bodies.push_back({BodyId(part.path), {part.path, part.names, part.unit}});
  return Product(bodies);
}

Result<std::string> nodeNamed(const std::string& name, const Product& tree, const std::string& file) {
  if (name.empty()) return name;
  std::set<std::string> found;
  for (const std::size_t node : tree.named(name)) found.insert(tree.nodes()[node].path);
  if (found.count(name) > 0) return name;
  if (found.empty()) return noSuchPart(file, name, bodiesOf(tree));
  if (found.size() == 1) return *found.begin();
  return Diagnostic{ErrorKind::MalformedInput,
                    file,
                    {GLISSADE_TEXT("part '%1'"), {name}},
                    GLISSADE_TEXT("is the name of several parts"),
                    {GLISSADE_TEXT("Give the whole name: %1."), {nameList({found.begin(), found.end()})}}};
}

Diagnostic noSuchPart(const std::string& file, const std::string& name, const std::vector<std::string>& parts) {
  const bool single = parts.size() == 1 && parts.front().empty();
  return {ErrorKind::MalformedInput,
          file,
          {GLISSADE_TEXT("part '%1'"), {name}},
          GLISSADE_TEXT("is not in the file"),
          single ? Message(GLISSADE_TEXT("The file holds one part: leave out the name."))
                 : Message(GLISSADE_TEXT("It holds: %1."), {nameList(parts)})};
}

}  // namespace glissade
