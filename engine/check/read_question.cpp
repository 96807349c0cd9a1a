#include "engine/check/read_question.h"

#include <cmath>
#include <filesystem>
#include <map>

#include "engine/base/file.h"
#include "engine/base/limits.h"
#include "engine/check/scenario_json.h"
#include "engine/check/stated_object.h"
#include "engine/evidence/place_copies.h"
#include "engine/geometry/mesh_edges.h"
#include "engine/import/geometry_loader.h"
#include "engine/import/json_checksum.h"
#include "engine/import/mesh_import.h"
#include "engine/import/omplapp_config.h"
#include "engine/import/step_deflection.h"
#include "engine/import/step_import.h"
#include "engine/import/step_parts.h"
#include "engine/import/unread_kind.h"
#include "engine/model/body_choice.h"
#include "engine/model/body_path.h"

namespace glissade::check {
namespace {

namespace fs = std::filesystem;

bool isUrdf(const std::string& file) { return endingOf(file) == "urdf"; }

/// Splits "product.step:pump", an assembly in a STEP file, unless a file has that name.
std::pair<std::string, std::string> splitPart(const std::string& text) {
  std::error_code none;
  for (std::size_t at = text.find(':'); at != std::string::npos; at = text.find(':', at + 1)) {
    if (isCadFile(text.substr(0, at)) && !fs::exists(text, none)) return {text.substr(0, at), text.substr(at + 1)};
  }
  return {text, ""};
}

Diagnostic stopped(const std::string& file) {
  return {ErrorKind::Interrupted, file, "", GLISSADE_TEXT("was not read to its end"), GLISSADE_TEXT("Start again.")};
}

/// Replaces names by those that people see.
void shorten(Product& product) {
  std::vector<std::string> ids;
  for (const Body& body : product.bodies) ids.push_back(body.id.text());
  const std::vector<std::string> shown = product.tree.labels(ids);
  for (std::size_t i = 0; i < product.bodies.size(); ++i) product.bodies[i].name = shown[i];
}

/// Removes these bodies, and the statements about their fits.
void remove(const std::vector<bool>& going, Product& product) {
  std::vector<Body> rest;
  for (std::size_t i = 0; i < going.size(); ++i) {
    const Body& body = product.bodies[i];
    if (!going[i]) {
      rest.push_back(body);
      continue;
    }
    std::erase_if(product.fits.pairs, [&](const PairWord& word) { return word.a == body.id || word.b == body.id; });
  }
  product.bodies = std::move(rest);
}

/// Warns that the inside of a body with an open surface is not detected.
void warnIfOpen(const Body& body, const std::string& file, std::map<MeshPtr, bool>& known, Warnings& warnings) {
  const auto [at, isNew] = known.try_emplace(body.mesh, false);
  if (isNew) at->second = edgeFactsOf(welded(*body.mesh)).open == 0;
  if (at->second) return;
  warnings.push_back(
      {ErrorKind::MalformedInput,
       file,
       {GLISSADE_TEXT("body '%1'"), {body.name}},
       GLISSADE_TEXT("is not a closed surface"),
       GLISSADE_TEXT("Being inside it is not seen as a collision; close its surface, or let planar holes be "
                     "closed (--close-holes).")});
}

Outcome checkPairs(const Product& product, const std::string& file) {
  for (std::size_t i = 0; i < product.fits.pairs.size(); ++i) {
    for (const BodyId& id : {product.fits.pairs[i].a, product.fits.pairs[i].b}) {
      if (product.find(id) != nullptr) continue;
      return Diagnostic{ErrorKind::MalformedInput,
                        file,
                        "/fits/pairs/" + std::to_string(i),
                        {GLISSADE_TEXT("names the body '%1', which is not there"), {id.text()}},
                        GLISSADE_TEXT("See 'glissade-cli fits' for the names.")};
    }
  }
  return Done{};
}

StatedScenario statedBy(const OmplAppConfig& config) {
  StatedScenario scenario;
  scenario.assets.push_back({"robot", config.robot, "", 1.0, UpAxis::Z});
  scenario.object.push_back({"robot", "robot", MeshGeometry{"robot"}, Pose::identity()});
  scenario.start = config.start;
  scenario.centreOnVertexMean = true;
  if (!config.world.empty()) {
    scenario.assets.push_back({"world", config.world, "", 1.0, UpAxis::Z});
    scenario.bodies.push_back({"world", "world", MeshGeometry{"world"}, Pose::identity()});
  }
  scenario.goal = config.goal;
  scenario.workspace = config.volume;
  return scenario;
}

Result<StatedScenario> statedIn(const std::string& file, Warnings& warnings) {
  if (fs::path(file).extension() == ".cfg") {
    const auto config = readOmplAppConfig(file);
    if (!config) return config.error();
    return statedBy(*config);
  }
  if (isCadFile(file) || isUrdf(file) || isMeshFile(file)) {
    return Diagnostic{
        ErrorKind::Usage, file, "", GLISSADE_TEXT("is a part file, and a scenario is needed"),
        GLISSADE_TEXT("Make a scenario of it: glissade-cli new OUT.json --moves FILE:PART --static FILE.")};
  }
  if (const auto unread = unreadKind(file)) return *unread;
  const auto text = readFile(file, limits::kMostScenarioBytes);
  if (!text) return text.error();
  auto document = parseJson(*text, file);
  if (!document) return document.error();
  if (takeChecksum(*document) == ChecksumState::Wrong) {
    warnings.push_back(
        wrongChecksum(file, GLISSADE_TEXT("Check the scenario, then save it again or remove the checksum.")));
  }
  try {
    return readStatedScenario(JsonCursor(*document, file, ""));
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}

Outcome takeParameters(const StatedScenario& scenario, const std::string& file, Question& question) {
  ParameterValues values(radiusAboutOrigin(*question.object().mesh));
  for (const auto& [id, value] : scenario.parameters) {
    const Outcome outcome = values.set(id, value);
    if (outcome) continue;
    Diagnostic why = outcome.error();
    why.kind = ErrorKind::MalformedInput;
    why.file = file;
    why.location = "/parameters/" + toString(why.location);
    return why;
  }
  question.requiredClearance = values[ParameterId::RequiredClearance];
  question.contactGap = values[ParameterId::ContactGap];
  return Done{};
}

/// Moves the frame of each body to the centre of its box; meshes stay shared.
void centre(std::vector<Body>& bodies) {
  std::map<MeshPtr, std::pair<Vector3, MeshPtr>> known;
  for (Body& body : bodies) {
    auto& [middle, mesh] = known[body.mesh];
    if (!mesh) {
      middle = boundingBox(*body.mesh).center();
      mesh = std::make_shared<const TriangleMesh>(transformed(*body.mesh, Pose::translation(-middle)));
    }
    body.X_WB.position = body.X_WB * middle;
    body.mesh = mesh;
  }
}

struct ReadParts {
  std::vector<Body> bodies{};
  glissade::Product tree{};
  MissingShapes missing{};
};

Result<ReadParts> partsOf(const Asset& asset, const std::string& part, const PartChoice& choice,
                          const std::string& file, Warnings& warnings, const StopToken& stop) {
  const std::vector<Asset> assets{asset};
  GeometryLoader loader(assets, ".", file, nullptr, stop);
  const Geometry geometry =
      isUrdf(asset.path) ? Geometry(UrdfGeometry{asset.id}) : Geometry(StepGeometry{asset.id, part});
  const auto loaded = loader.load(geometry);
  if (!loaded) return loaded.error();
  warnings = loader.warnings();
  warnOfMissingFaces(**loaded, "", file, warnings);
  auto parts = chosenParts((*loaded)->parts, lastStepOf(file), choice);
  if (!parts) return parts.error();
  LoadedGeometry chosen;
  chosen.parts = std::move(*parts);
  ReadParts read;
  addParts({"", file, geometry, Pose::identity()}, chosen, read.bodies);
  std::vector<ProductBody> nodes;
  for (std::size_t i = 0; i < read.bodies.size(); ++i) {
    const Occurrence& solid = chosen.parts[i];
    if (read.bodies[i].id.empty()) read.bodies[i].id = BodyId(file);
    nodes.push_back({read.bodies[i].id, {solid.path.empty() ? lastStepOf(file) : solid.path, solid.names}});
  }
  read.tree = glissade::Product(nodes);
  read.missing = (*loaded)->missing;
  return read;
}

/// Takes the stated deflection of each part if it is finer than the usual one. False if it was coarser for a part.
bool takeFiner(std::vector<Body>& usual, const std::vector<Body>& stated, double deflection) {
  bool all = true;
  for (std::size_t i = 0; i < usual.size() && usual.size() == stated.size(); ++i) {
    const double diagonal = boundingBox(*usual[i].mesh).diagonal().norm();
    const bool isFine = deflection <= usualDeflection(diagonal);
    if (isFine) usual[i] = stated[i];
    all = all && isFine;
  }
  return all;
}

Result<Product> productOfParts(const std::string& text, double deflection, const PartChoice& choice,
                               const StopToken& stop) {
  const auto [file, part] = splitPart(text);
  const Asset asset{"product", fs::absolute(file).lexically_normal().generic_string(), "", 1.0, UpAxis::Z};
  Product product;
  auto usual = partsOf(asset, part, choice, text, product.warnings, stop);
  if (!usual) return usual.error();
  product.bodies = std::move(usual->bodies);
  product.tree = std::move(usual->tree);
  product.missing = std::move(usual->missing);
  if (deflection > 0.0 && !isUrdf(file)) {
    Asset finer = asset;
    finer.deflection = std::clamp(deflection, limits::kSmallestSize, usualDeflection(1e9));
    Warnings same;
    const auto stated = partsOf(finer, part, choice, text, same, stop);
    if (!stated) return stated.error();
    if (!takeFiner(product.bodies, stated->bodies, deflection)) {
      product.warnings.push_back({ErrorKind::MalformedInput, text, "",
                                  GLISSADE_TEXT("is checked with the automatic mesh tolerance of its parts"),
                                  GLISSADE_TEXT("The plan states a coarser one.")});
    }
  }
  product.fits.on = true;
  shorten(product);
  const auto places = placeCopiesIn(product.bodies, choice.planBodies, stop);
  for (Diagnostic& warning : warningsOf(places, product.bodies)) product.warnings.push_back(std::move(warning));
  remove(areCopies(places, product.bodies.size()), product);
  return product;
}

}  // namespace

namespace {

/// A scenario file with the bodies that it names.
struct ReadScenario {
  StatedScenario stated;
  std::vector<Body> others;        ///< bodies that do not move
  std::vector<Body> objectBodies;  ///< bodies of the object as bodies of the product
  Body object;                     ///< the object as one moving body
  glissade::Product tree;
  Warnings warnings{};
  MissingShapes missing{};
};

ProductBody nodeOf(const StatedScenario::StatedBody& body, const LoadedGeometry& geometry) {
  ProductBody node{body.id, {body.name}};
  for (const Occurrence& part : geometry.parts) node.parts.push_back({part.path, part.names});
  return node;
}

Outcome readBodies(const std::string& file, const StopToken& stop, ReadScenario& read) {
  const StatedScenario& stated = read.stated;
  GeometryLoader loader(stated.assets, folderOf(file), file, nullptr, stop);
  const auto load = [&](const StatedScenario::StatedBody& body) -> Result<LoadedGeometryPtr> {
    auto geometry = loader.load(body.geometry);
    if (geometry) warnOfMissingFaces(**geometry, body.id, file, loader.warnings());
    return geometry;
  };
  std::vector<ProductBody> nodes;
  for (const StatedScenario::StatedBody& body : stated.bodies) {
    const auto geometry = load(body);
    if (!geometry) return geometry.error();
    addParts(body, **geometry, read.others);
    nodes.push_back(nodeOf(body, **geometry));
  }
  ObjectGeometry ofObject;
  for (const StatedScenario::StatedBody& body : stated.object) {
    const auto geometry = load(body);
    if (!geometry) return geometry.error();
    ofObject.push_back(*geometry);
    nodes.push_back(nodeOf(body, **geometry));
  }
  if (stop.stopRequested()) return stopped(file);
  for (const StatedScenario::StatedBody& body : stated.leftOut) nodes.push_back({body.id, {body.name}});
  read.tree = glissade::Product(nodes, stated.nodes);
  read.object = objectOf(stated, ofObject);
  read.objectBodies = {read.object};
  if (stated.object.size() > 1) read.objectBodies = groupBodiesOf(stated, ofObject);
  read.warnings.insert(read.warnings.end(), loader.warnings().begin(), loader.warnings().end());
  std::vector<const Geometry*> named;
  for (const auto* bodies : {&stated.bodies, &stated.object, &stated.leftOut}) {
    for (const StatedScenario::StatedBody& body : *bodies) named.push_back(&body.geometry);
  }
  read.missing = missingShapesOf(loader.loaded(), named, stated.assets, folderOf(file));
  return Done{};
}

Result<ReadScenario> readScenario(const std::string& file, const StopToken& stop) {
  ReadScenario read;
  auto stated = statedIn(file, read.warnings);
  if (!stated) return stated.error();
  read.stated = std::move(*stated);
  if (const Outcome bodies = readBodies(file, stop, read); !bodies) return bodies.error();
  for (const StatedScenario::StatedBody& body : read.stated.leftOut) {
    read.warnings.push_back({ErrorKind::MalformedInput,
                             file,
                             {GLISSADE_TEXT("'%1'"), {body.name}},
                             GLISSADE_TEXT("is excluded"),
                             GLISSADE_TEXT("Certificates are about the product without it.")});
  }
  return read;
}

/// The product of the scenario with these bodies as the object.
Product productOf(const ReadScenario& read, const std::vector<Body>& object, const std::string& file) {
  Product product;
  product.bodies = read.others;
  product.bodies.insert(product.bodies.end(), object.begin(), object.end());
  product.tree = read.tree;
  product.warnings = read.warnings;
  product.missing = read.missing;
  std::map<MeshPtr, bool> closed;
  for (const Body& body : product.bodies) warnIfOpen(body, file, closed, product.warnings);
  shorten(product);
  product.demands = read.stated.demands;
  product.joints = read.stated.joints;
  product.forbidsPlaces = read.stated.forbidsPlaces;
  return product;
}

}  // namespace

Result<Question> readQuestion(const std::string& file, const FitOptions& fits, const StopToken& stop) {
  const auto read = readScenario(file, stop);
  if (!read) return read.error();
  const StatedScenario& scenario = read->stated;
  Question question;
  question.product = productOf(*read, {read->object}, file);
  question.product.fits = scenario.fits;
  fits.applyTo(question.product.fits);
  if (scenario.object.size() > 1) {
    question.product.bodies.back().name += " + " + std::to_string(read->objectBodies.size() - 1);
    question.product.fits = wordsOfGroup(question.product.fits, read->objectBodies, read->object.id);
  }
  if (const Outcome known = checkPairs(question.product, file); !known) return known.error();
  if (scenario.goal) question.goal = unitRotation(*scenario.goal);
  question.workspace = scenario.workspace;
  question.forbidden = scenario.forbidden;
  if (const Outcome taken = takeParameters(scenario, file, question); !taken) return taken.error();
  return question;
}

namespace {

Result<Product> productOfScenario(const std::string& file, const FitOptions& fits, const StopToken& stop) {
  const auto read = readScenario(file, stop);
  if (!read) return read.error();
  Product product = productOf(*read, read->objectBodies, file);
  product.fits = read->stated.fits;
  fits.applyTo(product.fits);
  if (const Outcome known = checkPairs(product, file); !known) return known.error();
  return product;
}

}  // namespace

Result<Product> readProduct(const std::string& file, double deflection, const FitOptions& fits, const StopToken& stop,
                            const PartChoice& choice) {
  const std::string path = splitPart(file).first;
  const bool isPart = isCadFile(path) || isUrdf(path);
  auto read = isPart ? productOfParts(file, deflection, choice, stop) : productOfScenario(file, fits, stop);
  if (!read) return read.error();
  Product product = std::move(*read);
  if (isPart) fits.applyTo(product.fits);
  if (product.bodies.size() < 2) {
    return Diagnostic{ErrorKind::MalformedInput, file, "",
                      GLISSADE_TEXT("holds one body: there is nothing to disassemble"),
                      GLISSADE_TEXT("Give a product of several parts.")};
  }
  centre(product.bodies);
  return product;
}

Outcome leaveOut(const std::vector<std::string>& names, Product& product) {
  if (names.empty()) return Done{};
  std::vector<BodyId> ids;
  for (const Body& body : product.bodies) ids.push_back(body.id);
  const auto meant = bodiesMeant(ids, names, "--without", product.tree);
  if (!meant) return meant.error();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!(*meant)[i]) continue;
    product.warnings.push_back({ErrorKind::MalformedInput,
                                "",
                                {GLISSADE_TEXT("'%1'"), {product.bodies[i].name}},
                                GLISSADE_TEXT("is excluded"),
                                GLISSADE_TEXT("Certificates are about the product without it.")});
  }
  remove(*meant, product);
  return Done{};
}

}  // namespace glissade::check
