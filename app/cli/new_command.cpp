#include "app/cli/commands.h"

#include "app/cli/text_cells.h"
#include "engine/files/assembly_edits.h"
#include "engine/files/asset_path.h"
#include "engine/files/product_file.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_file.h"
#include "engine/files/scenario_fits.h"
#include "engine/files/scenario_product.h"
#include "engine/files/unit_guess.h"
#include "engine/import/mesh_import.h"
#include "engine/model/body_choice.h"
#include "engine/planning/automatic/move_to_clearance.h"

namespace glissade::cli {
namespace {

std::vector<PartFile> partsOf(const NewOptions& options) {
  std::vector<PartFile> parts;
  const auto add = [&](const std::string& file, PartRole role) {
    PartFile part = usualPart(file);
    part.role = role;
    part.deflection = options.deflection;
    part.groups = part.groups || (options.groups && mayHaveGroups(part.path));
    part.closeHoles = options.closeHoles && isMeshFile(part.path);
    if (!saysItsUnit(part.path)) {
      part.unit = options.unit.value_or(part.unit);
      part.up = options.up.value_or(part.up);
    }
    parts.push_back(part);
  };
  for (const std::string& file : options.moving) add(file, PartRole::Moves);
  for (const std::string& file : options.statics) add(file, PartRole::Static);
  for (const std::string& file : options.mobiles) add(file, PartRole::Mobile);
  return parts;
}

/// Moves the start clear of other bodies and returns by how many millimetres.
Result<double> clearStart(const LoadedScenario& loaded, Scenario& scenario) {
  const Pose& start = loaded.problem.start;
  const auto clear = moveToClearance(wholeWorld(loaded), start, loaded.parameters[ParameterId::RequiredClearance]);
  if (!clear)
    return Diagnostic{clear.error().kind, "", GLISSADE_TEXT("start"), clear.error().reason, clear.error().advice};
  scenario.start = *clear;
  return 1000.0 * (clear->position - start.position).norm();
}

/// Leaves the named bodies out and warns of each. The scenario keeps them as left out. The part that moves cannot be
/// left out.
Outcome leaveOut(const NewOptions& options, Scenario& scenario) {
  if (options.without.empty()) return Done{};
  std::vector<BodyId> ids;
  for (const BodyDescription* body : presentBodiesOf(scenario)) ids.push_back(body->id);
  const auto meant = bodiesMeant(ids, options.without, "--without", treeOf(scenario));
  if (!meant) return meant.error();
  const std::size_t others = scenario.bodies.size();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!(*meant)[i]) continue;
    if (i >= others) {
      return Diagnostic{ErrorKind::Usage, "", "--without", GLISSADE_TEXT("names the moving part"),
                        GLISSADE_TEXT("Name another body.")};
    }
    if (const Outcome left = glissade::leaveOut(ids[i], scenario); !left) return left;
    reportWarnings({isLeftOut(scenario.leftOut.back().name)}, options.console);
  }
  return Done{};
}

}  // namespace

int runNew(const NewOptions& options) {
  GeometryCache read;
  std::vector<PartFile> parts = partsOf(options);
  if (!options.unit) {
    const auto guessed = guessUnits(parts, read);
    if (!guessed) return reportError(guessed.error(), options.console);
    reportWarnings(*guessed, options.console);
  }
  auto scenario = scenarioOfParts(parts, &read);
  if (!scenario) return reportError(scenario.error(), options.console);
  if (const Outcome left = leaveOut(options, *scenario); !left) return reportError(left.error(), options.console);
  if (options.fits.acceptedClash == kAdvisedClashes) {
    return reportError({ErrorKind::Usage, "", "--accept-clashes", GLISSADE_TEXT("'advised' is not kept in a scenario"),
                        GLISSADE_TEXT("Give a length, as 1.5mm.")},
                       options.console);
  }
  options.fits.applyTo(scenario->fits);
  const auto loaded = loadGeometry(*scenario, ".", "", read);
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  if (!options.clear) reportWarnings(loaded->fits.warnings, options.console);
  if (options.clear) {
    const auto gone = clearStart(*loaded, *scenario);
    if (!gone) return reportError(gone.error(), options.console);
    if (*gone > 0.0) options.console.print({GLISSADE_TEXT("start moved clear by %1 mm"), {rounded(*gone)}});
  }
  const SaveResult saved =
      saveScenarioFile(movedTo(options.output, std::move(*scenario), ""), options.output, std::nullopt);
  if (!saved) return reportError(saved.why, options.console);
  reportWarnings(saved.warnings, options.console);
  options.console.print({GLISSADE_TEXT("wrote %1"), {options.output}});
  return 0;
}

}  // namespace glissade::cli
