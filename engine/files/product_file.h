#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/files/scenario.h"
#include "engine/import/part_solids.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// A loaded product.
struct ProductFile {
  AssembledProduct product;
  double deviation = 0.0;              ///< largest distance of two surfaces from their triangles, added up, metres
  SequenceDemands demands;             ///< demands of a scenario, including the attributes of its bodies
  std::vector<JointEdit> joints{};     ///< a person's statements about joints in a scenario
  std::vector<std::string> classes{};  ///< class of each body of a scenario; empty where it has none
  Warnings warnings;
  MissingShapes missing{};     ///< shapes in the files that are no bodies; there is a warning of each
  bool forbidsPlaces = false;  ///< true for a scenario that forbids places, which holds for the path of its object
};

/// The product of a scenario: its obstacles in their order, then its object at the start. Each body's frame is in its
/// middle.
AssembledProduct productOf(const LoadedScenario& scenario);

/// All bodies of a loaded scenario with its object at the start, and its demands. Errors: those of knownDemands().
Result<ProductFile> productFileOf(const LoadedScenario& scenario);

/// All bodies of the file: those of a part file (`file` as in usualPart(): a STEP file, an assembly in one, a URDF or
/// mesh file), or those of a scenario with its object at the start. Fits are on for part files; for scenarios the file
/// decides. `deflection`: largest distance of triangles from the surfaces of a part file, metres; 0: by the size of
/// each part. `choice`: choice among the parts of such a file. Errors: those of the importers and of chosenParts(),
/// Interrupted, and Usage where a deflection or a part to split is given for a scenario.
Result<ProductFile> readProduct(const std::string& file, const StopToken& stop = {}, double deflection = 0.0,
                                const PartChoice& choice = {});

/// The warning that a body is left out.
Diagnostic isLeftOut(const std::string& name);

/// Removes the bodies that a person names (bodiesMeant()), and the statements about their fits; the option --without. A
/// warning lists them.
Outcome leaveOut(const std::vector<std::string>& names, ProductFile& loaded);

/// The joints of the product that are found, changed as the scenario says. `confirmsSuggested`: suggested joints count
/// as if a person had confirmed each of them. Errors: those of applied(), Interrupted.
Result<Joints> jointsOf(const ProductFile& loaded, bool confirmsSuggested, const StopToken& stop = {});

/// Like readProduct(), with each body's frame in its middle, as for the object. Errors: those of readProduct(), and
/// MalformedInput where there are less than two bodies.
Result<ProductFile> loadProduct(const std::string& file, const StopToken& stop = {}, double deflection = 0.0,
                                const PartChoice& choice = {});

}  // namespace glissade
