#include <algorithm>
#include <filesystem>
#include <string>

#include "engine/base/file.h"
#include "engine/base/file_versions.h"
#include "engine/base/limits.h"
#include "engine/base/result.h"
#include "engine/base/utf8.h"
#include "engine/files/default_colour.h"
#include "engine/files/object_geometry.h"
#include "engine/files/part_files.h"
#include "engine/files/same_problem.h"
#include "engine/files/scenario.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_file.h"
#include "engine/files/scenario_fits.h"
#include "engine/files/scenario_product.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/import/asset_path.h"
#include "engine/import/file_content.h"
#include "engine/import/geometry_loader.h"
#include "engine/import/import_limits.h"
#include "engine/import/omplapp_config.h"
#include "engine/import/unread_kind.h"
#include "engine/places/body_labels.h"
#include "engine/places/held_edits.h"

namespace glissade {
namespace {

Location placeOf(const RigidBody& body) { return {GLISSADE_TEXT("body '%1'"), {body.name}}; }

Diagnostic refused(const std::string& file, const Location& location, const Message& reason) {
  return {ErrorKind::MalformedInput, file, location, reason,
          GLISSADE_TEXT("Check its pose, its size and the unit of its file.")};
}

Outcome checkReach(const RigidBody& body, const std::string& file) {
  const Box3 box = boundingBox(*body.mesh, body.X_WB);
  const double reach = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (limits::isCoordinate(reach)) return Done{};
  return refused(file, placeOf(body), {GLISSADE_TEXT("reaches %1 m from the world's origin, beyond 1e9 m"), {reach}});
}

/// Refuses a scenario that has expanded to more than limits::kMostBodies rigid bodies.
Outcome checkNumberOfBodies(const LoadedScenario& loaded, const std::string& file) {
  if (loaded.obstacles.size() <= limits::kMostBodies) return Done{};
  return Diagnostic{ErrorKind::MalformedInput,
                    file,
                    "/bodies",
                    {GLISSADE_TEXT("expand to more than %1 rigid bodies"), {limits::kMostBodies}},
                    GLISSADE_TEXT("Give the parts that matter, or fewer bodies made of the same file.")};
}

/// Refuses a scenario whose bodies or object, as they are placed, reach beyond limits::kLargestLength, whose object is
/// smaller than limits::kSmallestSize, or whose workspace is more than limits::kLargestRatio times the object's radius.
/// Errors are MalformedInput with the body as location.
Outcome checkExtents(const LoadedScenario& loaded, const Box3& workspace, const std::string& file) {
  for (const RigidBody& body : loaded.obstacles) {
    if (const Outcome near = checkReach(body, file); !near) return near;
  }
  if (const Outcome near = checkReach(loaded.object, file); !near) return near;
  const double radius = radiusAboutOrigin(*loaded.object.mesh);
  if (!limits::isSize(radius)) {
    return refused(file, placeOf(loaded.object),
                   {GLISSADE_TEXT("has a radius of %1 m, which is not from 1e-12 m to 1e9 m"), {radius}});
  }
  if (workspace.diagonal().norm() > limits::kLargestRatio * radius) {
    return Diagnostic{ErrorKind::MalformedInput, file, "/workspace",
                      GLISSADE_TEXT("is more than 1e10 times as large as the object"),
                      GLISSADE_TEXT("Check the units of both, or give a smaller workspace.")};
  }
  return Done{};
}

constexpr Colour kMobileColour{0.80, 0.68, 0.45};
constexpr Colour kObjectColour{0.93, 0.90, 0.80};

Pose normalized(const Pose& pose) { return {pose.position, pose.orientation.normalized()}; }

void warnIfOpen(const RigidBody& body, const std::string& file, const LoadedScenario* before, LoadedScenario& loaded) {
  auto found = loaded.closed.find(body.mesh);
  if (found == loaded.closed.end()) {
    const bool known = before != nullptr && before->closed.count(body.mesh) > 0;
    const bool closed = known ? before->closed.at(body.mesh) : isClosedSurface(*body.mesh);
    found = loaded.closed.emplace(body.mesh, closed).first;
  }
  if (found->second) return;
  loaded.warnings.push_back(
      {ErrorKind::MalformedInput, file, placeOf(body), GLISSADE_TEXT("is not a closed surface"),
       GLISSADE_TEXT("Being inside it is not seen as a collision; close its surface, or let planar holes be "
                     "closed (--close-holes).")});
}

/// Notes the meshes that the importer found closed, so that they are not checked again.
void noteClosed(const LoadedGeometry& geometry, LoadedScenario& loaded) {
  for (const Occurrence& part : geometry.parts) {
    if (part.isClosed) loaded.closed.emplace(part.mesh, true);
  }
}

bool allAreClosed(const LoadedGeometry& geometry) {
  return std::all_of(geometry.parts.begin(), geometry.parts.end(), [](const Occurrence& p) { return p.isClosed; });
}

bool isSameMesh(const TriangleMesh& a, const TriangleMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles;
}

/// The mobility of a body. An edit for the body or its assembly overrides the body's own.
Mobility mobilityOf(const BodyDescription& description, const SemanticEdits& held) {
  const auto body = held.bodies.find(description.id.text());
  if (body == held.bodies.end()) return description.mobility;
  const auto edited = body->second.find("mobility");
  if (edited == body->second.end()) return description.mobility;
  return edited->second == AttributeValue(std::string("mobile")) ? Mobility::Mobile : Mobility::Static;
}

/// Updates the largest value of a body; zero is not stored.
void noteLargest(double value, const BodyId& bodyId, std::map<BodyId, double>& values) {
  if (value == 0.0) return;
  double& largest = values[bodyId];
  largest = std::max(largest, value);
}

/// Notes the uncertainties of the geometry. `merged`: all parts are one rigid body.
void noteUncertainties(const LoadedGeometry& geometry, const BodyId& bodyId, bool merged, LoadedScenario& loaded) {
  for (const Occurrence& part : geometry.parts) {
    const BodyId id = merged ? bodyId : partId(bodyId, part);
    noteLargest(part.deflection, id, loaded.deflections);
    noteLargest(part.coordinateSpacing, id, loaded.coordinateSpacings);
  }
}

/// The largest value of the object plus the largest value of an obstacle.
double largestOfBoth(const std::map<BodyId, double>& values, const LoadedScenario& loaded) {
  double object = 0.0;
  double obstacle = 0.0;
  for (const auto& [id, value] : values) {
    double& largest = isInObject(loaded, id) ? object : obstacle;
    largest = std::max(largest, value);
  }
  return object + obstacle;
}

std::vector<RigidBody> toBodies(const BodyDescription& description, Mobility mobility, const LoadedGeometry& geometry) {
  std::vector<RigidBody> bodies;
  for (const Occurrence& part : geometry.parts) {
    RigidBody body;
    body.id = partId(description.id, part);
    body.name = part.path.empty() ? description.name : part.path;
    body.mobility = mobility;
    body.mesh = part.mesh;
    body.X_WB = normalized(description.pose) * part.X_FP;
    const Colour usual = body.mobility == Mobility::Static ? defaultColour(body.name) : kMobileColour;
    body.colour = description.colour ? *description.colour : part.colour.value_or(usual);
    bodies.push_back(std::move(body));
  }
  return bodies;
}

RigidBody objectOf(const Scenario& scenario, const ObjectGeometry& geometry) {
  const BodyDescription& first = scenario.object.first();
  RigidBody object;
  object.id = first.id;
  object.name = first.name;
  object.mobility = Mobility::Mobile;
  object.mesh = std::make_shared<const TriangleMesh>(objectMesh(scenario.object, geometry));
  object.X_WB = normalized(scenario.start);
  object.colour = first.colour ? *first.colour : geometry.front()->parts.front().colour.value_or(kObjectColour);
  return object;
}

/// The object's bodies, made like static bodies of the product, so that the choice of what moves does not change them.
std::vector<RigidBody> bodiesOfGroup(const Scenario& scenario, const ObjectGeometry& geometry) {
  const ObjectDescription& object = scenario.object;
  const Pose X_WG = normalized(scenario.start) * Pose::translation(-referencePointOf(object, geometry));
  std::vector<RigidBody> bodies;
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    BodyDescription placed = object.bodies[i];
    placed.pose = X_WG * poseInObject(object, i);
    for (RigidBody& body : toBodies(placed, Mobility::Mobile, *geometry[i])) bodies.push_back(std::move(body));
  }
  return bodies;
}

Outcome loadObject(const Scenario& scenario, const LoadedScenario* before, GeometryLoader& loader,
                   BodyGeometry& geometries, LoadedScenario& loaded) {
  const auto geometry = loadGeometryOf(scenario.object, loader);
  if (!geometry) return geometry.error();
  const bool group = scenario.object.isGroup();
  loaded.object = objectOf(scenario, *geometry);
  if (before != nullptr && isSameMesh(*before->object.mesh, *loaded.object.mesh)) {
    loaded.object.mesh = before->object.mesh;  // already prepared for collision queries
  }
  bool closed = true;
  for (std::size_t i = 0; i < geometry->size(); ++i) {
    const LoadedGeometry& each = *(*geometry)[i];
    warnOfMissingFaces(each, scenario.object.bodies[i].id, loaded.file, loader.warnings());
    noteUncertainties(each, scenario.object.bodies[i].id, !group, loaded);
    if (group) noteClosed(each, loaded);
    geometries.emplace(scenario.object.bodies[i].id, (*geometry)[i]);
    closed = closed && allAreClosed(each);
  }
  if (closed || group) loaded.closed.emplace(loaded.object.mesh, closed);
  loaded.objectBodies = group ? bodiesOfGroup(scenario, *geometry) : std::vector<RigidBody>{loaded.object};
  return Done{};
}

/// Sets the names of all bodies of the product that people see.
void labelAll(LoadedScenario& loaded) {
  std::vector<RigidBody> all = rigidBodiesOf(loaded);
  labelBodies(all, loaded.product);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t others = loaded.obstacles.size();
    (i < others ? loaded.obstacles[i] : loaded.objectBodies[i - others]).label = all[i].label;
  }
  loaded.object.label = loaded.objectBodies.front().label;
  const std::size_t more = loaded.objectBodies.size() - 1;
  if (more > 0) loaded.object.label += " + " + std::to_string(more);
}

