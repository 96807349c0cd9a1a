#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/files/scenario.h"

namespace glissade {

/// An item that a person can place: a body, or the object at one of its ends.
struct AssemblyItem {
  enum class Kind { Body, Start, Goal };
  Kind kind = Kind::Body;
  BodyId bodyId;  ///< id of the scenario's body; empty for the ends

  friend bool operator==(const AssemblyItem&, const AssemblyItem&) = default;
};

/// The pose of an item; nothing where there is no such body, or the goal is "out".
std::optional<Pose> poseOf(const Scenario& scenario, const AssemblyItem& item);

/// Sets the pose of an item. Errors, also of the functions below: Usage, if there is no such body or the edit is
/// impossible for it.
Outcome place(const AssemblyItem& item, const Pose& X_WB, Scenario& scenario);

/// Removes a body, with the assets that no other body uses and the statements about its fits and joints.
Outcome removeBody(const BodyId& bodyId, Scenario& scenario);

/// leaveOut() keeps the body in the scenario, but not in the product, and removes the statements about its fits and
/// joints. putBack() returns the body to the product.
Outcome leaveOut(const BodyId& bodyId, Scenario& scenario);
Outcome putBack(const BodyId& bodyId, Scenario& scenario);

/// Renames a body; the assemblies of the product that contain it stay. Error: an empty name, or one with "/", which
/// separates assemblies.
Outcome renameBody(const BodyId& bodyId, const std::string& name, Scenario& scenario);

/// An edit of a body of the scenario, by its id.
using BodyEdit = Outcome (*)(const BodyId& bodyId, Scenario& scenario);

/// Applies an edit to the bodies in order, up to the first that fails.
template <class Ids>
Outcome editEach(const Ids& bodyIds, BodyEdit edit, Scenario& scenario) {
  for (const BodyId& id : bodyIds) {
    const Outcome edited = edit(id, scenario);
    if (!edited) return edited;
  }
  return Done{};
}

/// Exchanges start and goal of the object. Error if the goal is "out".
Outcome swapEnds(Scenario& scenario);

/// Makes the bodies the object, one rigid body that starts where they lie. The goal is "out", and the workspace grows
/// for it. Other bodies of the former object stop moving and stay where they started. Way points of the simulated
/// operator belong to the former object and are removed. The first body gives the object its id and its frame.
Outcome markMoving(const std::vector<BodyId>& bodyIds, const LoadedScenario& loaded, Scenario& scenario);

/// A workspace around all bodies, with room for the object to leave them on every side.
Box3 fittingWorkspace(const LoadedScenario& loaded);

/// True if the object consists of these bodies of the scenario, in any order.
bool isObject(const std::vector<BodyId>& bodyIds, const Scenario& scenario);

/// Copies the parts of a scenario that are edited step by step: the assembly, semantic attributes, the rules of
/// strategy "own", fits, joints. The rest (planner, parameters, seed, environment) is unchanged.
void takeAssembly(const Scenario& from, Scenario& to);

}  // namespace glissade
