#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace glissade {

/// The tree of a product: assemblies, and bodies as its leaves. Made of the bodies' paths (body_path.h); bodies are
/// known by their numbers. Immutable.
class ProductTree {
 public:
  struct Node {
    std::string path;                     ///< "pump/rotor"
    std::string name;                     ///< "rotor"
    std::optional<std::size_t> parent{};  ///< nothing: at the top
    std::vector<std::size_t> children{};  ///< in the order of their first bodies
    std::optional<std::size_t> body{};    ///< nothing: an assembly
  };

  /// Several bodies may have one path: each is a node of its own.
  explicit ProductTree(const std::vector<std::string>& paths);

  /// Parents before their children, in the order of the bodies.
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Numbers of the bodies that are the node or below it, ascending.
  std::vector<std::size_t> bodiesOf(std::size_t node) const;
  /// The nodes that a person means by a name: those whose path is it, or ends in it in whole names.
  std::vector<std::size_t> named(const std::string& name) const;

 private:
  using Assemblies = std::map<std::string, std::size_t>;  ///< numbers of nodes, by path
  std::size_t assemblyAt(const std::string& path, Assemblies& known);
  std::size_t addBelow(const std::string& path, Assemblies& known);

  std::vector<Node> nodes_;
};

}  // namespace glissade
