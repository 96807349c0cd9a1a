#include "app/cli/commands.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "app/cli/environment_report.h"
#include "app/cli/interrupt.h"
#include "engine/base/length_units.h"
#include "engine/base/quantity_text.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/import/missing_shapes_json.h"
#include "engine/scenario/forbidden_places_of.h"
#include "engine/scenario/part_files.h"
#include "engine/scenario/product_file.h"
#include "engine/scenario/product_name.h"
#include "engine/scenario/scenario_bodies.h"
#include "engine/scenario/scenario_io.h"
#include "engine/scenario/semantics_json.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

Json boxJson(const Box3& box) { return {{"min", vectorJson(box.min())}, {"max", vectorJson(box.max())}}; }

/// How far the mesh of a body may deviate, metres; 0 if the mesh is exact.
struct Uncertainty {
  double deflection = 0.0;
  double coordinateSpacing = 0.0;
};

Uncertainty uncertaintyOf(const RigidBody& body, const LoadedScenario& loaded) {
  const auto valueOf = [&](const std::map<std::string, double>& values) {
    const auto known = values.find(body.id);
    return known == values.end() ? 0.0 : known->second;
  };
  return {valueOf(loaded.deflections), valueOf(loaded.coordinateSpacings)};
}

/// Audits each mesh of a scenario once.
class MeshAudits {
 public:
  const MeshAudit& of(const MeshPtr& mesh) {
    const auto known = audits_.find(mesh);
    return known != audits_.end() ? known->second : audits_.emplace(mesh, audit(*mesh)).first->second;
  }

 private:
  std::map<MeshPtr, MeshAudit> audits_;
};

/// The number of different meshes.
std::size_t differentMeshes(const std::vector<RigidBody>& bodies) {
  std::set<MeshPtr> meshes;
  for (const RigidBody& body : bodies) meshes.insert(body.mesh);
  return meshes.size();
}

std::size_t trianglesOf(const std::vector<RigidBody>& bodies) {
  std::size_t triangles = 0;
  for (const RigidBody& body : bodies) triangles += body.mesh->triangles.size();
  return triangles;
}

Json toJson(const RigidBody& body, const Uncertainty& uncertainty, MeshAudits& audits) {
  const MeshAudit& result = audits.of(body.mesh);
  return {{"id", body.id},
          {"name", body.name},
          {"mobility", kMobilityNames.of(body.mobility)},
          {"triangles", result.triangles},
          {"closed", result.closed()},
          {"open_edges", result.openEdges},
          {"degenerate_triangles", result.degenerateTriangles},
          {"components", result.surfaces.size()},
          {"deflection_m", uncertainty.deflection},
          {"coordinate_spacing_m", uncertainty.coordinateSpacing},
          {"volume_m3", result.closed() ? number(std::abs(result.volume)) : Json(nullptr)},
          {"box_W", boxJson(boundingBox(*body.mesh, body.X_WB))}};
}

Json toJson(const Asset& asset) {
  return {{"id", asset.id},
          {"path", asset.path},
          {"sha256", asset.sha256},
          {"unit_m", asset.unit},
          {"up_axis", kUpAxisNames.of(asset.up)}};
}

/// The width of the column of names.
int nameWidth(const std::vector<RigidBody>& bodies) {
  std::size_t width = 23;
  for (const RigidBody& body : bodies) width = std::max(width, body.shown().size());
  return static_cast<int>(width + 1);
}

void printBody(const RigidBody& body, const Uncertainty& uncertainty, const char* role, int width, MeshAudits& audits) {
  const MeshAudit& result = audits.of(body.mesh);
  const Vector3 size = result.box.sizes();
  std::cout << "  " << std::left << std::setw(width) << body.shown() << std::setw(8) << role << std::right
            << std::setw(8) << result.triangles << " triangles  " << (result.closed() ? "closed" : "OPEN  ") << "  "
            << size.x() << " x " << size.y() << " x " << size.z() << " m";
  if (uncertainty.deflection > 0.0) {
    std::cout << "  within " << 1000.0 * uncertainty.deflection << " mm of its surface";
  }
  if (uncertainty.coordinateSpacing > 0.0) {
    std::cout << "  coordinate spacing " << 1000.0 * uncertainty.coordinateSpacing << " mm";
  }
  std::cout << "\n";
}

/// The number of present bodies below each node.
std::vector<std::size_t> bodyCounts(const Product& tree, const std::vector<RigidBody>& bodies) {
  std::vector<std::size_t> counts(tree.nodes().size(), 0);
  for (const RigidBody& body : bodies) {
    for (auto node = tree.find(body.id); node; node = tree.nodes()[*node].parent) ++counts[*node];
  }
  return counts;
}

std::string attributesText(const Attributes& attributes) {
  std::string text;
  for (const auto& [name, value] : attributes) text += "  " + name + " " + toText(value);
  return text;
}