std::optional<Diagnostic> leftOutWarning(const Scenario& scenario, const std::string& file) {
  if (scenario.leftOut.empty()) return std::nullopt;
  std::vector<Message> names;
  for (const BodyDescription& body : scenario.leftOut) names.push_back({GLISSADE_TEXT("'%1'"), {body.name}});
  return Diagnostic{ErrorKind::MalformedInput,
                    file,
                    "/left_out",
                    {GLISSADE_TEXT("excludes bodies: %1"), {joined(names, ", ")}},
                    GLISSADE_TEXT("Certificates are about the product without them.")};
}

MissingShapes missingShapesIn(const GeometryCache& read, const Scenario& scenario, const std::string& folder) {
  std::vector<const Geometry*> named;
  for (const BodyDescription* body : allBodiesOf(scenario)) named.push_back(&body->geometry);
  return missingShapesOf(read, named, scenario.assets, folder);
}

Outcome applyParameters(const Scenario& scenario, const std::string& file, ParameterValues& values) {
  for (const auto& [id, value] : scenario.parameters) {
    const Outcome outcome = values.set(id, value);
    if (outcome) continue;
    Diagnostic why = outcome.error();
    why.kind = ErrorKind::MalformedInput;
    why.file = file;
    why.location = "/parameters/" + toString(why.location);
    return why;
  }
  return Done{};
}

