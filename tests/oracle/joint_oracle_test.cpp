// The checker of plans by joints refuses the plans that an assembler would refuse.
#include "tests/oracle/joint_oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/engine/support/directories.h"
#include "tests/oracle/child_run.h"
#include "tests/oracle/order_oracle.h"

namespace glissade::oracle {
namespace {

constexpr double kPitch = 0.001;

/// A motion that turns about z by the pitch, then goes straight on.
std::vector<Placement> turnedOut(double turns, double pitch = kPitch, int perTurn = 4) {
  std::vector<Placement> path;
  const int count = static_cast<int>(turns * perTurn);
  for (int i = 0; i <= count; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / perTurn;
    path.push_back({{0.0, 0.0, pitch * i / perTurn}, {0.0, 0.0, std::sin(0.5 * angle), std::cos(0.5 * angle)}});
  }
  path.push_back(path.back());
  path.back().position[2] += 0.1;
  return path;
}

std::vector<Placement> straight() { return {{}, {{0.0, 0.0, 0.1}, {0.0, 0.0, 0.0, 1.0}}}; }

StatedJoint screw() { return {"screw", "screw", {"base"}, {"cover"}, {}, {0.0, 0.0, 1.0}, kPitch, 0.004}; }

StatedLine planOf(std::vector<StatedStep> steps) {
  return {0, {"base", "cover", "screw"}, {"base"}, std::move(steps), {}, {}};
}

bool isReported(const std::vector<std::string>& violations, const std::string& what) {
  for (const std::string& each : violations) {
    if (each.find(what) != std::string::npos) return true;
  }
  return false;
}

TEST(JointOracle, AcceptsAScrewThatTurnsOutBeforeWhatItClamps) {
  EXPECT_EQ(violationsOf(planOf({{{"screw"}, turnedOut(4)}, {{"cover"}, straight()}}), {screw()}),
            std::vector<std::string>());
  StatedJoint leftHanded = screw();
  leftHanded.pitch = -kPitch;
  EXPECT_EQ(violationsOf(planOf({{{"screw"}, turnedOut(4)}, {{"cover"}, straight()}}), {leftHanded}).size(), 1U);
}

TEST(JointOracle, RefusesAThreadThatIsPulled) {
  const auto violations = violationsOf(planOf({{{"screw"}, straight()}, {{"cover"}, straight()}}), {screw()});
  ASSERT_EQ(violations.size(), 1U);
  EXPECT_TRUE(isReported(violations, "step 1: the thread of screw 'screw' opens, and it advances by")) << violations[0];
}

TEST(JointOracle, RefusesWhatIsPulledOffWhatItsOwnAllowancesCallAThread) {
  StatedStep pulled{{"cover"}, straight()};
  pulled.threads = {"base"};
  EXPECT_TRUE(isReported(violationsOf(planOf({pulled, {{"screw"}, straight()}}), {}),
                         "step 1: 'cover' is pulled off the thread of 'base'"));
  pulled.path = turnedOut(4);
  EXPECT_EQ(violationsOf(planOf({pulled, {{"screw"}, straight()}}), {}), std::vector<std::string>());
}

TEST(JointOracle, RefusesTurnsThatAreTooFewOrTooCoarse) {
  EXPECT_TRUE(isReported(violationsOf(planOf({{{"screw"}, turnedOut(3)}, {{"cover"}, straight()}}), {screw()}),
                         "before it is free"));
  EXPECT_TRUE(
      isReported(violationsOf(planOf({{{"screw"}, turnedOut(4, 1.1 * kPitch)}, {{"cover"}, straight()}}), {screw()}),
                 "it advances by"));
  EXPECT_TRUE(
      isReported(violationsOf(planOf({{{"screw"}, turnedOut(4, kPitch, 2)}, {{"cover"}, straight()}}), {screw()}),
                 "half a circle"));
}

TEST(JointOracle, RefusesWhatIsClampedBeforeItsScrew) {
  const auto violations = violationsOf(planOf({{{"cover"}, straight()}, {{"screw"}, turnedOut(4)}}), {screw()});
  EXPECT_TRUE(isReported(violations, "step 1: what screw 'screw' clamps leaves before it"));
  EXPECT_TRUE(isReported(violations, "step 2: screw 'screw' leaves after 'cover', which it clamps"));
}

TEST(JointOracle, CountsEveryBodyOnce) {
  EXPECT_TRUE(isReported(violationsOf(planOf({{{"screw"}, turnedOut(4)}}), {screw()}), "'cover' neither leaves"));
  StatedLine twice = planOf({{{"screw"}, turnedOut(4)}, {{"cover"}, straight()}, {{"cover"}, straight()}});
  EXPECT_TRUE(isReported(violationsOf(twice, {screw()}), "step 3: 'cover' has left before"));
  StatedLine stuck = planOf({{{"screw"}, turnedOut(4)}, {{"cover"}, straight()}});
  stuck.stuck = {"cover"};
  EXPECT_TRUE(isReported(violationsOf(stuck, {screw()}), "'cover' is to remain"));
}

TEST(JointOracle, OnlyFlexibleBodiesLeaveWithoutAProof) {
  StatedLine plan = planOf({{{"screw"}, turnedOut(4)}, {{"cover"}, straight(), false}});
  EXPECT_TRUE(isReported(violationsOf(plan, {screw()}), "'cover' leaves without a proof"));
  StatedJoint belt = screw();
  belt.kind = "flexible";
  belt.body = "cover";
  belt.clamped.clear();
  EXPECT_TRUE(violationsOf(plan, {screw(), belt}).empty());
}

TEST(JointOracle, JudgesTheLinesOfGroups) {
  StatedLine plan = planOf({{{"cover", "screw"}, straight()}});
  plan.lines = {{1, {"cover", "screw"}, {"cover"}, {{{"screw"}, straight()}}, {}, {}}};
  StatedJoint inCover = screw();
  inCover.others = {"cover"};
  inCover.clamped = {};
  EXPECT_TRUE(isReported(violationsOf(plan, {inCover}), "in the line of step 1: step 1: the thread of screw"));
  plan.lines[0].steps[0].path = turnedOut(4);
  EXPECT_TRUE(violationsOf(plan, {inCover}).empty());
  plan.lines[0].bodies = {"screw"};
  EXPECT_TRUE(isReported(violationsOf(plan, {inCover}), "a line has other bodies than its step"));
}

/// Plans a product with the program, and judges the plan by the joints that the program finds.
std::vector<std::string> violationsOfProduct(const std::string& product, const std::string& name, bool suggested) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("joint_oracle_" + name);
  std::filesystem::create_directories(folder);
  const std::string plan = folder / "plan.json";
  const std::string joints = folder / "joints.json";
  const std::string fits = folder / "fits.json";
  const std::string program = test::programDirectory() + "/glissade-cli";
  const std::string use = suggested ? "suggested" : "recognised";
  const ChildEnd planned = runChild({program, "sequence", product, "--out", plan, "--joints", use}, {200.0, 4096});
  EXPECT_TRUE(planned.exitCode == 0 || planned.exitCode == 1 || planned.exitCode == 6) << planned.errors;
  const ChildEnd found = runChild({program, "joints", product, "--json"}, {60.0, 4096});
  EXPECT_EQ(found.exitCode, 0) << found.errors;
  std::ofstream(joints) << found.output;
  const auto stated = readStatedJoints(joints, suggested);
  EXPECT_FALSE(stated.empty()) << product << " has screws";
  const ChildEnd touching = runChild({program, "fits", product, "--json"}, {60.0, 4096});
  std::ofstream(fits) << touching.output;
  auto violations = violationsOf(readStatedPlan(plan), stated);
  const auto ofOrder = orderViolationsOf(readStatedPlan(plan), stated, readStatedContacts(fits));
  violations.insert(violations.end(), ofOrder.begin(), ofOrder.end());
  std::filesystem::remove_all(folder);
  return violations;
}

TEST(JointOracle, AcceptsThePlanOfAProductWithScrewsAndNuts) {
  EXPECT_EQ(violationsOfProduct(test::stepFileDirectory() + "/tapped-nut.step", "nut", false),
            std::vector<std::string>());
  const std::string product = test::stepFileDirectory() + "/fits.step";
  EXPECT_EQ(violationsOfProduct(product, "fits", false), std::vector<std::string>());
  EXPECT_EQ(violationsOfProduct(product, "suggested", true), std::vector<std::string>());
}

/// A plan that pulls threads is valid only if it states that a person uses no joints.
TEST(JointOracle, TheJudgeRefusesAPullThatNobodyAskedFor) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "joint_oracle_pulled";
  std::filesystem::create_directories(folder);
  const std::string product = test::stepFileDirectory() + "/fits.step";
  const std::string program = test::programDirectory() + "/glissade-cli";
  const std::string file = folder / "plan.json";
  runChild({program, "sequence", product, "--out", file, "--joints", "off"}, {200.0, 4096});
  const ChildEnd asked = runChild({program, "check", product, file}, {100.0, 4096});
  EXPECT_NE(asked.output.find("note: "), std::string::npos) << asked.output;
  EXPECT_NE(asked.output.find("without being unscrewed"), std::string::npos);
  EXPECT_EQ(asked.output.find("is invalid"), std::string::npos) << asked.output;

