#include "engine/files/plan_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/engine/files/some_plan.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using Json = nlohmann::ordered_json;

Json document() { return planJson(test::somePlan(), "product.step"); }

TEST(PlanFile, ReadsWhatItWrites) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "plan.json";
  ASSERT_TRUE(savePlan(test::somePlan(), "product.step", file).ok());
  EXPECT_TRUE(isPlanFile(file));
  const auto plan = readPlan(file);
  ASSERT_TRUE(plan.ok()) << toString(plan.error());
  EXPECT_EQ(planJson(*plan, "product.step"), document());
  EXPECT_EQ(plan->steps[0].only().path[1].q, test::somePlan().steps[0].only().path[1].q);
  EXPECT_EQ(plan->parts(), 6U);
  EXPECT_EQ(plan->removed(), 4U);
  EXPECT_EQ(plan->steps[0].bodies(), (std::vector<BodyId>{"nut", "washer"}));
  EXPECT_EQ(plan->steps[1].bodies(), (std::vector<BodyId>{"wheel", "bearing"}));
  EXPECT_EQ(plan->steps[0].only().fastener, FastenerKind::Nut);
  EXPECT_TRUE(plan->steps[1].only().allowances[0].yields);
  EXPECT_EQ(plan->demands, test::somePlan().demands);
  ASSERT_EQ(plan->steps[1].violates.size(), 2U);
  EXPECT_EQ(plan->steps[1].violates[0].bodies, std::vector<BodyId>{"bolt"});
}

TEST(PlanFile, RefusesAChangedOne) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "plan.json";
  ASSERT_TRUE(savePlan(test::somePlan(), "product.step", file).ok());
  Json changed = Json::parse(test::readWhole(file));
  changed["seed"] = 8;
  const auto plan = parsePlan(changed.dump(), file);
  ASSERT_FALSE(plan.ok());
  EXPECT_NE(toString(plan.error()).find("checksum"), std::string::npos) << toString(plan.error());
  changed.erase("checksum");
  EXPECT_TRUE(parsePlan(changed.dump(), file).ok());
}

TEST(PlanFile, ErrorsNameThePlace) {
  struct Row {
    const char* patch;
    const char* place;
  };
  for (const Row& row : std::initializer_list<Row>{
           {R"([{"op": "replace", "path": "/format", "value": "glissade-path"}])", "/format"},
           {R"([{"op": "replace", "path": "/version", "value": 3}])", "/version"},
           {R"([{"op": "replace", "path": "/end", "value": "done"}])", "/end"},
           {R"([{"op": "add", "path": "/bodies/1", "value": "plate"}])", "/bodies/1"},
           {R"([{"op": "replace", "path": "/staying/0", "value": "base"}])", "/staying/0"},
           {R"([{"op": "replace", "path": "/steps/0/motions/0/bodies/0", "value": "plate"}])",
            "/steps/0/motions/0/bodies/0"},
           {R"([{"op": "add", "path": "/steps/0/motions/0/bodies/1", "value": "nut"}])", "/steps/0/motions/0/bodies/1"},
           {R"([{"op": "replace", "path": "/steps/0/motions/0/bodies", "value": []}])", "/steps/0/motions/0/bodies"},
           {R"([{"op": "copy", "path": "/steps/1", "from": "/steps/0"}])", "/steps/1/motions/0/bodies/0"},
           {R"([{"op": "replace", "path": "/steps/1/after/0", "value": 2}])", "/steps/1/after/0"},
           {R"([{"op": "replace", "path": "/steps/1/after/0", "value": 0}])", "/steps/1/after/0"},
           {R"([{"op": "replace", "path": "/steps/1/violates/0/rule", "value": "taste"}])", "/steps/1/violates/0/rule"},
           {R"([{"op": "replace", "path": "/sequence/places/0/place", "value": 0}])", "/sequence/places/0/place"},
           {R"([{"op": "remove", "path": "/sequence/motions/0/path/0"}])", "/sequence/motions/0/path"},
           {R"([{"op": "replace", "path": "/sequence/forbidden/0/direction", "value": [0, 0, 0]}])",
            "/sequence/forbidden/0/direction"},
           {R"([{"op": "replace", "path": "/steps/0/motions/0/fastener", "value": "rivet"}])",
            "/steps/0/motions/0/fastener"},
           {R"([{"op": "replace", "path": "/steps/1/motions/0/falling/0", "value": "nobody"}])",
            "/steps/1/motions/0/falling/0"},
           {R"([{"op": "replace", "path": "/steps/0/motions/0/certificate/status", "value": "undecided"}])",
            "/steps/0/motions/0/certificate/status"},
           {R"([{"op": "replace", "path": "/steps/0/motions/0/certificate/after_steps", "value": 1}])",
            "/steps/0/motions/0/certificate/after_steps"},
           {R"([{"op": "replace", "path": "/steps/0/motions/0/allowances/0/allowance_m", "value": -1}])",
            "/steps/0/motions/0/allowances/0/allowance_m"},
           {R"([{"op": "replace", "path": "/steps/0/motions/0/allowances/0/kind", "value": "glue"}])",
            "/steps/0/motions/0/allowances/0/kind"},
           {R"([{"op": "add", "path": "/steps/0/motions/0/allowances/0/pitch_m", "value": 0}])",
            "/steps/0/motions/0/allowances/0/pitch_m"},
           {R"([{"op": "add", "path": "/steps/0/motions/0/allowances/0/pitch_m", "value": "1.5"}])",
            "/steps/0/motions/0/allowances/0/pitch_m"},
           {R"([{"op": "add", "path": "/steps/0/motions/0/allowances/0/turns", "value": 2}])",
            "/steps/0/motions/0/allowances/0/turns"},
           {R"([{"op": "add", "path": "/steps/0/motions/0/allowances/0/pitch_m", "value": 0.001},
                {"op": "add", "path": "/steps/0/motions/0/allowances/0/turns", "value": -2}])",
            "/steps/0/motions/0/allowances/0/turns"},
           {R"([{"op": "replace", "path": "/steps/0/motions/0/path", "value": []}])", "/steps/0/motions/0/path"},
           {R"([{"op": "replace", "path": "/steps/0/motions/0/path/1/orientation", "value": [0, 0, 0, 2]}])",
            "/steps/0/motions/0/path/1/orientation"},
           {R"([{"op": "replace", "path": "/steps/0/motions/0/path/1/author", "value": "nobody"}])",
            "/steps/0/motions/0/path/1/author"},
           {R"([{"op": "replace", "path": "/stuck/0/part", "value": "nut"}])", "/stuck/0/part"},
           {R"([{"op": "replace", "path": "/refusals/0/effort", "value": 64}])", "/refusals/0/effort"},
           {R"([{"op": "add", "path": "/more", "value": 1}])", "/more"}}) {
    const auto plan = parsePlan(document().patch(nlohmann::json::parse(row.patch)).dump(), "plan.json");
    ASSERT_FALSE(plan.ok()) << row.patch;
    EXPECT_EQ(plan.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(toString(plan.error().location), row.place) << toString(plan.error());
  }
}

