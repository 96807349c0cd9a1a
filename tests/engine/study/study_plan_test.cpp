#include "engine/study/study_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/study/study_fixture.h"

namespace glissade {
namespace {

using testing::HasSubstr;

StudyPlan planOf(const test::StudyFiles& files) {
  Warnings warnings;
  auto plan = planStudy(files.file, false, warnings);
  EXPECT_TRUE(plan.ok()) << toString(plan.error());
  return *plan;
}

TEST(StudyPlan, ResolvesParametersAndReadsBack) {
  const test::StudyFiles files;
  const StudyPlan plan = planOf(files);
  const StudyCell& cell = plan.study.cells[1];
  EXPECT_EQ(cell.parameters.size(), kParameterCount);
  EXPECT_EQ(cell.parameters.at(ParameterId::ExtensionStep), 0.01);
  EXPECT_EQ(cell.parameters.at(ParameterId::StepsPerSecond), 40.0);
  EXPECT_EQ(cell.scenarioSha256.size(), 64U);
  const std::string text = writePlan(plan);
  const auto back = readPlan(text, "plan.json");
  ASSERT_TRUE(back.ok()) << toString(back.error());
  EXPECT_EQ(writePlan(*back), text);
}

TEST(StudyPlan, OlderPlansStayReadable) {
  const test::StudyFiles files;
  auto older = nlohmann::json::parse(writePlan(planOf(files)));
  older["cells"][0]["parameters"].erase("tuning");
  const auto back = readPlan(older.dump(), "plan.json");
  ASSERT_TRUE(back.ok()) << toString(back.error());
  EXPECT_EQ(back->study.cells[0].parameters.at(ParameterId::Tuning), 0.0);
  older["cells"][0]["parameters"].erase("contact_distance");
  const auto torn = readPlan(older.dump(), "plan.json");
  ASSERT_FALSE(torn.ok());
  EXPECT_THAT(toString(torn.error().reason), HasSubstr("contact_distance"));
}

TEST(StudyPlan, ParametersAreCheckedAgainstTheScenario) {
  auto study = test::tinyStudy();
  study["rows"][1]["grid"]["extension_step"] = {0.02, 50};
  const test::StudyFiles files(study);
  Warnings warnings;
  const auto plan = planStudy(files.file, false, warnings);
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.error().kind, ErrorKind::MalformedInput);
  EXPECT_EQ(plan.error().file, files.file);
  EXPECT_THAT(toString(plan.error().location), HasSubstr("/rows/1"));
  EXPECT_THAT(toString(plan.error().reason), HasSubstr("50"));
}

TEST(StudyPlan, AScenarioThatIsNotThereIsNamed) {
  auto study = test::tinyStudy();
  study["scenarios"] = {"gone.json"};
  const test::StudyFiles files(study);
  Warnings warnings;
  const auto plan = planStudy(files.file, false, warnings);
  ASSERT_FALSE(plan.ok());
  EXPECT_THAT(plan.error().file, HasSubstr("gone.json"));
}

TEST(StudyPlan, ShardsShareTheRunsOut) {
  const test::StudyFiles files;
  const StudyPlan plan = planOf(files);
  const auto all = runsOf(plan.study, {});
  ASSERT_EQ(all.size(), 6U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(all[i].seed, 1U) << "the first seed of every cell comes first";
  std::vector<StudyRun> united;
  for (std::size_t i = 1; i <= 4; ++i) {
    const auto part = runsOf(plan.study, {i, 4});
    EXPECT_LE(part.size(), 2U);
    united.insert(united.end(), part.begin(), part.end());
  }
  std::sort(united.begin(), united.end());
  ASSERT_EQ(united.size(), 6U);
  for (std::size_t i = 1; i < united.size(); ++i) EXPECT_TRUE(united[i - 1] < united[i]);
}

TEST(StudyPlan, ArgumentsNameEverythingThatTheStudySets) {
  const test::StudyFiles files;
  const StudyPlan plan = planOf(files);
  EXPECT_THAT(planArguments(plan.study.cells[2], 5, "s.json"),
              testing::ElementsAre("plan", "s.json", "--strategy", "birrt", "--operator", "none", "--seed", "5",
                                   "--extension-step", "0.02", "--max-steps", "2000", "--time-limit", "60", "--json"));
}

TEST(StudyPlan, ASequenceIsARunOfAnotherCommand) {
  nlohmann::json study = test::tinyStudy();
  study["strategies"] = {"sequence-best-first"};
  study["rows"].erase(1);
  const test::StudyFiles files(study);
  const StudyPlan plan = planOf(files);
  ASSERT_EQ(plan.study.cells.size(), 1U);
  EXPECT_TRUE(isSequence(plan.study.cells[0]));
  EXPECT_THAT(planArguments(plan.study.cells[0], 5, "s.json"),
              testing::ElementsAre("sequence", "s.json", "--strategy", "best-first", "--seed", "5", "--time-limit",
                                   "60", "--json"));
}

}  // namespace
}  // namespace glissade
