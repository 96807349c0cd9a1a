#pragma once

#include <string>
#include <vector>

#include "engine/scenario/scenario.h"

namespace glissade {

/// The bodies that do not move, then those of the object, then those that are left out.
std::vector<const BodyDescription*> allBodiesOf(const Scenario& scenario);

/// The same without those that are left out.
std::vector<const BodyDescription*> presentBodiesOf(const Scenario& scenario);

/// What they are made of.
std::vector<const Geometry*> geometriesOf(const Scenario& scenario);

/// Ids of all bodies and assemblies: what attributes can be said of.
std::vector<std::string> nodeIdsOf(const Scenario& scenario);

/// What the object is called in files about it: the ids of its bodies, joined by "+".
std::string idOf(const ObjectDescription& object);

/// A body of the object has this id.
bool isInObject(const LoadedScenario& loaded, const std::string& rigidId);

/// What is known of a rigid body, by its id; 0 where nothing is.
double valueOf(const std::map<std::string, double>& values, const std::string& id);
/// The largest of these bodies.
double largestOf(const std::map<std::string, double>& values, const std::vector<RigidBody>& bodies);

/// The rigid bodies of the product: those of the obstacles in their order, then those of the object at its start.
std::vector<RigidBody> rigidBodiesOf(const LoadedScenario& loaded);
/// The one of this number among them.
const RigidBody& rigidBodyAt(std::size_t body, const LoadedScenario& loaded);

}  // namespace glissade
