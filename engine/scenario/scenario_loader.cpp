#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/base/file.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"
#include "engine/import/mesh_import.h"
#include "engine/import/omplapp_config.h"
#include "engine/import/urdf_import.h"
#include "engine/scenario/asset_path.h"
#include "engine/scenario/scenario_io.h"

namespace glissade {
namespace {

constexpr std::size_t kMostScenarioBytes = 16U << 20;
constexpr Colour kStaticColour{0.62, 0.66, 0.72};
constexpr Colour kMobileColour{0.80, 0.68, 0.45};
constexpr Colour kObjectColour{0.93, 0.90, 0.80};

Pose normalized(const Pose& pose) { return {pose.position, pose.orientation.normalized()}; }

/// One rigid part of a body's or the object's geometry.
struct Part {
  std::string name;  ///< of the URDF link; empty where there is only one part
  TriangleMesh mesh;
  Pose X_BP;
  std::optional<Colour> colour;
};

/// Imports the geometry that a scenario names.
class GeometryLoader {
 public:
  GeometryLoader(const Scenario& scenario, std::string folder, std::string file)
      : scenario_(scenario), folder_(std::move(folder)), file_(std::move(file)) {}

  Result<std::vector<Part>> load(const Geometry& geometry) {
    if (const auto* mesh = std::get_if<MeshGeometry>(&geometry)) return loadMesh(mesh->asset);
    if (const auto* urdf = std::get_if<UrdfGeometry>(&geometry)) return loadUrdf(urdf->asset);
    if (const auto* box = std::get_if<BoxGeometry>(&geometry)) return single(makeBox(box->size));
    if (const auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
      return single(makeCylinder(cylinder->radius, cylinder->length));
    }
    return single(makeSphere(std::get<SphereGeometry>(geometry).radius));
  }

  /// Mean of the vertices of the mesh loaded last, in its body's frame.
  const Vector3& vertexMean() const { return vertexMean_; }
  Warnings& warnings() { return warnings_; }

 private:
  static std::vector<Part> single(TriangleMesh mesh) { return {{"", std::move(mesh), Pose::identity(), std::nullopt}}; }

  const Asset& assetById(const std::string& id) const {
    return *std::find_if(scenario_.assets.begin(), scenario_.assets.end(), [&](const Asset& a) { return a.id == id; });
  }

  /// The file of an asset; warns where it is not the one that the scenario was saved with.
  Result<std::string> fileOf(const Asset& asset) {
    constexpr std::size_t kMostBytes = 100U << 20;
    const std::string path = assetFile(asset, folder_);
    const auto content = readFile(path, kMostBytes);
    if (!content) return content.error();
    if (!asset.sha256.empty() && sha256(*content) != asset.sha256) {
      warnings_.push_back({ErrorKind::MalformedInput, path, "", "has changed since the scenario was saved",
                           "Check the scenario and save it again."});
    }
    return path;
  }

  /// Takes file coordinates to ours: metres, z up.
  static TriangleMesh interpreted(const TriangleMesh& mesh, const Asset& asset) {
    const Pose upright{Vector3::Zero(),
                       asset.up == UpAxis::Y ? fromRollPitchYaw(std::acos(0.0), 0.0, 0.0) : Quaternion::Identity()};
    return transformed(scaled(mesh, Vector3::Constant(asset.unit)), upright);
  }

  Result<std::vector<Part>> loadMesh(const std::string& id) {
    const Asset& asset = assetById(id);
    const auto path = fileOf(asset);
    if (!path) return path.error();
    auto imported = importMesh(*path);
    if (!imported) return imported.error();
    TriangleMesh point;
    point.vertices = {imported->vertexMean};
    vertexMean_ = interpreted(point, asset).vertices.front();
    return single(welded(interpreted(imported->mesh, asset)));
  }

  Result<std::vector<Part>> loadUrdf(const std::string& id) {
    const Asset& asset = assetById(id);
    if (asset.unit != 1.0 || asset.up != UpAxis::Z) {
      return Diagnostic{ErrorKind::MalformedInput, file_, "asset '" + asset.id + "'",
                        "has a unit or an up-axis, but a URDF file is always in metres and z up",
                        "Leave out 'unit' and 'up_axis'."};
    }
    const auto path = fileOf(asset);
    if (!path) return path.error();
    auto links = importUrdf(*path, folderOf(*path));
    if (!links) return links.error();
    std::vector<Part> parts;
    for (UrdfLink& link : *links) parts.push_back({link.name, std::move(link.mesh), link.X_RL, link.colour});
    return parts;
  }

