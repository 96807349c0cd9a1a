#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/assembly/attributes.h"
#include "engine/assembly/node_names.h"

namespace glissade {

/// Where something is in the tree of a file.
struct TreePlace {
  std::string path;                ///< steps, joined by "/" (body_path.h)
  std::vector<NodeNames> names{};  ///< as of Occurrence: those of the steps; empty: the steps themselves
  double unit = 0.0;               ///< as of Occurrence
};

/// A body, for making a product of it.
struct ProductBody {
  std::string id;  ///< each once
  TreePlace place;
  /// Where it is several rigid bodies: their places below it. The id of each is "<id>/<path>".
  std::vector<TreePlace> parts{};
};

/// What a scenario says of a node beside what the paths of its bodies say.
struct NodeDescription {
  std::string id;                     ///< of an assembly or a body
  std::optional<std::string> name{};  ///< of the product in the CAD file; nothing: the last step of its path
  std::optional<std::string> in{};    ///< id of the assembly that it is in, empty: none; nothing: as its path says
  Attributes attributes{};            ///< of an assembly, for all bodies below it
  std::string occurrence{};           ///< as of NodeNames
  std::string designator{};           ///< as of NodeNames

  friend bool operator==(const NodeDescription&, const NodeDescription&) = default;
};

/// The tree of a product: assemblies, and bodies below them. Immutable.
class Product {
 public:
  struct Node {
    std::string id;                       ///< stable, each once
    std::string path;                     ///< of steps: "pump/rotor"
    NodeNames names;                      ///< as the file has them
    std::optional<std::size_t> parent{};  ///< nothing: at the top
    std::vector<std::size_t> children{};  ///< in the order of their first bodies
    bool isAssembly = false;              ///< else it is a body, or one of its rigid bodies
    Attributes attributes{};              ///< what is said of an assembly
    double unit = 0.0;                    ///< metres: that of lengths in the file of a body; 0: not stated
  };

  Product() = default;
  /// Assemblies are those that the places name, and those that are said. An assembly whose path is the id of a body has
  /// another id. What is said of other nodes counts for nothing.
  explicit Product(const std::vector<ProductBody>& bodies, const std::vector<NodeDescription>& said = {});

  /// Parents before their children, in the order of the bodies.
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Nothing where no node has the id.
  std::optional<std::size_t> find(const std::string& id) const;
  /// Ids of the rigid bodies that are the node or below it, in the order of the nodes.
  std::vector<std::string> bodiesBelow(std::size_t node) const;
  /// The assemblies that a node is in, the outermost first.
  std::vector<std::size_t> assembliesAbove(std::size_t node) const;
  /// The nodes that a person means by a name: the one that has it as id; else those whose shown names on the way to
  /// them end in it; else those whose path does; else those that the file calls so. "#2" is the second body.
  std::vector<std::size_t> named(const std::string& name) const;
  /// The name that people see of each node below its parent: shownName(), or the last step of its path if that is
  /// empty. The second of two siblings with one name is "pin#2".
  std::vector<std::string> shownNames() const;
  /// The shown names on the way to each node, and its own, joined by "/".
  std::vector<std::string> shownPaths() const;
  /// The name that people see of each of the nodes with these ids, in a list of these nodes alone. It is the shortest
  /// end of the node's shown path that no other one of them has, or the whole path. An id of no node is its own label.
  std::vector<std::string> labels(const std::vector<std::string>& ids) const;
  /// Metres: the unit that most of its bodies state lengths in, the first of equally many; 0: none states one.
  double lengthUnit() const;

 private:
  friend class ProductMaker;

  std::vector<Node> nodes_;
  std::map<std::string, std::size_t> byId_;
};

/// The bodies that a person means by a name: those of the nodes of that name, by their ids.
std::vector<std::string> bodiesMeant(const Product& product, const std::string& name);

}  // namespace glissade
