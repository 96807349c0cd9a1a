#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "engine/base/file.h"
#include "engine/files/part_files.h"
#include "engine/files/product_file.h"
#include "engine/files/scenario_io.h"
#include "tests/engine/support/step_files.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using test::stepFile;
using test::TemporaryFolder;
using testing::HasSubstr;

/// A product whose parts are separate files.
class StepAsset : public testing::Test {
 protected:
  StepAsset() {
    for (const char* name :
         {"split.step", "split-plate.stp", "split-pin.stp", "split-housing.stp", "split-rotor.stp"}) {
      fs::copy_file(stepFile(name), folder / name);
    }
  }
  std::vector<PartFile> parts() const {
    PartFile pin = usualPart(folder / "split.step:pin");
    pin.role = PartRole::Moves;
    return {pin, usualPart(folder / "split.step")};
  }
  Scenario scenario(GeometryCache& read) const {
    auto made = scenarioOfParts(parts(), &read);
    EXPECT_TRUE(made) << toString(made.error());
    return made ? std::move(*made) : Scenario();
  }
  static LoadedScenario load(const Scenario& scenario, const GeometryCache& read = {}) {
    auto loaded = loadGeometry(scenario, ".", "", read);
    EXPECT_TRUE(loaded) << toString(loaded.error());
    return loaded ? std::move(*loaded) : LoadedScenario();
  }

  TemporaryFolder folder;
};

TEST_F(StepAsset, AChangeOfAFileThatItNamesIsTold) {
  GeometryCache read;
  const Scenario made = scenario(read);
  ASSERT_EQ(made.assets.size(), 1U);
  EXPECT_NE(made.assets[0].sha256, sha256(test::stepText("split.step")));
  EXPECT_TRUE(load(made).warnings.empty());
  folder.write("split-rotor.stp", test::stepText("split-rotor.stp") + "\n");
  const LoadedScenario changed = load(made);
  ASSERT_EQ(changed.warnings.size(), 1U);
  EXPECT_THAT(toString(changed.warnings[0].reason), HasSubstr("has changed since the scenario was saved"));
  EXPECT_NE(changed.scenario.assets[0].sha256, made.assets[0].sha256);
}

TEST_F(StepAsset, WhatIsMissingIsToldWheneverItIsLoadedAndOnce) {
  fs::remove(folder / "split-rotor.stp");
  GeometryCache read;
  const Scenario made = scenario(read);
  EXPECT_EQ(made.bodies.size(), 3U);
  for (const LoadedScenario& loaded : {load(made), load(made, read)}) {
    ASSERT_EQ(loaded.warnings.size(), 1U);
    EXPECT_THAT(toString(loaded.warnings[0].reason), HasSubstr("'split-rotor.stp' is not there"));
  }
  const auto product = readProduct(folder / "split.step");
  ASSERT_TRUE(product) << toString(product.error());
  EXPECT_EQ(product->product.bodies.size(), 4U);
  EXPECT_EQ(product->warnings.size(), 1U);
}

TEST_F(StepAsset, PartsThatAScenarioNeitherNamesNorLeavesOutAreMissingShapes) {
  GeometryCache read;
  Scenario made = scenario(read);
  EXPECT_TRUE(load(made).missing.empty());
  const BodyDescription body = made.bodies.back();
  made.bodies.pop_back();
  const std::string part = std::get<StepGeometry>(body.geometry).part;
  for (const LoadedScenario& loaded : {load(made), load(made, read)}) {
    ASSERT_EQ(loaded.missing.size(), 1U);
    EXPECT_EQ(nameOf(loaded.missing.front()), "'" + part + "'");
  }
  made.leftOut.push_back(body);
  EXPECT_TRUE(load(made).missing.empty()) << "a person has said so";
}

TEST_F(StepAsset, AProductFileTakesADeflectionAndAScenarioDoesNot) {
  const auto fine = readProduct(folder / "split.step", {}, 1e-5);
  ASSERT_TRUE(fine) << toString(fine.error());
  EXPECT_THAT(fine->product.deflections, testing::Each(testing::Le(1e-5)));
  EXPECT_THAT(fine->product.deflections, testing::Contains(testing::Gt(1e-6)));
  const std::string file = folder.write("scenario.json", "{}");
  const auto refused = readProduct(file, {}, 1e-5);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::Usage);
  EXPECT_THAT(toString(refused.error().reason), HasSubstr("mesh tolerance"));
}

TEST_F(StepAsset, TheHashOfAFileAloneIsThatOfItsBytes) {
  GeometryCache read;
  PartFile pin = usualPart(folder / "split-pin.stp");
  pin.role = PartRole::Moves;
  const auto made = scenarioOfParts({pin}, &read);
  ASSERT_TRUE(made) << toString(made.error());
  EXPECT_EQ(made->assets.at(0).sha256, sha256(test::stepText("split-pin.stp")));
}

}  // namespace
}  // namespace glissade
