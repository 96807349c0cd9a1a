#include "engine/files/part_adder.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/base/file.h"
#include "engine/base/printable_text.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_product.h"
#include "engine/import/asset_path.h"
#include "engine/import/step_import.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

std::string stemOf(const PartFile& part) { return printableLine(fs::path(part.path).stem().string()); }

/// Name and id of a body that is made from the part. An id has '.' instead of '/', which separates parts of ids.
std::string nameOf(const PartFile& part) { return part.part.empty() ? stemOf(part) : part.part; }
std::string idOf(const PartFile& part) {
  std::string id = nameOf(part);
  std::replace(id.begin(), id.end(), '/', '.');
  return id;
}

/// The name in the file of the last of these steps. Where the step only adds a number to the name, to distinguish
/// siblings, the step itself.
std::string nameInFile(const PartFile& part, const std::vector<std::string>& steps) {
  if (part.names.size() < steps.size()) return steps.back();
  const std::string& name = part.names[steps.size() - 1].product;
  return isNumbered(steps.back(), name) ? steps.back() : name;
}

/// Copies the names of the use to which the first `steps` steps of the part's path lead.
void noteUse(const PartFile& part, std::size_t steps, NodeDescription& node) {
  if (part.names.size() < steps) return;
  node.occurrence = part.names[steps - 1].occurrence;
  node.designator = part.names[steps - 1].designator;
}

std::string uniqueId(const std::string& stem, const std::set<std::string>& taken) {
  std::string id = stem;
  for (int number = 2; taken.count(id) > 0; ++number) id = stem + "-" + std::to_string(number);
  return id;
}

}  // namespace

PartAdder::PartAdder(Scenario& scenario, const std::string& file)
    : scenario_(scenario), folder_(folderOf(file)), saved_(!file.empty()) {
  noteAssets();
  noteNodes();
}

void PartAdder::noteAssets() {
  for (std::size_t i = 0; i < scenario_.assets.size(); ++i) {
    assetIds_.insert(scenario_.assets[i].id);
    assetsOfFiles_.emplace(withoutLinks(assetFile(scenario_.assets[i], folder_)), i);
  }
}

/// Registers the assemblies and ids of the existing bodies. The parent node of a part is the assembly of its last step
/// but one, and so on.
void PartAdder::noteNodes() {
  const Product product = treeOf(scenario_);
  for (const Product::Node& node : product.nodes()) {
    if (node.isAssembly) assemblyIds_.insert(node.id);
  }
  for (const NodeDescription& node : scenario_.nodes) ids_.insert(node.id);
  for (const BodyDescription* body : allBodiesOf(scenario_)) {
    ids_.insert(body->id.text());
    const auto* step = std::get_if<StepGeometry>(&body->geometry);
    if (step == nullptr) continue;
    std::vector<std::string> steps = stepsOf(step->part);
    auto node = product.nodes()[*product.find(body->id.text())].parent;
    while (steps.size() > 1 && node) {
      steps.pop_back();
      assemblies_.emplace(std::pair(step->asset, pathOf(steps)), product.nodes()[*node].id);
      node = product.nodes()[*node].parent;
    }
  }
}

std::string PartAdder::freeAssemblyId(const std::string& id) const {
  std::string free = id;
  for (int number = 2; ids_.count(free) + assemblyIds_.count(free) > 0; ++number) {
    free = id + "#" + std::to_string(number);
  }
  return free;
}

/// The id of the assembly of the first steps of a part's path. Adds a node for it where the path does not imply its
/// place or its name.
std::string PartAdder::assemblyOf(const PartFile& part, const std::string& asset, std::size_t steps) {
  if (steps == 0) return {};
  std::vector<std::string> path = stepsOf(part.part);
  path.resize(steps);
  const auto key = std::pair(asset, pathOf(path));
  if (const auto known = assemblies_.find(key); known != assemblies_.end()) return known->second;
  const std::string above = assemblyOf(part, asset, steps - 1);
  NodeDescription node{freeAssemblyId(joinedPath(above, path.back()))};
  const std::string name = nameInFile(part, path);
  const bool byPath = node.id == key.second;
  if (!byPath) node.in = above;
  if (!byPath || name != path.back()) node.name = name;
  noteUse(part, path.size(), node);
  assemblies_.emplace(key, node.id);
  assemblyIds_.insert(node.id);
  addNode(node);
  return node.id;
}

/// Adds a node for the body's place and its name in the file where its path does not imply them.
void PartAdder::notePlace(const PartFile& part, const BodyDescription& body) {
  const auto* step = std::get_if<StepGeometry>(&body.geometry);
  const std::vector<std::string> path = stepsOf(part.part);
  if (step == nullptr || path.empty()) return;
  NodeDescription node{body.id.text()};
  const std::string assembly = assemblyOf(part, step->asset, path.size() - 1);
  if (assembly != pathOf({path.begin(), path.end() - 1})) node.in = assembly;
  const std::string name = nameInFile(part, path);
  if (name != path.back()) node.name = name;
  noteUse(part, path.size(), node);
  addNode(node);
}

/// Adds a node, unless it states only its id.
void PartAdder::addNode(const NodeDescription& node) {
  if (node == NodeDescription{node.id}) return;
  ids_.insert(node.id);
  scenario_.nodes.push_back(node);
}

BodyDescription PartAdder::bodyOf(const PartFile& part) {
  BodyDescription body;
  body.id = BodyId(uniqueId(idOf(part), ids_));
  body.name = part.part.empty() ? body.id.text() : part.part;
  body.mobility = part.role == PartRole::Mobile ? Mobility::Mobile : Mobility::Static;
  body.geometry = geometryOf(part);
  ids_.insert(body.id.text());
  notePlace(part, body);
  return body;
}

void PartAdder::addBody(const PartFile& part) { scenario_.bodies.push_back(bodyOf(part)); }

void PartAdder::addToObject(const PartFile& part) {
  std::vector<BodyDescription>& bodies = scenario_.object.bodies;
  if (hasObject_) {
    bodies.push_back(bodyOf(part));
    return;
  }
  hasObject_ = true;
  for (const BodyDescription& before : bodies) ids_.erase(before.id.text());
  bodies.assign(1, {BodyId(idOf(part)), nameOf(part), Mobility::Static, geometryOf(part)});
  ids_.insert(bodies.front().id.text());
  notePlace(part, bodies.front());
}

Geometry PartAdder::geometryOf(const PartFile& part) {
  if (isCadFile(part.path)) return StepGeometry{assetOf(part), part.part, part.asOne};
  if (isUrdfFile(part.path)) return UrdfGeometry{assetOf(part)};
  return MeshGeometry{assetOf(part), part.groups, part.part};
}

std::string PartAdder::assetOf(const PartFile& part) {
  const std::string file = withoutLinks(part.path);
  const auto [first, end] = assetsOfFiles_.equal_range(file);
  const auto same = std::find_if(first, end, [&](const auto& ofFile) {
    const Asset& asset = scenario_.assets[ofFile.second];
    return asset.unit == part.unit && asset.up == part.up && asset.deflection == part.deflection &&
           asset.closeHoles == part.closeHoles;
  });
  if (same != end) return scenario_.assets[same->second].id;
  const std::string path = fs::absolute(part.path).lexically_normal().generic_string();
  const std::string id = uniqueId(stemOf(part), assetIds_);
  assetIds_.insert(id);
  assetsOfFiles_.emplace(file, scenario_.assets.size());
  scenario_.assets.push_back(
      {id, saved_ ? assetPathFrom(folder_, path) : path, "", part.unit, part.up, part.deflection, part.closeHoles});
  return id;
}

}  // namespace glissade