/// Prints each assembly below its parent; prints nothing if there are no assemblies.
void printTree(const Product& tree, const std::vector<RigidBody>& bodies) {
  const std::vector<std::size_t> counts = bodyCounts(tree, bodies);
  const std::vector<std::string> names = tree.shownNames();
  std::vector<std::size_t> levels;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < tree.nodes().size(); ++i) {
    const Product::Node& node = tree.nodes()[i];
    levels.push_back(node.parent ? levels[*node.parent] + 1 : 0);
    if (!node.parent) open.insert(open.begin(), i);
  }
  const char* title = "\nassemblies\n";
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    const Product::Node& node = tree.nodes()[i];
    open.insert(open.end(), node.children.rbegin(), node.children.rend());
    if (node.children.empty()) continue;
    std::cout << std::exchange(title, "") << std::string(2 * levels[i] + 2, ' ') << names[i] << "  " << counts[i]
              << (counts[i] == 1 ? " body" : " bodies") << attributesText(node.attributes) << "\n";
  }
}

Json toJson(const Product& tree, const std::vector<RigidBody>& bodies) {
  const std::vector<std::size_t> counts = bodyCounts(tree, bodies);
  Json list = Json::array();
  for (std::size_t i = 0; i < tree.nodes().size(); ++i) {
    const Product::Node& node = tree.nodes()[i];
    if (node.children.empty()) continue;
    Json json{{"id", node.id}, {"name", node.names.product}, {"bodies", counts[i]}};
    if (!node.names.occurrence.empty()) json["occurrence"] = node.names.occurrence;
    if (!node.names.designator.empty()) json["designator"] = node.names.designator;
    if (node.parent) json["in"] = tree.nodes()[*node.parent].id;
    if (!node.attributes.empty()) json["attributes"] = attributesToJson(node.attributes);
    list.push_back(std::move(json));
  }
  return list;
}

void printText(const LoadedScenario& loaded) {
  const Scenario& scenario = loaded.scenario;
  std::cout << nameOfProduct(loaded) << "\n";
  if (!scenario.description.empty()) std::cout << scenario.description << "\n";
  std::cout << "\nbodies\n";
  MeshAudits audits;
  const int width = nameWidth(rigidBodiesOf(loaded));
  for (const RigidBody& body : loaded.obstacles) {
    const char* role = kMobilityNames.of(body.mobility);
    printBody(body, uncertaintyOf(body, loaded), role, width, audits);
  }
  for (const RigidBody& body : loaded.objectBodies) {
    printBody(body, uncertaintyOf(body, loaded), "object", width, audits);
  }
  printTree(loaded.product, rigidBodiesOf(loaded));
  const auto& min = loaded.problem.bounds.min();
  const auto& max = loaded.problem.bounds.max();
  std::cout << "\nworkspace  x " << min.x() << " ... " << max.x() << ", y " << min.y() << " ... " << max.y() << ", z "
            << min.z() << " ... " << max.z() << " m\n"
            << "goal       " << (std::holds_alternative<GoalOut>(loaded.problem.goal) ? "out" : "a configuration")
            << "\nplanner    " << scenario.planner << "\nseed       " << scenario.seed << "\n";
  for (const ParameterSpec& spec : parameterTable()) {
    std::cout << std::left << std::setw(20) << spec.key << loaded.parameters[spec.id] << " " << spec.unit << "\n";
  }
}

/// Text for the length unit of most bodies; empty if no body states a unit.
std::string unitText(const Product& tree) {
  static constexpr std::array<std::pair<double, const char*>, 5> kNames{
      {{0.001, "millimetres"}, {0.01, "centimetres"}, {1.0, "metres"}, {kInch, "inches"}, {kFoot, "feet"}}};
  const double unit = tree.lengthUnit();
  if (unit <= 0.0) return {};
  for (const auto& [metres, name] : kNames) {
    if (metres == unit) return std::string(", lengths in ") + name;
  }
  return ", lengths in units of " + inMillimetres(unit);
}

void printMissing(const MissingShapes& missing) {
  if (!missing.empty()) std::cout << "\nshapes that are no bodies  " << listOf(missing) << "\n";
}

/// Prints the bodies of a part file, which has neither an object nor a problem.
void printProduct(const std::string& file, const AssembledProduct& product) {
  std::cout << file << "\n"
            << product.bodies.size() << " bodies, " << differentMeshes(product.bodies) << " different meshes, "
            << trianglesOf(product.bodies) << " triangles" << unitText(product.tree) << "\n\nbodies\n";
  MeshAudits audits;
  const int width = nameWidth(product.bodies);
  for (std::size_t i = 0; i < product.bodies.size(); ++i) {
    printBody(product.bodies[i], {product.deflections[i], 0.0}, "", width, audits);
  }
  printTree(product.tree, product.bodies);
}

