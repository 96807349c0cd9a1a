#pragma once

#include "engine/files/scenario.h"
#include "engine/import/asset.h"

namespace glissade {

/// Geometries of bodies, by their ids.
using BodyGeometry = std::map<BodyId, LoadedGeometryPtr>;

/// The product of a scenario: its bodies in the order of allBodiesOf(), in the assemblies that their names and the
/// scenario give. The parts of a body with several parts are below it where its geometry is given.
Product treeOf(const Scenario& scenario, const BodyGeometry& geometry = {});

/// Whether a scenario is about a product: parts of a CAD file, or a part that is to be removed.
bool isAboutProduct(const Scenario& scenario);

/// Checks the nodes of a scenario. Errors have a JSON pointer: a duplicate id, an unknown node, attributes of a body,
/// assemblies that contain each other.
Outcome checkNodes(const Scenario& scenario);

/// Removes the descriptions of nodes that do not exist any more.
void dropUnknownNodes(Scenario& scenario);

}  // namespace glissade
