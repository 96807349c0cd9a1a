#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/attributes.h"
#include "engine/model/body_id.h"
#include "engine/model/node_names.h"

namespace glissade {

/// A place in the tree of a file.
struct TreePlace {
  std::string path;                ///< steps, joined by "/" (body_path.h)
  std::vector<NodeNames> names{};  ///< see Occurrence::names; names of the steps; empty: equal to the steps
  double unit = 0.0;               ///< see Occurrence::unit
};

/// A body from which a product is made.
struct ProductBody {
  BodyId id;
  TreePlace place;
  /// Places below `place` of its rigid bodies, if there are several. The id of each is "<id>/<path>".
  std::vector<TreePlace> parts{};
};

/// Statements of a scenario about a node, in addition to the paths of its bodies.
struct NodeDescription {
  std::string id;                     ///< id of an assembly or a body
  std::optional<std::string> name{};  ///< name of the product in the CAD file; nothing: the last step of its path
  std::optional<std::string> in{};  ///< id of the assembly that contains it, empty: none; nothing: the one of its path
  Attributes attributes{};          ///< attributes of an assembly, for all bodies below it
  std::string occurrence{};         ///< see NodeNames::occurrence
  std::string designator{};         ///< see NodeNames::designator

  friend bool operator==(const NodeDescription&, const NodeDescription&) = default;
};

/// The tree of a product: assemblies, and bodies below them. Immutable.
class Product {
 public:
  struct Node {
    std::string id;                       ///< stable and unique
    std::string path;                     ///< steps: "pump/rotor"
    NodeNames names;                      ///< names in the file
    std::optional<std::size_t> parent{};  ///< nothing for a node at the top
    std::vector<std::size_t> children{};  ///< in the order of their first bodies
    bool isAssembly = false;              ///< false: a body, or one of its rigid bodies
    Attributes attributes{};              ///< stated attributes of an assembly
    double unit = 0.0;                    ///< metres: unit of lengths in the file of a body; 0: not stated
  };

  Product() = default;
  /// Assemblies are made for the places and the descriptions. An assembly whose path is the id of a body gets another
  /// id. Descriptions of other nodes are ignored.
  explicit Product(const std::vector<ProductBody>& bodies, const std::vector<NodeDescription>& said = {});

  /// Parents before their children, in the order of the bodies.
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Nothing if no node has the id.
  std::optional<std::size_t> find(const std::string& id) const;
  /// Ids of the rigid bodies at the node or below it, in the order of the nodes.
  std::vector<BodyId> bodiesBelow(std::size_t node) const;
  /// The assemblies that contain a node, the outermost first.
  std::vector<std::size_t> assembliesAbove(std::size_t node) const;
  /// The nodes that a person means by a name: the node with this id; else those whose shown path ends in it; else those
  /// whose path ends in it; else those with this name in the file. "#2" is the second body.
  std::vector<std::size_t> named(const std::string& name) const;
  /// The name for people of each node below its parent: shownName(), or the last step of its path if that is empty. The
  /// second of two siblings with one name is "pin#2".
  std::vector<std::string> shownNames() const;
  /// The shown names on the path to each node, including the node's, joined by "/".
  std::vector<std::string> shownPaths() const;
  /// The names for people of the nodes with these ids, in a list of these nodes only. A name is the shortest end of the
  /// node's shown path that no other one of them has, or the whole path. An id of no node is its own label.
  std::vector<std::string> labels(const std::vector<std::string>& ids) const;
  /// The unit of length that most of its bodies state, metres; the first of equally frequent ones; 0: none states one.
  double lengthUnit() const;

 private:
  friend class ProductMaker;

  std::vector<Node> nodes_;
  std::map<std::string, std::size_t> byId_;
};

/// The bodies that a person means by a name: the bodies of the nodes with that name, by their ids.
std::vector<BodyId> bodiesMeant(const Product& product, const std::string& name);

}  // namespace glissade