  nlohmann::json plan = nlohmann::json::parse(std::ifstream(file));
  plan.erase("checksum");
  plan["sequence"].erase("joint_use");
  std::ofstream(file) << plan;
  const ChildEnd refused = runChild({program, "check", product, file}, {100.0, 4096});
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_NE(refused.output.find("is invalid: '"), std::string::npos) << refused.output;
  EXPECT_NE(refused.output.find("without being unscrewed"), std::string::npos) << refused.output;

  for (auto& step : plan["steps"]) {
    for (auto& motion : step["motions"]) {
      for (auto& allowance : motion["allowances"]) allowance["kind"] = "cylindrical";
    }
  }
  std::ofstream(file) << plan;
  EXPECT_EQ(runChild({program, "check", product, file}, {100.0, 4096}).exitCode, refused.exitCode)
      << "whatever the plan calls the pairs";
  std::filesystem::remove_all(folder);
}

/// The sample's parts are meshes without stated faces. Allowances hold only for the assembled angle, unless a person
/// marks the pairs as threads. So threads may be pulled, and all other rules hold.
TEST(JointOracle, AcceptsTheOrderOfASampleOfMeshes) {
  const std::string product = test::sourceDirectory() + "/samples/bolted-brackets/scenario.json";
  for (const std::string& each : violationsOfProduct(product, "brackets", false)) {
    EXPECT_NE(each.find("the thread of"), std::string::npos) << each;
  }
}

}  // namespace
}  // namespace glissade::oracle
