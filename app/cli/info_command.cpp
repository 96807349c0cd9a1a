#include "app/cli/commands.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "app/cli/environment_report.h"
#include "app/cli/interrupt.h"
#include "app/cli/text_cells.h"
#include "engine/base/length_units.h"
#include "engine/files/forbidden_places_of.h"
#include "engine/files/part_files.h"
#include "engine/files/product_file.h"
#include "engine/files/product_name.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_io.h"
#include "engine/files/semantics_json.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/import/missing_shapes_json.h"

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
  return {valueOf(loaded.deflections, body.id), valueOf(loaded.coordinateSpacings, body.id)};
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
          {"name", body.shown()},
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
std::size_t nameWidth(const std::vector<RigidBody>& bodies) {
  std::size_t width = 23;
  for (const RigidBody& body : bodies) width = std::max(width, widthOf(body.shown()));
  return width + 1;
}

void printBody(const RigidBody& body, const Uncertainty& uncertainty, const std::string& role, std::size_t width,
               MeshAudits& audits, const Console& console) {
  const MeshAudit& result = audits.of(body.mesh);
  const Vector3 size = result.box.sizes();
  const std::string closed = console.text(GLISSADE_TEXT("closed"));
  const std::string open = console.text(GLISSADE_TEXT("OPEN"));
  const std::string quality = toLeft(result.closed() ? closed : open, std::max(widthOf(closed), widthOf(open)));
  Message line{GLISSADE_TEXT("  %1%2%3 triangles  %4  %5 x %6 x %7 m"),
               {toLeft(body.shown(), width), toLeft(role, 8), toRight(std::to_string(result.triangles), 8), quality,
                rounded(size.x()), rounded(size.y()), rounded(size.z())}};
  if (uncertainty.deflection > 0.0) {
    line = {GLISSADE_TEXT("%1  within %2 mm of its surface"), {line, rounded(1000.0 * uncertainty.deflection)}};
  }
  if (uncertainty.coordinateSpacing > 0.0) {
    line = {GLISSADE_TEXT("%1  coordinate spacing %2 mm"), {line, rounded(1000.0 * uncertainty.coordinateSpacing)}};
  }
  console.print(line);
}

/// The number of present bodies below each node.
std::vector<std::size_t> bodyCounts(const Product& tree, const std::vector<RigidBody>& bodies) {
  std::vector<std::size_t> counts(tree.nodes().size(), 0);
  for (const RigidBody& body : bodies) {
    for (auto node = tree.find(body.id.text()); node; node = tree.nodes()[*node].parent) ++counts[*node];
  }
  return counts;
}

std::string attributesText(const Attributes& attributes) {
  std::string text;
  for (const auto& [name, value] : attributes) text += "  " + name + " " + toText(value);
  return text;
}

/// Prints the title of a list below an empty line.
void printTitle(CatalogueText title, const Console& console) {
  console.print({});
  console.print(title);
}

/// Prints each assembly below its parent; prints nothing if there are no assemblies.
void printTree(const Product& tree, const std::vector<RigidBody>& bodies, const Console& console) {
  const std::vector<std::size_t> counts = bodyCounts(tree, bodies);
  const std::vector<std::string> names = tree.shownNames();
  std::vector<std::size_t> levels;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < tree.nodes().size(); ++i) {
    const Product::Node& node = tree.nodes()[i];
    levels.push_back(node.parent ? levels[*node.parent] + 1 : 0);
    if (!node.parent) open.insert(open.begin(), i);
  }
  bool isFirst = true;
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    const Product::Node& node = tree.nodes()[i];
    open.insert(open.end(), node.children.rbegin(), node.children.rend());
    if (node.children.empty()) continue;
    if (std::exchange(isFirst, false)) printTitle(GLISSADE_TEXT("assemblies"), console);
    console.print({GLISSADE_TEXT("%1  %2 {2|body|bodies}%3"),
                   {std::string(2 * levels[i] + 2, ' ') + names[i], counts[i], attributesText(node.attributes)}});
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
    if (!node.attributes.empty()) json["attributes"] = AttributesFormat().write(node.attributes);
    list.push_back(std::move(json));
  }
  return list;
}

/// Prints the problem of a scenario and its parameters.
void printProblem(const LoadedScenario& loaded, const Console& console) {
  const auto& min = loaded.problem.bounds.min();
  const auto& max = loaded.problem.bounds.max();
  console.print({});
  console.print(
      {GLISSADE_TEXT("workspace  x %1 ... %2, y %3 ... %4, z %5 ... %6 m"),
       {rounded(min.x()), rounded(max.x()), rounded(min.y()), rounded(max.y()), rounded(min.z()), rounded(max.z())}});
  console.print(std::holds_alternative<GoalOut>(loaded.problem.goal) ? GLISSADE_TEXT("goal       removed")
                                                                     : GLISSADE_TEXT("goal       a configuration"));
  console.print({GLISSADE_TEXT("planner    %1"), {loaded.scenario.planner}});
  console.print({GLISSADE_TEXT("seed       %1"), {loaded.scenario.seed}});
  for (const ParameterSpec& spec : parameterTable()) {
    std::cout << toLeft(std::string(spec.key), 20) << loaded.parameters[spec.id] << " " << spec.unit << "\n";
  }
}

