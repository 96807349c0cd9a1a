#include "engine/assembly/product_tree.h"

#include <algorithm>

#include "engine/assembly/body_path.h"

namespace glissade {

ProductTree::ProductTree(const std::vector<std::string>& paths) {
  Assemblies known;
  for (std::size_t body = 0; body < paths.size(); ++body) nodes_[addBelow(paths[body], known)].body = body;
}

/// Made with those above it at the first call.
std::size_t ProductTree::assemblyAt(const std::string& path, Assemblies& known) {
  const auto found = known.find(path);
  if (found != known.end()) return found->second;
  const std::size_t node = addBelow(path, known);
  known.emplace(path, node);
  return node;
}

/// Adds a node below the assembly that its path names.
std::size_t ProductTree::addBelow(const std::string& path, Assemblies& known) {
  Node node{path, lastStepOf(path)};
  const std::vector<std::string> above = assembliesAbove(path);
  if (!above.empty()) node.parent = assemblyAt(above.back(), known);
  const std::size_t index = nodes_.size();
  if (node.parent) nodes_[*node.parent].children.push_back(index);
  nodes_.push_back(std::move(node));
  return index;
}

std::vector<std::size_t> ProductTree::bodiesOf(std::size_t node) const {
  std::vector<std::size_t> bodies;
  std::vector<std::size_t> open{node};
  while (!open.empty()) {
    const Node& next = nodes_[open.back()];
    open.pop_back();
    if (next.body) bodies.push_back(*next.body);
    open.insert(open.end(), next.children.begin(), next.children.end());
  }
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

std::vector<std::size_t> ProductTree::named(const std::string& name) const {
  std::vector<std::size_t> found;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    if (!name.empty() && endsInPath(nodes_[node].path, name)) found.push_back(node);
  }
  return found;
}

}  // namespace glissade
