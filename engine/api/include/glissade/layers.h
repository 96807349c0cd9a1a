#pragma once

#include <glissade/export.h>
#include <glissade/scenario.h>
#include <glissade/stop_token.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace glissade::api {

/// Value of a semantic attribute.
using AttributeValue = std::variant<bool, double, std::string>;
/// Values of semantic attributes by their names.
using Attributes = std::map<std::string, AttributeValue>;

/// The bodies that a cell of the octree intersects (paper 2, section 3.2).
enum class CellKind : std::uint8_t {
  Free,    ///< none
  Mobile,  ///< mobile bodies only
  Static   ///< at least one static body
};

/// The leaves of the octree, in the order of the Z-curve. The vectors have the same length.
struct OctreeCells {
  std::vector<Vector3> centres{};  ///< metres, world frame
  std::vector<double> sizes{};     ///< edges of the cubes, metres
  std::vector<CellKind> kinds{};   ///< what clutters each cell
};

/// A region of similar narrowness (paper 2, section 3.2). Its number is its index in Layers::places().
struct Place {
  std::string name{};                ///< "P1", ..., or the name that a person gave
  Box box{};                         ///< bounding box of its cells, world frame
  std::vector<Box> boxes{};          ///< boxes that cover exactly its cells, world frame
  Vector3 anchor = Vector3::Zero();  ///< its widest point, world frame
  double narrowness = 0.0;           ///< diameter of the largest ball about the anchor, metres
  int complexity = 1;                ///< 1 for the widest places; one more for each halving of the narrowness
  bool passage = false;              ///< true for a doorway
  double volume = 0.0;               ///< cubic metres
  Attributes attributes{};           ///< the values in force of all attributes of places
};

/// The overlap of two places.
struct Border {
  std::string name{};                   ///< "B1-6"
  std::array<std::size_t, 2> places{};  ///< numbers of the places
  Vector3 centre = Vector3::Zero();     ///< centre of the faces that they share, world frame
  Vector3 normal = Vector3::UnitX();    ///< unit, from the first place to the second one, world frame
  double opening = 0.0;                 ///< area of the shared faces, square metres
};

/// The topological graph of a query (paper 2, section 3.2).
struct TopologicalGraph {
  /// The start ("S"), the goal ("G") or a border.
  struct Node {
    std::string name{};                   ///< "S", "G" or the name of the border
    std::optional<std::size_t> border{};  ///< number of the border; nothing for "S" and "G"
    Vector3 position = Vector3::Zero();   ///< metres, world frame
    double cost = 0.0;                    ///< C_n of equation (1), which a strategy's rule gives
  };
  /// The crossing of a place between two of its borders.
  struct Edge {
    std::size_t from = 0;   ///< index of a node
    std::size_t to = 0;     ///< index of a node
    std::size_t place = 0;  ///< number of the place
    double distance = 0.0;  ///< metres
    double cost = 0.0;      ///< C_e of equation (1), which a strategy's rule gives; infinite for a forbidden place
  };
  std::vector<Node> nodes{};  ///< "S", "G", then the borders
  std::vector<Edge> edges{};  ///< one for each direction
};

/// Chooses the planners that cross a place.
struct FineRule {
  std::string when{};        ///< condition over distance, size, place.* and object.*, such as "place.complexity > 2"
  bool geometrical = false;  ///< the geometrical planner reduces the place first
  std::string local{};       ///< id of the local planner, such as "rrt" or "linear"
};

/// The rules of a multi-layer strategy: expressions over semantic attributes (paper 2, section 4). `size` is the
/// largest extent of the workspace, metres.
struct Rules {
  std::string node = "0";         ///< f of equation (1), over size, a.*, b.* (the places that meet) and object.*
  std::string edge = "distance";  ///< g of equation (1), over distance, size, place.* and object.*
  std::vector<FineRule> fine{{"1", false, "rrt"}};  ///< the first one that holds decides; the last one is "1"
  bool loop = false;                                ///< after a failed step the next best coarse path is tried
  bool fitted = false;                              ///< passages are crossed in the configuration that fits best
};

/// A place to cross and a border to reach (paper 2, section 4.1).
struct CoarseStep {
  std::size_t place = 0;                ///< number of the place
  std::optional<std::size_t> border{};  ///< number of the border to reach; nothing: the goal
  std::string placeName{};              ///< name of the place
  std::string borderName{};             ///< name of the border; "G" for the goal
  Pose to{};                            ///< the milestone; its position is an estimate where `decided` is false
  bool decided = false;                 ///< the milestone is the goal or a person's
  std::string planner{};                ///< id of the local planner
  bool geometrical = false;             ///< the geometrical planner reduces the place first
  std::string reason{};                 ///< why these planners were chosen, for people
};

