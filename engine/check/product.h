#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/diagnostic.h"
#include "engine/check/evidence_names.h"
#include "engine/evidence/body.h"
#include "engine/evidence/pair_words.h"
#include "engine/model/body_id.h"
#include "engine/model/missing_shape.h"
#include "engine/model/product.h"

namespace glissade::check {

/// A person's statements about joints, except bends and partings; bodies by id.
struct JointWords {
  struct Pitch {
    BodyId a;
    BodyId b;
    double pitch = 0.0;  ///< metres a turn; below 0: left-handed
  };
  std::vector<BodyId> flexible{};
  std::vector<std::vector<BodyId>> units{};  ///< bodies that are handled as one
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

  /// The body with the id; null: there is none.
  const Body* find(const BodyId& id) const {
    const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const Body& body) { return body.id == id; });
    return found == bodies.end() ? nullptr : &*found;
  }
  /// Its name for people, or the id if there is no such body.
  std::string nameOf(const BodyId& id) const {
    const Body* body = find(id);
    return body == nullptr ? id.text() : body->name;
  }
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
