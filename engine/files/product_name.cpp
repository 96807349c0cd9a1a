#include "engine/files/product_name.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_product.h"
#include "engine/model/body_path.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// The name of the product's root; nothing where it has several roots, or none.
std::optional<std::string> rootName(const Product& tree) {
  std::optional<std::string> name;
  for (const Product::Node& node : tree.nodes()) {
    if (node.parent) continue;
    if (name || !node.isAssembly) return std::nullopt;
    name = node.names.product;
  }
  return name && !name->empty() ? name : std::nullopt;
}

/// True if the name is that of a part. Earlier versions named scenarios after the part that moves.
bool isNameOfAPart(const std::string& name, const Scenario& scenario) {
  const auto bodies = allBodiesOf(scenario);
  return std::any_of(bodies.begin(), bodies.end(), [&](const BodyDescription* body) {
    return body->id.text() == name || body->name == name || lastStepOf(body->name) == name;
  });
}

/// The name of the file that has all parts, else of the folder of the first file.
std::string nameOfFiles(const std::vector<Asset>& assets) {
  if (assets.empty()) return {};
  const fs::path first = assets.front().path;
  return (assets.size() == 1 ? first.stem() : first.parent_path().filename()).string();
}

std::string nameIn(const Product& tree, const Scenario& scenario, const std::string& file) {
  if (const auto root = rootName(tree)) return *root;
  if (!scenario.name.empty() && !isNameOfAPart(scenario.name, scenario)) return scenario.name;
  return file.empty() ? nameOfFiles(scenario.assets) : fs::path(file).stem().string();
}

}  // namespace

std::string nameOfProduct(const Scenario& scenario, const std::string& file) {
  return nameIn(treeOf(scenario), scenario, file);
}

std::string nameOfProduct(const LoadedScenario& scenario) {
  return nameIn(scenario.product, scenario.scenario, scenario.file);
}

}  // namespace glissade