/// In version 1, the keys of the motion were keys of the step.
TEST(PlanFile, AStepOfVersion1IsReadAsOneMotion) {
  Json old = document();
  old["version"] = 1;
  for (Json& step : old["steps"]) {
    step.update(Json(step["motions"][0]));
    step.erase("motions");
  }
  old["lines"] = {{{"step", 2},
                   {"bodies", {"wheel", "bearing"}},
                   {"staying", {"wheel"}},
                   {"steps", {old["steps"][0]}},
                   {"stuck", Json::array()}}};
  old["lines"][0]["steps"][0]["bodies"] = {"bearing"};
  for (const char* key : {"tool", "allowances", "after"}) old["lines"][0]["steps"][0].erase(key);
  old["lines"][0]["steps"][0]["allowances"] = Json::array();
  old["lines"][0]["steps"][0]["certificate"]["nearest"] = "wheel";
  old["waiting"][0]["wave"] = 2;
  old["waiting"][0]["after"] = {1};
  const auto plan = parsePlan(old.dump(), "plan.json");
  ASSERT_TRUE(plan.ok()) << toString(plan.error());
  ASSERT_EQ(plan->steps.size(), 2U);
  EXPECT_EQ(plan->steps[0].bodies(), std::vector<BodyId>{"nut"});
  EXPECT_EQ(plan->steps[0].wave, 1U);
  EXPECT_EQ(plan->steps[1].after, std::vector<std::size_t>{1});
  EXPECT_EQ(plan->steps[1].violates.size(), 2U);
  EXPECT_EQ(plan->waiting[0].body, "rod");
  EXPECT_EQ(plan->lines[0].steps[0].bodies(), std::vector<BodyId>{"bearing"});
  old["steps"][0]["motions"] = Json::array();
  EXPECT_FALSE(parsePlan(old.dump(), "plan.json").ok()) << "a key of version 2";
}

TEST(PlanFile, AStepHasAMotion) {
  Json plan = document();
  plan["steps"][0]["motions"] = Json::array();
  const auto read = parsePlan(plan.dump(), "plan.json");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(toString(read.error().location), "/steps/0/motions");
}

TEST(PlanFile, AStepThatDoesNotSayIsAfterAllEarlierOnes) {
  Json plan = document();
  plan["steps"][1].erase("after");
  const auto read = parsePlan(plan.dump(), "plan.json");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->steps[1].after, std::vector<std::size_t>{1});
}

TEST(PlanFile, IsAboutOneProduct) {
  const auto productOf = [](const std::vector<BodyId>& ids) {
    AssembledProduct product;
    for (const BodyId& id : ids) product.bodies.emplace_back().id = id;
    return product;
  };
  const AssembledProduct product = productOf({"plate", "nut", "bolt", "rod", "wheel", "bearing", "washer"});
  EXPECT_TRUE(checkSameBodies(test::somePlan(), product, "plan.json").ok());
  const auto other = checkSameBodies(test::somePlan(), productOf({"plate", "bolt", "rod"}), "plan.json");
  ASSERT_FALSE(other.ok());
  EXPECT_NE(toString(other.error().reason).find("'nut'"), std::string::npos);
}

}  // namespace
}  // namespace glissade