SceneDescription describeScene(const Scenario& scenario, const Product& product) {
  SceneDescription scene;
  scene.objectId = scenario.object.first().id;
  scene.environment = scenario.environment;
  scene.edits = std::make_shared<const SemanticEdits>(heldEdits(semanticEditsOf(scenario), product));
  if (scenario.rules) scene.rules = std::make_shared<const StrategyRules>(*scenario.rules);
  return scene;
}

Scenario toScenario(const OmplAppConfig& config) {
  Scenario scenario;
  scenario.name = config.name;
  scenario.description = "Imported from OMPL.app";
  scenario.assets.push_back({"robot", config.robot, "", 1.0, UpAxis::Z});
  scenario.object.first() = {"robot", "robot", Mobility::Static, MeshGeometry{"robot"}};
  scenario.object.centreOnVertexMean = true;
  if (!config.world.empty()) {
    scenario.assets.push_back({"world", config.world, "", 1.0, UpAxis::Z});
    BodyDescription world;
    world.id = "world";
    world.name = "world";
    world.geometry = MeshGeometry{"world"};
    scenario.bodies.push_back(std::move(world));
  }
  scenario.start = config.start;
  scenario.goal = config.goal;
  scenario.workspace = config.volume;
  scenario.planner = "birrt";
  return scenario;
}