Json toJson(const std::string& file, const AssembledProduct& product) {
  Json report{{"file", file},
              {"meshes", differentMeshes(product.bodies)},
              {"triangles", trianglesOf(product.bodies)},
              {"length_unit_m", product.tree.lengthUnit()},
              {"bodies", Json::array()}};
  MeshAudits audits;
  for (std::size_t i = 0; i < product.bodies.size(); ++i) {
    report["bodies"].push_back(toJson(product.bodies[i], {product.deflections[i], 0.0}, audits));
  }
  report["assemblies"] = toJson(product.tree, product.bodies);
  return report;
}

int runProductInfo(const InfoOptions& options) {
  if (options.places) {
    return reportError({ErrorKind::Usage, options.file, "--places", "needs a scenario: a part file has no object",
                        "Make a scenario of the file with glissade-cli new."},
                       options.format);
  }
  const Interrupt interrupt;
  const auto loaded = readProduct(options.file, interrupt.token(), 0.0, {options.open, {}});
  if (!loaded) return reportError(loaded.error(), options.format);
  reportWarnings(loaded->warnings);
  if (options.format == Format::Json) {
    Json report = toJson(options.file, loaded->product);
    report["missing_shapes"] = missingShapesJson(loaded->missing);
    printJson(report);
  } else {
    printProduct(options.file, loaded->product);
    printMissing(loaded->missing);
  }
  return 0;
}

/// Writes the forbidden regions into the scenario file and keeps the rest of the file.
Outcome saveRegions(const std::string& file, LoadedScenario& loaded) {
  auto places = forbiddenPlacesOf(loaded, loaded.scenario);
  if (!places) return places.error();
  loaded.scenario.forbiddenRegions = std::move(*places);
  return saveScenario(loaded.scenario, file);
}

}  // namespace

int runInfo(const InfoOptions& options) {
  if (isPartFile(usualPart(options.file).path)) return runProductInfo(options);
  auto loaded = loadScenario(options.file);
  if (!loaded) return reportError(loaded.error(), options.format);
  reportWarnings(loaded->warnings);
  if (options.saveRegions) {
    if (const Outcome saved = saveRegions(options.file, *loaded); !saved) {
      return reportError(saved.error(), options.format);
    }
  }
  SceneKnowledgePtr knowledge;
  if (options.places) {
    const auto built = buildSceneKnowledge(loaded->problem, loaded->parameters[ParameterId::RequiredClearance]);
    if (!built) return reportError(built.error(), options.format);
    knowledge = *built;
    warnOfEdits(*loaded, *knowledge);
  }
  if (options.format == Format::Text) {
    printText(*loaded);
    printMissing(loaded->missing);
    if (knowledge) printEnvironment(*knowledge, semanticsOf(loaded->problem, *knowledge, loaded->problem.scene.edits));
    return 0;
  }
  const Scenario& scenario = loaded->scenario;
  Json report;
  report["name"] = nameOfProduct(*loaded);
  report["description"] = scenario.description;
  report["assets"] = Json::array();
  for (const Asset& asset : scenario.assets) report["assets"].push_back(toJson(asset));
  report["missing_shapes"] = missingShapesJson(loaded->missing);
  report["bodies"] = Json::array();
  MeshAudits audits;
  for (const RigidBody& body : loaded->obstacles)
    report["bodies"].push_back(toJson(body, uncertaintyOf(body, *loaded), audits));
  report["object"] = toJson(loaded->object, uncertaintyOf(loaded->object, *loaded), audits);
  if (scenario.object.isGroup()) {
    for (const RigidBody& body : loaded->objectBodies) {
      report["object"]["with"].push_back(toJson(body, uncertaintyOf(body, *loaded), audits));
    }
  }
  report["assemblies"] = toJson(loaded->product, rigidBodiesOf(*loaded));
  report["object"]["radius_m"] = loaded->problem.world->objectRadius();
  report["workspace"] = boxJson(loaded->problem.bounds);
  report["start"] = poseJson(loaded->problem.start);
  const Pose* goal = std::get_if<Pose>(&loaded->problem.goal);
  report["goal"] = goal != nullptr ? poseJson(*goal) : Json("out");
  report["way_points"] = scenario.wayPoints.size();
  report["planner"] = scenario.planner;
  report["seed"] = scenario.seed;
  for (const ParameterSpec& spec : parameterTable()) {
    report["parameters"][std::string(spec.key)] = loaded->parameters[spec.id];
  }
  if (knowledge) {
    report["environment"] = toJson(*knowledge, semanticsOf(loaded->problem, *knowledge, loaded->problem.scene.edits));
  }
  printJson(report);
  return 0;
}

}  // namespace glissade::cli
