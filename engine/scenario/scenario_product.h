#pragma once

#include "engine/import/asset.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// What bodies are made of, by their ids.
using BodyGeometry = std::map<std::string, LoadedGeometryPtr>;

/// The product of a scenario: its bodies in the order of allBodiesOf(), in the assemblies that their names and the
/// scenario say. A body of several parts has them below it where its geometry is given.
Product treeOf(const Scenario& scenario, const BodyGeometry& geometry = {});

/// What is wrong with what the scenario says of its nodes, with a JSON pointer into it: an id twice, a node that there
/// is not, attributes of a body, assemblies that hold each other.
Outcome checkNodes(const Scenario& scenario);

/// Forgets what is said of nodes that there are no more.
void dropUnknownNodes(Scenario& scenario);

}  // namespace glissade
