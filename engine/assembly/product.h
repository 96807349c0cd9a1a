#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/assembly/attributes.h"

namespace glissade {

/// Where something is in the tree of a file.
struct TreePlace {
  std::string path;                  ///< steps, joined by "/" (body_path.h)
  std::vector<std::string> names{};  ///< as of Occurrence: those of the steps; empty: the steps themselves
  double unit = 0.0;                 ///< as of Occurrence
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
  std::optional<std::string> name{};  ///< as the CAD file has it; nothing: the last step of its path
  std::optional<std::string> in{};    ///< id of the assembly that it is in, empty: none; nothing: as its path says
  Attributes attributes{};            ///< of an assembly, for all bodies below it

  friend bool operator==(const NodeDescription&, const NodeDescription&) = default;
};

/// The tree of a product: assemblies, and bodies below them. Immutable.
class Product {
 public:
  struct Node {
    std::string id;                       ///< stable, each once
    std::string path;                     ///< of steps: "pump/rotor"
    std::string name;                     ///< as the file has it: may be empty, hold a "/", be that of a sibling
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
  /// The nodes that a person means by a name: those that have it as id or whose path ends in it; where there are none,
  /// those whose names in the file end in it.
  std::vector<std::size_t> named(const std::string& name) const;
  /// What people see of each node below its parent: its name, or the last step of its path where the name is empty or
  /// that of a sibling.
  std::vector<std::string> shownNames() const;
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
