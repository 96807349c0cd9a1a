#include "engine/geometry/mesh_audit.h"
#include "engine/import/input_file.h"
#include "engine/scenario/geometry_loader.h"
#include "engine/scenario/omplapp_reader.h"
#include "engine/scenario/scenario_io.h"

namespace glissade {
namespace {

constexpr Colour kStaticColour{0.55, 0.62, 0.70};
constexpr Colour kMobileColour{0.80, 0.66, 0.42};
constexpr Colour kObjectColour{0.93, 0.91, 0.86};

Pose normalized(const Pose& pose) { return {pose.position, pose.orientation.normalized()}; }

/// What a user should know of a body before he trusts an answer about it.
void warnAboutMesh(const RigidBody& body, const std::string& file, Warnings& warnings) {
  if (audit(*body.mesh).closed()) return;
  warnings.push_back({ErrorKind::MalformedInput, file, "body '" + body.id + "'",
                      "its surface is not closed: it is a shell, and being inside it is no collision",
                      "Close the surface in the program that made it if it stands for a solid."});
}

/// The sign of a wrong unit: an object larger than the space it is to move in.
void warnAboutSize(LoadedScenario& loaded) {
  const double radius = loaded.problem.world->objectRadius();
  if (radius <= loaded.problem.bounds.diagonal().norm()) return;
  loaded.warnings.push_back({ErrorKind::MalformedInput, loaded.file, "/object",
                             "the object is larger than the workspace", "Check the unit of its file."});
}

Outcome loadBodies(LoadedScenario& loaded, const std::string& folder) {
  GeometryLoader loader(loaded.scenario, folder, loaded.file);
  for (const BodyDescription& description : loaded.scenario.bodies) {
    const Colour& fallback = description.mobility == Mobility::Mobile ? kMobileColour : kStaticColour;
    const Result<std::vector<RigidBody>> bodies = loader.bodies(description, fallback);
    if (!bodies) return bodies.error();
    loaded.obstacles.insert(loaded.obstacles.end(), bodies->begin(), bodies->end());
  }
  const Result<RigidBody> object = loader.object(loaded.scenario.object, kObjectColour);
  if (!object) return object.error();
  loaded.object = *object;
  loaded.object.X_WB = normalized(loaded.scenario.start);
  loaded.warnings = loader.warnings();
  return Done{};
}

Outcome applyParameters(LoadedScenario& loaded) {
  loaded.parameters = ParameterValues(loaded.problem.world->objectRadius());
  for (const auto& [id, value] : loaded.scenario.parameters) {
    const Outcome outcome = loaded.parameters.set(id, value);
    if (outcome) continue;
    const std::string place = "/parameters/" + std::string(specOf(id).key);
    return Diagnostic{ErrorKind::MalformedInput, loaded.file, place, outcome.error().reason, outcome.error().advice};
  }
  return Done{};
}

}  // namespace

Result<LoadedScenario> loadScenario(const std::string& file) {
  const Result<std::string> text = readInputFile(file, kLargestTextFile);
  if (!text) return text.error();
  Result<Scenario> scenario = endingOf(file) == "cfg" ? parseOmplApp(*text, file) : parseScenario(*text, file);
  if (!scenario) return scenario.error();
  return realiseScenario(std::move(*scenario), folderOf(file), file);
}

Result<LoadedScenario> realiseScenario(Scenario scenario, const std::string& folder, const std::string& file) {
  LoadedScenario loaded;
  loaded.scenario = std::move(scenario);
  loaded.file = file;
  if (const Outcome bodies = loadBodies(loaded, folder); !bodies) return bodies.error();
  for (const RigidBody& body : loaded.obstacles) warnAboutMesh(body, file, loaded.warnings);
  warnAboutMesh(loaded.object, file, loaded.warnings);

  loaded.problem.world = CollisionWorld::build(loaded.obstacles, loaded.object.mesh);
  loaded.problem.start = normalized(loaded.scenario.start);
  loaded.problem.goal = loaded.scenario.goal;
  if (Pose* goal = std::get_if<Pose>(&loaded.problem.goal)) *goal = normalized(*goal);
  loaded.problem.bounds = loaded.scenario.workspace;
  warnAboutSize(loaded);
  if (const Outcome parameters = applyParameters(loaded); !parameters) return parameters.error();
  return loaded;
}

}  // namespace glissade
