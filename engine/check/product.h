#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/assembly/missing_shape.h"
#include "engine/assembly/product.h"
#include "engine/base/diagnostic.h"
#include "engine/check/body.h"

namespace glissade::check {

/// What a person says about a pair of bodies, named by id.
struct PairWord {
  std::string a;
  std::string b;
  std::string kind{};                 ///< as the file has it; empty: not said
  std::optional<double> allowance{};  ///< metres, >= 0; 0: clearance is required
  bool accepted = false;              ///< the pair's clash
  std::optional<double> pitch{};      ///< of a thread, metres; below 0: left-handed
  std::string turned{};               ///< of a thread: id of the body that is turned; empty: not said

  bool isThread() const { return kind == "thread"; }
};

/// What a person says of a snap: its hook bends while the body leaves.
struct SnapWord {
  std::string hook;                      ///< id of the body with the hook
  std::string edge;                      ///< id of the body that it is hooked into
  double bend = 0.0;                     ///< metres, > 0
  Vector3 direction = Vector3::UnitZ();  ///< unit, world frame: the way in which the body with the hook leaves
  bool byPlan = false;                   ///< a plan states it, and no person

  bool operator==(const SnapWord&) const = default;
};

/// What a person says of threads and inserts that come apart without a turn.
struct PartingWords {
  bool anyPair = false;                                      ///< joints are not used
  std::vector<std::pair<std::string, std::string>> pairs{};  ///< ids, the lesser first
};

struct FitWords {
  bool on = false;             ///< false: clearance is required of every pair
  double acceptedClash = 0.0;  ///< metres: clashes up to this overlap are accepted
  std::vector<PairWord> pairs{};
  std::vector<SnapWord> snaps{};
  PartingWords partings{};
  std::vector<std::string> cut{};  ///< bodies that are cut in accepted clashes: ids, or what follows a "/" in them

  bool isCut(const std::string& id) const;
  /// In either order; null: nothing is said.
  const PairWord* about(const std::string& a, const std::string& b) const;
  /// In either order; null: the pair is no snap.
  const SnapWord* snapOf(const std::string& a, const std::string& b) const;
  /// What a person says for which the pair may come apart without a turn, for people; empty: nothing.
  std::string partingOf(const std::string& a, const std::string& b) const;
  /// A person accepts a clash of this depth, metres, to a nanometre. `word`: about the pair; null: there is none.
  bool accepts(const PairWord* word, double depth) const {
    return (acceptedClash > 0.0 && depth <= acceptedClash + 1e-9) || (word != nullptr && word->accepted);
  }
};

/// What a person says of joints beside bends and partings; bodies by id.
struct JointWords {
  struct Pitch {
    std::string a;
    std::string b;
    double pitch = 0.0;  ///< metres a turn; below 0: left-handed
  };
  std::vector<std::string> flexible{};
  std::vector<std::vector<std::string>> units{};  ///< bodies that are handled as one
  std::vector<Pitch> pitches{};
};

/// Where a person forbids the object's reference point to be, world frame. The boxes are closed.
struct ForbiddenRegion {
  std::string place;
  std::vector<Box3> boxes;
};

/// What a person demands of the steps of a plan; bodies by id, or by the end of ids behind a "/", or by the name of a
/// node of the product's tree (bodiesMeant()).
struct Demands {
  struct Place {
    std::vector<std::string> bodies;
    std::size_t place = 1;  ///< from 1
  };
  struct Motion {
    std::vector<std::string> bodies;
    std::vector<Pose> path;
  };
  std::vector<std::vector<std::string>> together;
  std::vector<std::pair<std::string, std::string>> before;  ///< the first leaves before the second
  std::vector<Place> places;
  std::vector<Motion> motions;
  std::vector<std::pair<std::string, Vector3>> forbidden;  ///< a body and a direction
  std::vector<std::string> stay{};
};

/// The bodies of a product where it is assembled, and what a person says of them.
struct Product {
  std::vector<Body> bodies;
  FitWords fits;
  Demands demands{};
  glissade::Product tree{};  ///< assemblies that the bodies are in; it may have other bodies, too
  Warnings warnings{};       ///< of reading it
  JointWords joints{};
  MissingShapes missing{};  ///< that its files state and that are no bodies
  /// A person forbids places. Regions of a place hold for the object of a path, and for no part of a plan.
  bool forbidsPlaces = false;
};

/// What a path is asked for.
struct Question {
  Product product;                           ///< the object is the last body, at the start
  std::optional<Pose> goal{};                ///< nothing: anywhere clear of the others' bounding box
  Box3 workspace;                            ///< of the object's reference point
  std::vector<ForbiddenRegion> forbidden{};  ///< if a person forbids places and none is known, no path is valid
  double requiredClearance = 0.0;            ///< metres
  double contactGap = 0.0;                   ///< metres

  const Body& object() const { return product.bodies.back(); }
};

}  // namespace glissade::check