struct ReadScenario {
  Scenario scenario;
  std::string sha256;  ///< hash of the scenario's file
  Warnings warnings;
};

Result<ReadScenario> readScenario(const std::string& file) {
  if (std::filesystem::path(file).extension() == ".cfg") {
    const auto config = readOmplAppConfig(file);
    if (!config) return config.error();
    return ReadScenario{toScenario(*config), "", {}};
  }
  if (isPartFile(file)) {
    return Diagnostic{
        ErrorKind::Usage, file, "", GLISSADE_TEXT("is a part file, and a scenario is needed"),
        GLISSADE_TEXT("Make a scenario of it: glissade-cli new OUT.json --moves FILE:PART --static FILE.")};
  }
  if (const auto unread = unreadKind(file)) return *unread;
  const auto text = readFile(file, limits::kMostScenarioBytes);
  if (!text) return text.error();
  Warnings warnings;
  auto scenario = parseScenario(*text, file, warnings);
  if (!scenario) return scenario.error();
  return ReadScenario{std::move(*scenario), sha256(*text), std::move(warnings)};
}

Result<ScenarioFile> openScenario(const std::string& file, const FitOptions& options, const StopToken& stop,
                                  FindFits fits) {
  auto read = readScenario(file);
  if (!read) return read.error();
  options.applyTo(read->scenario.fits);
  auto loaded = loadGeometry(std::move(read->scenario), folderOf(file), file, {}, stop, nullptr, fits);
  if (!loaded) return loaded.error();
  loaded->warnings.insert(loaded->warnings.begin(), read->warnings.begin(), read->warnings.end());
  return ScenarioFile{std::move(*loaded), std::move(read->sha256)};
}

}  // namespace

Result<LoadedScenario> loadScenario(const std::string& file, const StopToken& stop, const FitOptions& fits) {
  auto opened = openScenario(file, fits, stop, FindFits::Now);
  if (!opened) return opened.error();
  LoadedScenario& loaded = opened->scenario;
  if (const auto left = leftOutWarning(loaded.scenario, file)) loaded.warnings.push_back(*left);
  return std::move(loaded);
}

Result<ScenarioFile> openScenarioFile(const std::string& file, const StopToken& stop, FindFits fits) {
  return openScenario(file, {}, stop, fits);
}

