#include "app/window/product_name.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace glissade {
namespace {

/// Nothing where the product has several roots, or none.
std::optional<std::string> rootName(const Product& tree) {
  std::optional<std::string> name;
  for (const Product::Node& node : tree.nodes()) {
    if (node.parent) continue;
    if (name || !node.isAssembly) return std::nullopt;
    name = node.name;
  }
  return name && !name->empty() ? name : std::nullopt;
}

/// A scenario made of parts is named as the part that moves.
bool isNameOfAPart(const std::string& name, const AssembledProduct& product) {
  return std::any_of(product.bodies.begin(), product.bodies.end(), [&](const RigidBody& body) {
    return body.name == name || body.shown() == name || lastStepOf(body.name) == name;
  });
}

}  // namespace

std::string nameOfProduct(const LoadedScenario& scenario, const AssembledProduct& product) {
  if (const auto root = rootName(product.tree)) return *root;
  const Scenario& content = scenario.scenario;
  if (!content.name.empty() && !isNameOfAPart(content.name, product)) return content.name;
  const bool isOfParts = scenario.file.empty() && !content.assets.empty();
  const std::string stem =
      std::filesystem::path(isOfParts ? content.assets.front().path : scenario.file).stem().string();
  return stem.empty() ? content.name : stem;
}

}  // namespace glissade