void printText(const LoadedScenario& loaded, const Console& console) {
  const Scenario& scenario = loaded.scenario;
  std::cout << nameOfProduct(loaded) << "\n";
  if (!scenario.description.empty()) std::cout << scenario.description << "\n";
  printTitle(GLISSADE_TEXT("bodies"), console);
  MeshAudits audits;
  const std::size_t width = nameWidth(rigidBodiesOf(loaded));
  for (const RigidBody& body : loaded.obstacles) {
    const bool isStatic = body.mobility == Mobility::Static;
    const std::string role = console.text(isStatic ? GLISSADE_TEXT("static") : GLISSADE_TEXT("mobile"));
    printBody(body, uncertaintyOf(body, loaded), role, width, audits, console);
  }
  for (const RigidBody& body : loaded.objectBodies) {
    printBody(body, uncertaintyOf(body, loaded), console.text(GLISSADE_TEXT("object")), width, audits, console);
  }
  printTree(loaded.product, rigidBodiesOf(loaded), console);
  printProblem(loaded, console);
}

/// The unit of the lengths of most bodies; empty if no body states a unit.
Message unitInWords(const Product& tree) {
  static constexpr std::array<std::pair<double, CatalogueText>, 5> kNames{{{0.001, GLISSADE_TEXT("millimetres")},
                                                                           {0.01, GLISSADE_TEXT("centimetres")},
                                                                           {1.0, GLISSADE_TEXT("metres")},
                                                                           {kInch, GLISSADE_TEXT("inches")},
                                                                           {kFoot, GLISSADE_TEXT("feet")}}};
  const double unit = tree.lengthUnit();
  if (unit <= 0.0) return {};
  for (const auto& [metres, name] : kNames) {
    if (metres == unit) return name;
  }
  return {GLISSADE_TEXT("units of %1"), {Length{unit}}};
}

void printMissing(const MissingShapes& missing, const Console& console) {
  if (missing.empty()) return;
  console.print({});
  console.print({GLISSADE_TEXT("shapes that are no bodies  %1"), {listOf(missing)}});
}

/// Prints the bodies of a part file, which has neither an object nor a problem.
void printProduct(const std::string& file, const AssembledProduct& product, const Console& console) {
  std::cout << file << "\n";
  const Message counts{GLISSADE_TEXT("%1 {1|body|bodies}, %2 different {2|mesh|meshes}, %3 {3|triangle|triangles}"),
                       {product.bodies.size(), differentMeshes(product.bodies), trianglesOf(product.bodies)}};
  const Message unit = unitInWords(product.tree);
  console.print(unit.empty() ? counts : Message{GLISSADE_TEXT("%1, lengths in %2"), {counts, unit}});
  printTitle(GLISSADE_TEXT("bodies"), console);
  MeshAudits audits;
  const std::size_t width = nameWidth(product.bodies);
  for (std::size_t i = 0; i < product.bodies.size(); ++i) {
    printBody(product.bodies[i], {product.deflections[i], 0.0}, "", width, audits, console);
  }
  printTree(product.tree, product.bodies, console);
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
    return reportError(
        {ErrorKind::Usage, options.file, "--places", GLISSADE_TEXT("needs a scenario: a part file has no object"),
         GLISSADE_TEXT("Make a scenario of the file with glissade-cli new.")},
        options.console);
  }
  const Interrupt interrupt;
  const auto loaded = readProduct(options.file, interrupt.token(), 0.0, {options.open, {}});
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  if (options.console.json) {
    Json report = toJson(options.file, loaded->product);
    report["missing_shapes"] = missingShapesJson(loaded->missing);
    printJson(report);
  } else {
    printProduct(options.file, loaded->product, options.console);
    printMissing(loaded->missing, options.console);
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
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  if (options.saveRegions) {
    if (const Outcome saved = saveRegions(options.file, *loaded); !saved) {
      return reportError(saved.error(), options.console);
    }
  }
  SceneKnowledgePtr knowledge;
  if (options.places) {
    const auto built = buildSceneKnowledge(loaded->problem, loaded->parameters[ParameterId::RequiredClearance]);
    if (!built) return reportError(built.error(), options.console);
    knowledge = *built;
    warnOfEdits(*loaded, *knowledge, options.console);
  }
  if (!options.console.json) {
    printText(*loaded, options.console);
    printMissing(loaded->missing, options.console);
    if (knowledge) {
      printEnvironment(*knowledge, semanticsOf(loaded->problem, *knowledge, loaded->problem.scene.edits),
                       options.console);
    }
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
