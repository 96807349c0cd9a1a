#include "engine/study/study_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/engine/study/study_fixture.h"

namespace glissade {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class StudyFolderTest : public testing::Test {
 protected:
  Result<StudyFolder> begin(const std::string& name, const StudyPlan& plan) const {
    return StudyFolder::begin(files.folder / name, plan, "study text");
  }
  StudyPlan plan(bool quick = false) const {
    Warnings warnings;
    return *planStudy(files.file, quick, warnings);
  }
  static RunOutcome solved(double nodes) {
    RunOutcome outcome;
    outcome.result.status = RunStatus::Solved;
    outcome.result.numbers[0] = nodes;
    return outcome;
  }

  test::StudyFiles files;
  Warnings warnings;
};

TEST_F(StudyFolderTest, KeepsRunsOverItsOwnLife) {
  {
    const auto folder = begin("out", plan());
    ASSERT_TRUE(folder.ok()) << toString(folder.error());
    EXPECT_TRUE(folder->save({1, 2}, solved(5)).ok());
  }
  const auto again = begin("out", plan());
  ASSERT_TRUE(again.ok());
  const StudyResults results = again->results(warnings);
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results.at({1, 2}).result, solved(5).result);
  EXPECT_EQ(test::readWhole(again->file("study.json")), "study text");
  EXPECT_TRUE(warnings.empty());
}

TEST_F(StudyFolderTest, RefusesWhatIsNotItsOwn) {
  ASSERT_TRUE(begin("out", plan()).ok());
  EXPECT_EQ(begin("out", plan(true)).error().kind, ErrorKind::Usage);
  StudyPlan newer = plan();
  newer.version += ".1";
  EXPECT_EQ(begin("out", newer).error().kind, ErrorKind::Usage);
  files.folder.write("photos/cat.jpg", "meow");
  EXPECT_THAT(toString(begin("photos", plan()).error().reason), HasSubstr("not a folder of study results"));
  EXPECT_FALSE(fs::exists(files.folder / "photos/runs"));
  EXPECT_EQ(StudyFolder::open(files.folder / "photos").error().kind, ErrorKind::MalformedInput);
}

TEST_F(StudyFolderTest, ABeginningThatWasCutOffIsGoneOnWith) {
  files.folder.write("out/plan.json.saving-abc123", "{");
  ASSERT_TRUE(begin("out", plan()).ok());
  fs::remove_all(files.folder / "out/study.json");
  fs::remove_all(files.folder / "out/runs");
  const auto again = begin("out", plan());
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(test::readWhole(again->file("study.json")), "study text");
  EXPECT_TRUE(again->save({0, 1}, solved(1)).ok());
}

TEST_F(StudyFolderTest, AStudyFileThatIsThereIsNotWrittenOver) {
  EXPECT_EQ(StudyFolder::begin(files.folder.path(), plan(), "other").error().kind, ErrorKind::Usage);
  EXPECT_EQ(test::readWhole(files.file), test::tinyStudy().dump());
}

TEST_F(StudyFolderTest, TornAndForeignRunsCountAsNotRun) {
  const auto folder = begin("out", plan());
  ASSERT_TRUE(folder.ok());
  for (const std::uint64_t seed : {1, 2}) ASSERT_TRUE(folder->save({0, seed}, solved(1)).ok());
  ASSERT_TRUE(folder->save({1, 1}, solved(1)).ok());
  const std::string torn = files.folder / "out/runs/cell1-seed1.json";
  files.folder.write("out/runs/cell1-seed1.json", test::readWhole(torn).substr(0, 40));
  fs::copy_file(files.folder / "out/runs/cell2-seed1.json", files.folder / "out/runs/cell1-seed2.json",
                fs::copy_options::overwrite_existing);
  files.folder.write("out/runs/cell1-seed1.json.saving-x", "rubbish");
  const StudyResults results = folder->results(warnings);
  EXPECT_EQ(results.size(), 1U);
  EXPECT_EQ(warnings.size(), 2U);
}

TEST_F(StudyFolderTest, MergeUnitesAndRefusesWhatDoesNotBelongTogether) {
  const std::string a = files.folder / "a";
  const std::string b = files.folder / "b";
  const std::string out = files.folder / "merged";
  const auto first = begin("a", plan());
  const auto second = begin("b", plan());
  ASSERT_TRUE(first->save({0, 1}, solved(1)).ok());
  ASSERT_TRUE(first->save({0, 2}, solved(2)).ok());
  ASSERT_TRUE(second->save({0, 2}, solved(2)).ok());
  ASSERT_TRUE(second->save({2, 1}, solved(3)).ok());
  const auto merged = mergeStudies({a, b}, out, warnings);
  ASSERT_TRUE(merged.ok()) << toString(merged.error());
  EXPECT_EQ(merged->results(warnings).size(), 3U);
  EXPECT_TRUE(fs::exists(merged->file("summary.json")));

  ASSERT_TRUE(second->save({0, 2}, solved(99)).ok());
  EXPECT_THAT(toString(mergeStudies({a, b}, files.folder / "m2", warnings).error().reason),
              HasSubstr("another result"));
  RunOutcome slow;
  slow.result.status = RunStatus::Time;
  ASSERT_TRUE(second->save({0, 2}, slow).ok());
  EXPECT_TRUE(mergeStudies({a, b}, files.folder / "m3", warnings).ok());

  ASSERT_TRUE(begin("quick", plan(true)).ok());
  const auto mixed = mergeStudies({a, files.folder / "quick"}, files.folder / "m4", warnings);
  EXPECT_EQ(mixed.error().kind, ErrorKind::MalformedInput);
  EXPECT_FALSE(fs::exists(files.folder / "m4"));
  EXPECT_FALSE(mergeStudies({a, files.folder / "nothing"}, out, warnings).ok());
}

TEST_F(StudyFolderTest, APlanThatWasTamperedWithIsRefused) {
  ASSERT_TRUE(begin("out", plan()).ok());
  for (const char* patch : {R"([{"op": "replace", "path": "/cells", "value": []}])",
                            R"([{"op": "replace", "path": "/cells/0/seeds", "value": []}])",
                            R"([{"op": "remove", "path": "/cells/0/parameters/contact_gap"}])",
                            R"([{"op": "replace", "path": "/version", "value": 9}])"}) {
    const auto json = nlohmann::json::parse(writePlan(plan())).patch(nlohmann::json::parse(patch));
    files.folder.write("out/plan.json", json.dump());
    EXPECT_FALSE(StudyFolder::open(files.folder / "out").ok()) << patch;
  }
}

}  // namespace
}  // namespace glissade
