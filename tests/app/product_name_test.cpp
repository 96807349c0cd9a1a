#include "app/window/product_name.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

AssembledProduct productNamed(const std::vector<std::string>& paths) {
  std::vector<RigidBody> bodies;
  for (const std::string& path : paths) bodies.push_back(boxBody(path, {1.0, 1.0, 1.0}, Pose::identity()));
  return test::productOf(std::move(bodies));
}

TEST(ProductName, IsTheRootOfTheProduct) {
  LoadedScenario scenario;
  scenario.scenario.name = "something";
  EXPECT_EQ(nameOfProduct(scenario, productNamed({"pump/rotor", "pump/housing"})), "pump");
}

/// A scenario that is made of parts is named as the part that moves.
TEST(ProductName, IsThatOfNoPart) {
  const AssembledProduct product = productNamed({"rod-assembly/nut", "plate"});
  LoadedScenario scenario;
  scenario.file = "/somewhere/as1.json";
  for (const char* name : {"rod-assembly/nut", "nut", "plate", ""}) {
    scenario.scenario.name = name;
    EXPECT_EQ(nameOfProduct(scenario, product), "as1") << name;
  }
  scenario.scenario.name = "Bracket with a rod";
  EXPECT_EQ(nameOfProduct(scenario, product), "Bracket with a rod");
}

TEST(ProductName, IsThatOfTheFileOfItsPartsWhereNothingIsSaved) {
  LoadedScenario scenario;
  scenario.scenario.name = "nut";
  scenario.scenario.assets.push_back({});
  scenario.scenario.assets.back().path = "/somewhere/as1-oc-214.stp";
  EXPECT_EQ(nameOfProduct(scenario, productNamed({"nut", "plate"})), "as1-oc-214");
}

}  // namespace
}  // namespace glissade
