#include "engine/assembly/product_tree.h"

#include <algorithm>

#include "engine/assembly/body_path.h"

namespace glissade {

ProductTree::ProductTree(const std::vector<std::string>& paths) {
  for (std::size_t body = 0; body < paths.size(); ++body) {
    Node leaf{paths[body], lastStepOf(paths[body])};
    leaf.body = body;
    const std::vector<std::string> above = assembliesAbove(paths[body]);
    if (!above.empty()) leaf.parent = assemblyAt(above.back());
    add(std::move(leaf));
  }
}

/// Made with those above it at the first call.
std::size_t ProductTree::assemblyAt(const std::string& path) {
  const auto known = assemblies_.find(path);
  if (known != assemblies_.end()) return known->second;
  Node assembly{path, lastStepOf(path)};
  const std::vector<std::string> above = assembliesAbove(path);
  if (!above.empty()) assembly.parent = assemblyAt(above.back());
  const std::size_t node = add(std::move(assembly));
  assemblies_.emplace(path, node);
  return node;
}

std::size_t ProductTree::add(Node node) {
  const std::size_t index = nodes_.size();
  (node.parent ? nodes_[*node.parent].children : roots_).push_back(index);
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
