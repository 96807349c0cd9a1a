#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/import/part_solids.h"
#include "engine/scenario/scenario.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// A product as it is loaded.
struct ProductFile {
  AssembledProduct product;
  double deviation = 0.0;              ///< metres that two surfaces may be off their triangles, together
  SequenceDemands demands;             ///< of a scenario, with what is known of its bodies
  std::vector<JointEdit> joints{};     ///< of a scenario: what a person says of joints
  std::vector<std::string> classes{};  ///< of a scenario: the class of each body; empty where it has none
  Warnings warnings;
  MissingShapes missing{};     ///< that the files state and that are no bodies; there is a warning of each
  bool forbidsPlaces = false;  ///< a scenario does; the places hold for the path of its object
  bool canOpen = false;        ///< the bodies of a part file are fewer than its solids: PartChoice can open them
};

/// The product of a scenario: its obstacles in their order, then its object at the start. Each body about its middle.
AssembledProduct productOf(const LoadedScenario& scenario);

/// The bodies as the file has them, however many: those of a part file (`file` as usualPart() takes it: a STEP file, an
/// assembly in one, a URDF or mesh file), or of a scenario with its object at the start. Fits are on for part files,
/// and as the scenario says. `deflection`: metres that triangles may be off the surfaces of a part file; 0: by the size
/// of each part. `choice`: of the parts of such a file. Errors: those of the importers and of chosenParts(),
/// Interrupted, and Usage where a deflection or a part to open is given for a scenario.
Result<ProductFile> readProduct(const std::string& file, const StopToken& stop = {}, double deflection = 0.0,
                                const PartChoice& choice = {});

/// The warning that a body is left out.
Diagnostic isLeftOut(const std::string& name);

/// Takes away the bodies that a person means by the names (bodiesMeant()), and what is said of their fits; the option
/// --without. A warning says which.
Outcome leaveOut(const std::vector<std::string>& names, ProductFile& loaded);

/// The same with each body about its middle, as what moves is. Errors: as of readProduct(), and MalformedInput where
/// there are less than two bodies.
Result<ProductFile> loadProduct(const std::string& file, const StopToken& stop = {}, double deflection = 0.0,
                                const PartChoice& choice = {});

}  // namespace glissade