/// The cheapest way through the places, before anything is planned finely.
struct CoarsePlan {
  std::string strategy{};             ///< id of the strategy
  Rules rules{};                      ///< its rules
  TopologicalGraph graph{};           ///< the graph with the costs of these rules
  std::vector<std::size_t> nodes{};   ///< nodes of the graph from "S" to "G"; empty: there is no way
  double cost = 0.0;                  ///< sum of the costs on the way
  std::vector<CoarseStep> steps{};    ///< the places to cross, in order
  std::vector<std::string> closed{};  ///< places and borders of infinite cost, where there is no way
};

/// Options of Layers::make(). Nothing: as the scenario says, or the usual value.
struct LayerOptions {
  std::optional<double> cellSize{};         ///< edge of the finest cells, metres; 0: by memory
  std::optional<double> memory{};           ///< memory of the octree, MiB
  std::optional<int> topologyLevel{};       ///< level of the cells of places
  std::optional<std::string> identifier{};  ///< how places are found: "region-growing" or "watershed"
  StopToken stop{};                         ///< ends the work
};

/// A semantic attribute of places that is added from outside. The kind of its values is that of `initial`.
struct AttributeDefinition {
  std::string name{};                  ///< name in rules, "place.<name>": lower-case letters, digits and '_'
  AttributeValue initial = 0.0;        ///< value where no other is known
  double minimum = -1e9;               ///< least number
  double maximum = 1e9;                ///< largest number
  std::vector<std::string> choices{};  ///< the possible texts; empty: any
};

/// Computes the value of an attribute of a place.
using PlaceFunction = std::function<AttributeValue(const Place&)>;

/// The layers of paper 2 for a problem: octree, places and borders, semantic attributes, rules. Immutable; copies share
/// everything; any thread may read it. The functions with... return changed layers.
class GLISSADE_EXPORT Layers {
 public:
  /// Computes the layers of a problem. Static bodies shape the places, mobile bodies clutter them; bodies of
  /// World::make() are static. Errors: an option out of range (MalformedInput), Interrupted.
  static Result<Layers> make(const Problem& problem, const LayerOptions& options = {});

  /// The geometrical layer.
  OctreeCells cells() const;
  /// The topological layer with the semantic attributes.
  std::vector<Place> places() const;
  /// The borders of the places.
  std::vector<Border> borders() const;
  /// The values in force of all attributes of a body or of the object. Error (Usage): an unknown id.
  Result<Attributes> ofBody(const std::string& id) const;
  /// Id of the object among the bodies.
  std::string objectId() const;

  /// Sets an attribute of a place. Errors: no such place (Usage); an unknown attribute, a value of another kind, NaN or
  /// out of range (MalformedInput).
  Result<Layers> withPlaceValue(std::size_t place, const std::string& name, const AttributeValue& value) const;
  /// Sets an attribute of a body or of the object. A changed "mobility" computes the places anew. Errors: as above.
  Result<Layers> withBodyValue(const std::string& id, const std::string& name, const AttributeValue& value,
                               const StopToken& stop = {}) const;
  /// Adds an attribute of places. `compute` is called once for each place; empty: all have the initial value. Errors
  /// (MalformedInput): a name that is no word or exists, a value of another kind, NaN or out of range.
  Result<Layers> withAttribute(const AttributeDefinition& definition, const PlaceFunction& compute = {}) const;
  /// Sets the rules of the strategy "own". Error (MalformedInput): a rule that does not parse or names what does not
  /// exist, with its place.
  Result<Layers> withRules(const Rules& rules) const;

  /// The rules of a strategy: "gt", "gts1", "gts2", "gts" or "own". Error (Usage): another strategy.
  Result<Rules> rules(const std::string& strategy) const;
  /// The coarse plan that a run of the strategy begins with. Errors: another strategy than those of rules() (Usage), a
  /// rule that gives a negative cost (MalformedInput), no configuration outside (NoPath).
  Result<CoarsePlan> coarsePlan(const std::string& strategy = "gts") const;
  /// The problem with these layers, for plan(), Session and check().
  Problem problem() const;

  /// Private data.
  struct Impl;
  /// For the library.
  explicit Layers(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  Layers(const Layers&) = default;             ///< shares everything
  Layers& operator=(const Layers&) = default;  ///< shares everything
  /// For the library.
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glissade::api
