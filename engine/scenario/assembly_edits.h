#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// What a person can put somewhere: a body, or the object at one of its ends.
struct AssemblyItem {
  enum class Kind { Body, Start, Goal };
  Kind kind = Kind::Body;
  std::string bodyId;  ///< of the scenario's body; empty for the ends

  friend bool operator==(const AssemblyItem&, const AssemblyItem&) = default;
};

/// Nothing where there is no such body, or the goal is "out".
std::optional<Pose> poseOf(const Scenario& scenario, const AssemblyItem& item);

/// Puts it there. Errors (here and below): Usage, there is no such body, or it cannot be.
Outcome place(const AssemblyItem& item, const Pose& X_WB, Scenario& scenario);

/// Takes a body out, with the assets that nothing else uses and what was said about its fits and joints.
Outcome removeBody(const std::string& bodyId, Scenario& scenario);

/// The body stays in the scenario and is not there: what was said about its fits and joints goes. And back.
Outcome leaveOut(const std::string& bodyId, Scenario& scenario);
Outcome putBack(const std::string& bodyId, Scenario& scenario);

/// What is done to a body of the scenario, by its id.
using BodyEdit = Outcome (*)(const std::string& bodyId, Scenario& scenario);

/// Edits one body after the other, up to the first that fails.
template <class Ids>
Outcome editEach(const Ids& bodyIds, BodyEdit edit, Scenario& scenario) {
  for (const std::string& id : bodyIds) {
    const Outcome edited = edit(id, scenario);
    if (!edited) return edited;
  }
  return Done{};
}

/// The object starts where its goal was, and the other way round. Not where the goal is "out".
Outcome swapEnds(Scenario& scenario);

/// The bodies become the object, as one rigid body, from where they lie and to "out", for which the workspace grows;
/// the other bodies that were the object do not move any more, and stay where they started. Way points of the simulated
/// operator go with their object. The first one gives the object its id and its frame.
Outcome markMoving(const std::vector<std::string>& bodyIds, const LoadedScenario& loaded, Scenario& scenario);

/// A workspace about all that there is, with room for the object to get clear of it on every side.
Box3 fittingWorkspace(const LoadedScenario& loaded);

/// The object is made of these bodies of the scenario, in any order.
bool isObject(const std::vector<std::string>& bodyIds, const Scenario& scenario);

/// Takes over what is edited step by step: the assembly, semantic attributes, the rules of strategy "own", fits,
/// joints. The rest (planner, parameters, seed, environment) stays as it is.
void takeAssembly(const Scenario& from, Scenario& to);

}  // namespace glissade
