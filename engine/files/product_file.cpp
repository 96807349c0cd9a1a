#include "engine/files/product_file.h"

#include <algorithm>
#include <functional>

#include "engine/evidence/place_copies.h"
#include "engine/files/part_files.h"
#include "engine/files/scenario_fits.h"
#include "engine/files/scenario_io.h"
#include "engine/files/sequence_knowledge.h"
#include "engine/files/unit_guess.h"
#include "engine/fits/joint_edits.h"
#include "engine/import/geometry_loader.h"
#include "engine/model/body_choice.h"
#include "engine/places/body_labels.h"
#include "engine/sequence/product_finder.h"

namespace glissade {
namespace {

/// The sum of the two largest values.
double largestTwo(std::vector<double> values) {
  values.resize(std::max<std::size_t>(values.size(), 2), 0.0);
  std::partial_sort(values.begin(), values.begin() + 2, values.end(), std::greater<>());
  return values[0] + values[1];
}

/// Removes these bodies, and the statements about their fits and joints.
void remove(const std::vector<bool>& going, ProductFile& loaded) {
  AssembledProduct& product = loaded.product;
  AssembledProduct rest;
  std::vector<std::string> classes;
  rest.fits = product.fits;
  rest.tree = product.tree;
  const auto goes = [&](const BodyId& id) {
    const auto index = product.find(id);
    return index && going[*index];
  };
  std::erase_if(rest.fits.pairs, [&](const FitEdit& edit) { return goes(edit.a) || goes(edit.b); });
  std::erase_if(loaded.joints, [&](const JointEdit& edit) {
    return goes(edit.key.body) || std::any_of(edit.key.others.begin(), edit.key.others.end(), goes);
  });
  for (JointEdit& edit : loaded.joints) std::erase_if(edit.clamped, goes);
  for (std::size_t i = 0; i < going.size(); ++i) {
    if (going[i]) continue;
    rest.bodies.push_back(product.bodies[i]);
    rest.deflections.push_back(product.deflections[i]);
    if (!product.spacings.empty()) rest.spacings.push_back(product.spacings[i]);
    if (!loaded.classes.empty()) classes.push_back(loaded.classes[i]);
  }
  labelBodies(rest.bodies, rest.tree);
  product = std::move(rest);
  loaded.classes = std::move(classes);
}

/// Takes copies in one place as one body, unless a plan names them.
void takeCopiesAsOne(const std::vector<BodyId>& planBodies, const StopToken& stop, ProductFile& loaded) {
  std::vector<evidence::Body> bodies;
  for (std::size_t i = 0; i < loaded.product.bodies.size(); ++i) bodies.push_back(loaded.product.measured(i));
  const auto places = evidence::placeCopiesIn(bodies, planBodies, stop);
  if (places.empty()) return;
  for (Diagnostic& warning : evidence::warningsOf(places, bodies)) loaded.warnings.push_back(std::move(warning));
  remove(evidence::areCopies(places, bodies.size()), loaded);
}

Result<ProductFile> productOfParts(const std::string& file, const StopToken& stop, double deflection,
                                   const PartChoice& choice) {
  GeometryCache read;
  PartFile part = usualPart(file);
  part.deflection = deflection;
  part.asOne = false;
  ProductFile loaded;
  std::vector<PartFile> guessed{part};
  const auto guesses = guessUnits(guessed, read, stop);
  if (!guesses) return guesses.error();
  loaded.warnings = *guesses;
  const auto geometry = readPart(guessed.front(), read, stop, &loaded.warnings);
  if (!geometry) return geometry.error();
  warnOfMissingFaces(**geometry, "", file, loaded.warnings);
  loaded.missing = (*geometry)->missing;
  const auto parts = chosenParts((*geometry)->parts, lastStepOf(file), choice);
  if (!parts) return parts.error();
  if (areSolidsOfOnePart(*parts)) {
    loaded.warnings.push_back(
        {ErrorKind::MalformedInput,
         file,
         "",
         {GLISSADE_TEXT("holds one part of %1 solids, which are taken as bodies"), {parts->size()}},
         GLISSADE_TEXT("Join solids of one body in the CAD program.")});
  }
  std::vector<ProductBody> bodies;
  for (const Occurrence& solid : *parts) {
    const std::string name = solid.path.empty() ? file : solid.path;
    bodies.push_back({BodyId(name), {solid.path.empty() ? lastStepOf(file) : solid.path, solid.names, solid.unit}});
    loaded.product.bodies.push_back({BodyId(name), name, Mobility::Mobile, solid.mesh, solid.X_FP});
    if (solid.colour) loaded.product.bodies.back().colour = *solid.colour;
    loaded.product.deflections.push_back(solid.deflection);
    loaded.product.spacings.push_back(solid.coordinateSpacing);
  }
  loaded.product.tree = Product(bodies);
  labelBodies(loaded.product.bodies, loaded.product.tree);
  nameByLabels(loaded.warnings, loaded.product.bodies);
  loaded.product.fits.on = true;
  takeCopiesAsOne(choice.planBodies, stop, loaded);
  loaded.deviation = largestTwo(loaded.product.deflections);
  return loaded;
}

}  // namespace

AssembledProduct productOf(const LoadedScenario& scenario) {
  AssembledProduct product = bodiesOf(scenario);
  product.bodies = aboutTheirMiddles(std::move(product.bodies));
  return product;
}

Result<ProductFile> productFileOf(const LoadedScenario& scenario) {
  ProductFile loaded;
  loaded.product = bodiesOf(scenario);
  auto demands = knownDemands(scenario.scenario, loaded.product);
  if (!demands) {
    Diagnostic why = demands.error();
    why.file = scenario.file;
    return why;
  }
  loaded.demands = std::move(*demands);
  loaded.joints = scenario.scenario.joints;
  loaded.classes = classesOf(semanticEditsOf(scenario.scenario), loaded.product.bodies);
  loaded.missing = scenario.missing;
  loaded.forbidsPlaces = forbidsPlaces(semanticEditsOf(scenario.scenario));
  loaded.warnings = scenario.warnings;
  loaded.deviation = largestTwo(loaded.product.deflections);
  return loaded;
}

Result<ProductFile> readProduct(const std::string& file, const StopToken& stop, double deflection,
                                const PartChoice& choice) {
  const bool isPart = isPartFile(usualPart(file).path);
  if (!isPart && deflection > 0.0) {
    return Diagnostic{ErrorKind::Usage, file, "",
                      GLISSADE_TEXT("is a scenario, which states the mesh tolerance of each of its assets"),
                      GLISSADE_TEXT("Change \"deflection\" of the asset there, or give the part file.")};
  }
  if (!isPart && !choice.open.empty()) {
    return Diagnostic{
        ErrorKind::Usage, file, "--open", GLISSADE_TEXT("is a scenario, which says itself which bodies it has"),
        GLISSADE_TEXT(
            "Name the solids when it is made: glissade-cli new OUT.json --static FILE:PART/SOLID --static FILE.")};
  }
  if (isPart) return productOfParts(file, stop, deflection, choice);
  const auto scenario = loadScenario(file, stop);
  return scenario ? productFileOf(*scenario) : Result<ProductFile>(scenario.error());
}

Diagnostic isLeftOut(const std::string& name) {
  return {ErrorKind::MalformedInput,
          "",
          {GLISSADE_TEXT("'%1'"), {name}},
          GLISSADE_TEXT("is excluded"),
          GLISSADE_TEXT("Certificates are about the product without it.")};
}

Outcome leaveOut(const std::vector<std::string>& names, ProductFile& loaded) {
  if (names.empty()) return Done{};
  const std::vector<RigidBody>& bodies = loaded.product.bodies;
  const auto meant = bodiesMeant(idsOf(bodies), names, "--without", loaded.product.tree);
  if (!meant) return meant.error();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if ((*meant)[i]) loaded.warnings.push_back(isLeftOut(bodies[i].shown()));
  }
  remove(*meant, loaded);
  return Done{};
}

Result<ProductFile> loadProduct(const std::string& file, const StopToken& stop, double deflection,
                                const PartChoice& choice) {
  auto loaded = readProduct(file, stop, deflection, choice);
  if (!loaded) return loaded;
  if (loaded->product.bodies.size() < 2) {
    return Diagnostic{ErrorKind::MalformedInput, file, "",
                      GLISSADE_TEXT("holds one body: there is nothing to disassemble"),
                      GLISSADE_TEXT("Give a product of several parts.")};
  }
  loaded->product.bodies = aboutTheirMiddles(std::move(loaded->product.bodies));
  return loaded;
}

Result<Joints> jointsOf(const ProductFile& loaded, bool confirmsSuggested, const StopToken& stop) {
  const JointsPtr found = ProductFinder().joints(loaded.product, loaded.classes, stop);
  if (!found) return Diagnostic{ErrorKind::Interrupted, "", "", GLISSADE_TEXT("was interrupted"), {}};
  auto joints = applied(*found, loaded.joints, loaded.product);
  if (!joints || !confirmsSuggested) return joints;
  const auto confirmations = confirmationsOf(*joints, loaded.product);
  return applied(std::move(*joints), confirmations, loaded.product);
}

}  // namespace glissade
