#include "engine/files/product_name.h"

#include <gtest/gtest.h>

#include "engine/files/scenario_product.h"

namespace glissade {
namespace {

/// A scenario of these files; the first one moves.
Scenario scenarioOf(const std::vector<std::string>& paths) {
  Scenario scenario;
  scenario.object.first() = {BodyId(paths[0]), paths[0], Mobility::Static, BoxGeometry{}};
  for (std::size_t i = 1; i < paths.size(); ++i) {
    scenario.bodies.push_back({BodyId(paths[i]), paths[i], Mobility::Static, BoxGeometry{}});
  }
  return scenario;
}

Asset assetAt(const std::string& path) {
  Asset asset;
  asset.path = path;
  return asset;
}

TEST(ProductName, IsTheRootOfTheProduct) {
  Scenario scenario = scenarioOf({"pump/rotor", "pump/housing"});
  scenario.name = "something";
  EXPECT_EQ(nameOfProduct(scenario, ""), "pump");
  LoadedScenario loaded;
  loaded.product = treeOf(scenario);
  loaded.scenario = scenario;
  EXPECT_EQ(nameOfProduct(loaded), "pump");
}

/// Earlier versions named scenarios after the part that moves.
TEST(ProductName, IsThatOfNoPart) {
  Scenario scenario = scenarioOf({"rod-assembly/nut", "plate"});
  for (const char* name : {"rod-assembly/nut", "nut", "plate", ""}) {
    scenario.name = name;
    EXPECT_EQ(nameOfProduct(scenario, "/somewhere/as1.json"), "as1") << name;
  }
  scenario.name = "Bracket with a rod";
  EXPECT_EQ(nameOfProduct(scenario, "/somewhere/as1.json"), "Bracket with a rod");
}

TEST(ProductName, IsThatOfTheFileOfItsPartsWhereNothingIsSaved) {
  Scenario scenario = scenarioOf({"nut", "plate"});
  scenario.name = "nut";
  scenario.assets = {assetAt("/somewhere/as1-oc-214.stp")};
  EXPECT_EQ(nameOfProduct(scenario, ""), "as1-oc-214");
}

TEST(ProductName, IsThatOfTheFolderWhereEachPartHasAFile) {
  Scenario scenario = scenarioOf({"nut", "plate"});
  scenario.assets = {assetAt("/somewhere/bracket/nut.obj"), assetAt("/somewhere/bracket/plate.obj")};
  EXPECT_EQ(nameOfProduct(scenario, ""), "bracket");
}

}  // namespace
}  // namespace glissade
