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

/// A person's statement about a pair of bodies, named by id.
struct PairWord {
  std::string a;
  std::string b;
  std::string kind{};                 ///< kind as in the file; empty: not stated
  std::optional<double> allowance{};  ///< metres, >= 0; 0: clearance is required
  bool accepted = false;              ///< the clash of the pair is accepted
  std::optional<double> pitch{};      ///< pitch of a thread, metres; below 0: left-handed
  std::string turned{};               ///< id of the body that is turned in a thread; empty: not stated

  bool isThread() const { return kind == "thread"; }
};

/// A person's statement about a snap: its hook bends while the body leaves.
struct SnapWord {
  std::string hook;                      ///< id of the body with the hook
  std::string edge;                      ///< id of the body that it is hooked into
  double bend = 0.0;                     ///< metres, > 0
  Vector3 direction = Vector3::UnitZ();  ///< unit, world frame: exit direction of the body with the hook
  bool byPlan = false;                   ///< only a plan states it

  bool operator==(const SnapWord&) const = default;
};

/// A person's statements about threads and inserts that come apart without a turn.
struct PartingWords {
  bool anyPair = false;                                      ///< joints are not used
  std::vector<std::pair<std::string, std::string>> pairs{};  ///< ids, the lesser first
};

struct FitWords {
  bool on = false;             ///< false: each pair has to keep the clearance
  double acceptedClash = 0.0;  ///< metres: clashes up to this overlap are accepted
  std::vector<PairWord> pairs{};
  std::vector<SnapWord> snaps{};
  PartingWords partings{};
  std::vector<std::string> cut{};  ///< bodies that are cut in accepted clashes: ids, or the ends of ids behind a "/"

  bool isCut(const std::string& id) const;
  /// The statement about the pair in either order; null: there is none.
  const PairWord* about(const std::string& a, const std::string& b) const;
  /// The snap of the pair in either order; null: the pair is no snap.
  const SnapWord* snapOf(const std::string& a, const std::string& b) const;
  /// The statement by which the pair may come apart without a turn, for people; empty: none.
  Message partingOf(const std::string& a, const std::string& b) const;
  /// True if a person accepts a clash of this depth, metres, to a nanometre. `word`: the statement about the pair, or
  /// null.
  bool accepts(const PairWord* word, double depth) const {
    return (acceptedClash > 0.0 && depth <= acceptedClash + 1e-9) || (word != nullptr && word->accepted);
  }
};

/// A person's statements about joints, except bends and partings; bodies by id.
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

/// Boxes in which a person forbids the object's reference point to be, world frame. The boxes are closed.
struct ForbiddenRegion {
  std::string place;
  std::vector<Box3> boxes;
};

/// A person's demands on the steps of a plan. Bodies by id, by the end of ids behind a "/", or by the name of a node of
/// the product's tree (bodiesMeant()).
struct Demands {
  struct Place {
    std::vector<std::string> bodies;
    std::size_t place = 1;  ///< number of the step, from 1
  };
  struct Motion {
    std::vector<std::string> bodies;
    std::vector<Pose> path;
  };
  std::vector<std::vector<std::string>> together;
  std::vector<std::pair<std::string, std::string>> before;  ///< the first body leaves before the second
  std::vector<Place> places;
  std::vector<Motion> motions;
  std::vector<std::pair<std::string, Vector3>> forbidden;  ///< a body and a direction
  std::vector<std::string> stay{};
};

/// The assembled bodies of a product, and a person's statements about them.
struct Product {
  std::vector<Body> bodies;
  FitWords fits;
  Demands demands{};
  glissade::Product tree{};  ///< assemblies that contain the bodies; it may have other bodies, too
  Warnings warnings{};       ///< warnings from reading it
  JointWords joints{};
  MissingShapes missing{};  ///< shapes of its files that are not read as bodies
  /// True if a person forbids places. The regions hold for the object of a path, and not for the parts of a plan.
  bool forbidsPlaces = false;
};

/// The task that a path has to solve.
struct Question {
  Product product;                           ///< the object is the last body, at the start
  std::optional<Pose> goal{};                ///< nothing: any configuration clear of the others' bounding box
  Box3 workspace;                            ///< region of the object's reference point
  std::vector<ForbiddenRegion> forbidden{};  ///< if a person forbids places and none is known, no path is valid
  double requiredClearance = 0.0;            ///< metres
  double contactGap = 0.0;                   ///< metres

  const Body& object() const { return product.bodies.back(); }
};

}  // namespace glissade::check
