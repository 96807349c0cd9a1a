#pragma once

#include <string>
#include <vector>

#include "engine/files/scenario.h"

namespace glissade {

/// The bodies that do not move, then those of the object, then those that are left out.
std::vector<const BodyDescription*> allBodiesOf(const Scenario& scenario);

/// All bodies except those that are left out.
std::vector<const BodyDescription*> presentBodiesOf(const Scenario& scenario);

/// Displayed names of the bodies that are left out, in their order.
std::vector<std::string> shownLeftOut(const Scenario& scenario);

/// Geometries of all bodies.
std::vector<const Geometry*> geometriesOf(const Scenario& scenario);

/// Ids of all bodies and assemblies, which can have attributes.
std::vector<std::string> nodeIdsOf(const Scenario& scenario);

/// Name of the object in files about it: the ids of its bodies, joined by "+".
std::string idOf(const ObjectDescription& object);

/// True if a body of the object has this id.
bool isInObject(const LoadedScenario& loaded, const BodyId& rigidId);

/// The value for a rigid body, by its id; 0 where there is none.
double valueOf(const std::map<BodyId, double>& values, const BodyId& id);
/// The largest value of these bodies.
double largestOf(const std::map<BodyId, double>& values, const std::vector<RigidBody>& bodies);

/// The rigid bodies of the product: those of the obstacles in their order, then those of the object at its start.
std::vector<RigidBody> rigidBodiesOf(const LoadedScenario& loaded);
/// The rigid body with this index among them.
const RigidBody& rigidBodyAt(std::size_t body, const LoadedScenario& loaded);

}  // namespace glissade