  const Scenario& scenario_;
  std::string folder_;
  std::string file_;
  Vector3 vertexMean_ = Vector3::Zero();
  Warnings warnings_;
};

void warnIfOpen(const RigidBody& body, const std::string& file, Warnings& warnings) {
  if (audit(*body.mesh).closed()) return;
  warnings.push_back({ErrorKind::MalformedInput, file, "body '" + body.name + "'", "is not a closed surface",
                      "Being inside it is not seen as a collision; close its surface."});
}

/// What an edit of the attribute says goes before the body's own.
Mobility mobilityOf(const BodyDescription& description) {
  const auto edited = description.attributes.find("mobility");
  if (edited == description.attributes.end()) return description.mobility;
  return edited->second == AttributeValue(std::string("mobile")) ? Mobility::Mobile : Mobility::Static;
}

std::vector<RigidBody> toBodies(const BodyDescription& description, std::vector<Part> parts) {
  std::vector<RigidBody> bodies;
  for (Part& part : parts) {
    RigidBody body;
    const bool several = !part.name.empty();
    body.id = several ? description.id + "/" + part.name : description.id;
    body.name = several ? part.name : description.name;
    body.mobility = mobilityOf(description);
    body.mesh = std::make_shared<const TriangleMesh>(std::move(part.mesh));
    body.X_WB = normalized(description.pose) * part.X_BP;
    const Colour usual = body.mobility == Mobility::Static ? kStaticColour : kMobileColour;
    body.colour = description.colour ? *description.colour : part.colour.value_or(usual);
    bodies.push_back(std::move(body));
  }
  return bodies;
}

Result<RigidBody> loadObject(const Scenario& scenario, GeometryLoader& loader) {
  auto parts = loader.load(scenario.object.geometry);
  if (!parts) return parts.error();
  TriangleMesh mesh;
  for (const Part& part : *parts) append(mesh, transformed(part.mesh, part.X_BP));
  if (scenario.object.centreOnVertexMean) mesh = transformed(mesh, Pose::translation(-loader.vertexMean()));
  RigidBody object;
  object.id = scenario.object.id;
  object.name = scenario.object.name;
  object.mobility = Mobility::Mobile;
  object.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  object.X_WB = normalized(scenario.start);
  object.colour = scenario.object.colour ? *scenario.object.colour : parts->front().colour.value_or(kObjectColour);
  return object;
}

Outcome applyParameters(const Scenario& scenario, const std::string& file, ParameterValues& values) {
  for (const auto& [id, value] : scenario.parameters) {
    const Outcome outcome = values.set(id, value);
    if (outcome) continue;
    Diagnostic why = outcome.error();
    why.kind = ErrorKind::MalformedInput;
    why.file = file;
    why.place = "/parameters/" + why.place;
    return why;
  }
  return Done{};
}

SceneDescription describeScene(const Scenario& scenario) {
  SceneDescription scene;
  scene.objectId = scenario.object.id;
  scene.environment = scenario.environment;
  scene.edits = std::make_shared<const SemanticEdits>(semanticEditsOf(scenario));
  if (scenario.rules) scene.rules = std::make_shared<const StrategyRules>(*scenario.rules);
  return scene;
}

Scenario toScenario(const OmplAppConfig& config) {
  Scenario scenario;
  scenario.name = config.name;
  scenario.description = "Imported from OMPL.app";
  scenario.assets.push_back({"robot", config.robot, "", 1.0, UpAxis::Z});
  scenario.object.id = "robot";
  scenario.object.name = "robot";
  scenario.object.geometry = MeshGeometry{"robot"};
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

Result<Scenario> readScenario(const std::string& file) {
  if (std::filesystem::path(file).extension() == ".cfg") {
    const auto config = readOmplAppConfig(file);
    if (!config) return config.error();
    return toScenario(*config);
  }
  const auto text = readFile(file, kMostScenarioBytes);
  if (!text) return text.error();
  return parseScenario(*text, file);
}

}  // namespace

Result<LoadedScenario> loadScenario(const std::string& file) {
  auto scenario = readScenario(file);
  if (!scenario) return scenario.error();
  return realiseScenario(std::move(*scenario), folderOf(file), file);
}

Result<LoadedScenario> realiseScenario(Scenario scenario, const std::string& folder, const std::string& file) {
  LoadedScenario loaded;
  loaded.file = file;
  GeometryLoader loader(scenario, folder, file);
  for (const BodyDescription& body : scenario.bodies) {
    auto parts = loader.load(body.geometry);
    if (!parts) return parts.error();
    for (RigidBody& rigid : toBodies(body, std::move(*parts))) loaded.obstacles.push_back(std::move(rigid));
  }
  auto object = loadObject(scenario, loader);
  if (!object) return object.error();
  loaded.object = std::move(*object);
  loaded.warnings = std::move(loader.warnings());
  for (const RigidBody& body : loaded.obstacles) warnIfOpen(body, file, loaded.warnings);
  warnIfOpen(loaded.object, file, loaded.warnings);

  loaded.problem.world = CollisionWorld::build(loaded.obstacles, loaded.object.mesh);
  // Files may be off by kQuaternionNorm; a rotation that stretches would falsify every distance.
  loaded.problem.start = normalized(scenario.start);
  loaded.problem.goal = scenario.goal;
  if (Pose* goal = std::get_if<Pose>(&loaded.problem.goal)) *goal = normalized(*goal);
  loaded.problem.bounds = scenario.workspace;
  loaded.problem.scene = describeScene(scenario);
  loaded.parameters = ParameterValues(loaded.problem.world->objectRadius());
  const Outcome parameters = applyParameters(scenario, file, loaded.parameters);
  if (!parameters) return parameters.error();
  loaded.scenario = std::move(scenario);
  return loaded;
}

Result<std::string> assetSha256(const Asset& asset, const std::string& scenarioFile) {
  constexpr std::size_t kMostBytes = 100U << 20;
  const auto content = readFile(assetFile(asset, folderOf(scenarioFile)), kMostBytes);
  if (!content) return content.error();
  return sha256(*content);
}

Outcome saveScenario(const Scenario& scenario, const std::string& file) {
  Scenario hashed = scenario;
  for (Asset& asset : hashed.assets) {
    const auto hash = assetSha256(asset, file);
    if (!hash) return hash.error();
    asset.sha256 = *hash;
  }
  const std::string text = writeScenario(hashed);
  if (const auto readBack = parseScenario(text, file); !readBack) return readBack.error();
  return writeFileAtomically(file, text);
}

}  // namespace glissade
