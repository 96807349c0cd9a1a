#include "engine/study/study_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/study/broken_studies.h"

namespace glissade {
namespace {

using testing::HasSubstr;

std::vector<std::string> labels(const Study& study) {
  std::vector<std::string> all;
  for (const StudyCell& cell : study.cells) all.push_back(cell.label);
  return all;
}

TEST(StudyReader, SpellsTheCellsOut) {
  const auto study = parseStudy(test::tinyStudy().dump(), "study.json", false);
  ASSERT_TRUE(study.ok()) << toString(study.error());
  EXPECT_THAT(labels(*study),
              testing::ElementsAre("plain", "steps, extension_step=0.01", "steps, extension_step=0.02"));
  const StudyCell& last = study->cells.back();
  EXPECT_EQ(last.row, "steps");
  EXPECT_EQ(last.scenario, "scenario.json");
  EXPECT_EQ(last.strategy, "birrt");
  EXPECT_EQ(last.settings.at(ParameterId::ExtensionStep), 0.02);
  EXPECT_EQ(last.settings.at(ParameterId::MaxSteps), 2000.0);
  EXPECT_EQ(last.memoryLimitMb, 4096U);
  EXPECT_EQ(last.seeds, (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(std::get<double>(study->cells.front().paper.at("time_s")), 12.5);
  EXPECT_EQ(std::get<std::string>(study->cells.front().paper.at("success")), "all");
}

TEST(StudyReader, RowsReplaceAndAdd) {
  auto json = test::tinyStudy();
  json["operators"] = {"expert", "novice"};
  json["parameters"] = {{"alpha", 0.5}, {"contact_samples", 5}};
  json["rows"][0]["operators"] = {"none"};
  json["rows"][0]["parameters"] = {{"alpha", 1}};
  json["rows"][0]["seeds"] = {9, 3};
  const auto study = parseStudy(json.dump(), "study.json", false);
  ASSERT_TRUE(study.ok()) << toString(study.error());
  ASSERT_EQ(study->cells.size(), 5U);
  const StudyCell& first = study->cells[0];
  EXPECT_EQ(first.label, "plain");
  EXPECT_EQ(first.operatorName, "none");
  EXPECT_EQ(first.settings.at(ParameterId::Alpha), 1.0);
  EXPECT_EQ(first.settings.at(ParameterId::ContactSamples), 5.0);
  EXPECT_EQ(first.seeds, (std::vector<std::uint64_t>{3, 9}));
  EXPECT_EQ(study->cells[4].label, "steps, novice, extension_step=0.02");
}

TEST(StudyReader, QuickKeepsRowsAndReplacesSeedsAndLimits) {
  const auto study = parseStudy(test::tinyStudy().dump(), "study.json", true);
  ASSERT_TRUE(study.ok()) << toString(study.error());
  ASSERT_EQ(study->cells.size(), 1U);
  EXPECT_TRUE(study->quick);
  EXPECT_EQ(study->cells[0].label, "plain");
  EXPECT_EQ(study->cells[0].seeds, (std::vector<std::uint64_t>{7}));
  EXPECT_EQ(study->cells[0].settings.at(ParameterId::MaxSteps), 100.0);
  EXPECT_EQ(study->cells[0].settings.at(ParameterId::TimeLimit), 60.0);
  auto without = test::tinyStudy();
  without.erase("quick");
  EXPECT_TRUE(parseStudy(without.dump(), "study.json", false).ok());
  EXPECT_EQ(toString(parseStudy(without.dump(), "study.json", true).error().location), "/quick");
}

TEST(StudyReader, EachFaultIsNamedWithItsPlace) {
  for (const test::BrokenStudy& row : test::brokenStudies()) {
    SCOPED_TRACE(row.patch);
    const auto study = parseStudy(test::broken(row), "broken.json", false);
    ASSERT_FALSE(study.ok());
    EXPECT_EQ(study.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(study.error().file, "broken.json");
    EXPECT_EQ(toString(study.error().location), row.place);
    EXPECT_THAT(toString(study.error().reason), HasSubstr(row.reason));
    EXPECT_FALSE(study.error().advice.empty());
  }
}

TEST(StudyReader, RefusesMoreRunsThanAnybodyCanRunBeforeItSpellsThemOut) {
  auto json = test::tinyStudy();
  std::vector<double> values(1000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
  for (const char* key : {"alpha", "contact_samples", "contact_distance", "contact_radius"}) json["grid"][key] = values;
  const auto study = parseStudy(json.dump(), "study.json", false);
  ASSERT_FALSE(study.ok());
  EXPECT_THAT(toString(study.error().reason), HasSubstr("too many"));
}

TEST(StudyReader, TextThatIsNoStudy) {
  EXPECT_FALSE(parseStudy("", "study.json", false).ok());
  EXPECT_THAT(toString(parseStudy("{\n oops", "study.json", false).error().location), HasSubstr("line 2"));
  const std::string good = test::tinyStudy().dump();
  for (std::size_t length = 1; length < good.size(); length += 7) {
    EXPECT_FALSE(parseStudy(good.substr(0, length), "truncated", false).ok()) << length;
  }
}

}  // namespace
}  // namespace glissade