Result<LoadedScenario> loadGeometry(Scenario scenario, const std::string& folder, const std::string& file,
                                    const GeometryCache& known, const StopToken& stop, const LoadedScenario* before,
                                    FindFits fits) {
  LoadedScenario loaded;
  loaded.file = file;
  GeometryLoader loader(scenario.assets, folder, file, &known, stop);
  loader.expect(geometriesOf(scenario));
  const SemanticEdits held = heldEdits(semanticEditsOf(scenario), treeOf(scenario));
  BodyGeometry geometries;
  for (const BodyDescription& body : scenario.bodies) {
    const auto geometry = loader.load(body.geometry);
    if (!geometry) return geometry.error();
    warnOfMissingFaces(**geometry, body.id, file, loader.warnings());
    noteUncertainties(**geometry, body.id, false, loaded);
    noteClosed(**geometry, loaded);
    geometries.emplace(body.id, *geometry);
    for (RigidBody& rigid : toBodies(body, mobilityOf(body, held), **geometry)) {
      loaded.obstacles.push_back(std::move(rigid));
    }
    if (const Outcome few = checkNumberOfBodies(loaded, file); !few) return few.error();
  }
  if (const Outcome object = loadObject(scenario, before, loader, geometries, loaded); !object) return object.error();
  loaded.product = treeOf(scenario, geometries);
  loader.noteHashes(scenario.assets);
  loaded.geometry = std::move(loader.loaded());
  loaded.missing = missingShapesIn(loaded.geometry, scenario, folder);
  loaded.warnings = std::move(loader.warnings());
  labelAll(loaded);
  nameByLabels(loaded.warnings, rigidBodiesOf(loaded));
  for (const RigidBody& body : rigidBodiesOf(loaded)) warnIfOpen(body, file, before, loaded);

  if (const Outcome sound = checkExtents(loaded, scenario.workspace, file); !sound) return sound.error();
  loaded.problem.world = before != nullptr ? before->problem.world->updated(loaded.obstacles, loaded.object.mesh)
                                           : CollisionWorld::build(loaded.obstacles, loaded.object.mesh);
  // Quaternions in files may be off by kQuaternionNorm. A rotation that stretches would falsify every distance.
  loaded.problem.start = normalized(scenario.start);
  loaded.problem.goal = scenario.goal;
  if (Pose* goal = std::get_if<Pose>(&loaded.problem.goal)) *goal = normalized(*goal);
  loaded.problem.bounds = scenario.workspace;
  loaded.problem.scene = describeScene(scenario, loaded.product);
  loaded.parameters = ParameterValues(loaded.problem.world->objectRadius());
  const Outcome parameters = applyParameters(scenario, file, loaded.parameters);
  if (!parameters) return parameters.error();
  loaded.scenario = std::move(scenario);
  loaded.problemSha256 = problemSha256(loaded.scenario);
  const bool later = fits == FindFits::LaterIfLarge && !loaded.problem.world->isPrepared();
  if (loaded.scenario.fits.on && later) {
    loaded.fitsPending = true;
  } else if (loaded.scenario.fits.on) {
    if (const Outcome fitted = applyFits(loaded, stop); !fitted) return fitted.error();
  }
  return loaded;
}

Result<std::string> assetSha256(const Asset& asset, const std::string& scenarioFile) {
  if (!asset.sha256.empty()) return asset.sha256;
  const auto content = readContent(assetFile(asset, folderOf(scenarioFile)), mostFileBytes());
  if (!content) return content.error();
  return sha256(content->bytes);
}

SaveResult saveScenarioFile(const Scenario& scenario, const std::string& file,
                            const std::optional<std::string>& replaces) {
  Scenario hashed = scenario;
  for (Asset& asset : hashed.assets) {
    if (!isUtf8(asset.path)) {
      return notSaved({ErrorKind::MalformedInput, asset.path, "",
                       GLISSADE_TEXT("has a name that is not valid UTF-8, which a scenario file cannot hold"),
                       GLISSADE_TEXT("Rename the file or its folder.")});
    }
    const auto hash = assetSha256(asset, file);
    if (!hash) return notSaved(hash.error());
    asset.sha256 = *hash;
  }
  const std::string text = writeScenario(hashed);
  if (const auto readBack = parseScenario(text, file); !readBack) return notSaved(readBack.error());
  return saveFile(file, text, {replaces, kKeptVersions, !replaces});
}

Outcome saveScenario(const Scenario& scenario, const std::string& file) {
  const SaveResult saved = saveScenarioFile(scenario, file, std::nullopt);
  return saved ? Outcome(Done{}) : Outcome(saved.why);
}

std::vector<Pose> routeOf(const LoadedScenario& scenario) {
  std::vector<Pose> route = scenario.scenario.wayPoints;
  if (const Pose* goal = std::get_if<Pose>(&scenario.problem.goal)) route.push_back(*goal);
  return route;
}

double surfaceDeviation(const LoadedScenario& scenario) { return largestOfBoth(scenario.deflections, scenario); }

double coordinateSpacing(const LoadedScenario& scenario) {
  return largestOfBoth(scenario.coordinateSpacings, scenario);
}

}  // namespace glissade
