#include "engine/study/study_runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "engine/study/study_tables.h"
#include "tests/engine/study/study_fixture.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// Uses a replacement for glissade-cli that prints its run ($8 is the seed), and ends as the test requires.
class StudyRunnerTest : public testing::Test {
 protected:
  std::string program(const std::string& lines) const {
    const std::string file =
        files.folder.write("cli", "#!/bin/sh\necho $8 >> " + (files.folder / "log") + "\n" + lines +
                                      "\necho '{\"status\": \"solved\", \"planning_s\": 0.1, "
                                      "\"nodes\": '$8'}'\n");
    fs::permissions(file, fs::perms::owner_all);
    return file;
  }
  StudyFolder begin(const std::string& name = "out") const {
    Warnings none;
    return *StudyFolder::begin(files.folder / name, *planStudy(files.file, false, none), "study text");
  }
  Outcome run(
      const StudyFolder& folder, const std::string& cli, std::size_t jobs = 2, const StopToken& stop = {},
      const std::function<void(const StudyProgress&)>& progress = [](const StudyProgress&) {}) {
    return runStudy(folder, {cli, files.file, jobs, {}}, stop, progress, warnings);
  }
  std::size_t started() const {
    const std::string log = test::readWhole(files.folder / "log");
    return static_cast<std::size_t>(std::count(log.begin(), log.end(), '\n'));
  }

  test::StudyFiles files;
  Warnings warnings;
};

TEST_F(StudyRunnerTest, RunsEverythingOnce) {
  const StudyFolder folder = begin();
  StudyProgress last;
  ASSERT_TRUE(run(folder, program(""), 3, {}, [&](const StudyProgress& progress) { last = progress; }).ok());
  EXPECT_EQ(started(), 6U);
  EXPECT_EQ(last.planned, 6U);
  EXPECT_EQ(last.done, 6U);
  EXPECT_EQ(last.solved, 6U);
  EXPECT_EQ(last.secondsLeft, 0.0);
  ASSERT_TRUE(run(folder, program("")).ok());
  EXPECT_EQ(started(), 6U) << "what is done is not run again";
}

TEST_F(StudyRunnerTest, ACrashIsARowAndNotTheEnd) {
  const StudyFolder folder = begin();
  ASSERT_TRUE(run(folder, program("test $8 = 1 && kill -SEGV $$")).ok());
  const StudyResults results = folder.results(warnings);
  ASSERT_EQ(results.size(), 6U);
  for (const auto& [which, outcome] : results) {
    EXPECT_EQ(outcome.result.status, which.seed == 1 ? RunStatus::Crashed : RunStatus::Solved);
  }
  EXPECT_EQ(results.at({0, 1}).result.message, "ended by signal 11");
}

TEST_F(StudyRunnerTest, ARunOutOfMemoryIsARow) {
  const StudyFolder folder = begin();
  ASSERT_TRUE(run(folder, program("test $8 = 2 && echo 'glissade-cli: std::bad_alloc' >&2 && exit 70")).ok());
  EXPECT_EQ(folder.results(warnings).at({2, 2}).result.status, RunStatus::Memory);
}

TEST_F(StudyRunnerTest, AskedToStopItKillsAndCanGoOn) {
  const StudyFolder folder = begin();
  StopSource source;
  // The runs of the second seed hang; a stop comes after the first ones are done.
  const auto interrupted =
      run(folder, program("test $8 = 2 && exec sleep 1000"), 1, source.token(), [&](const StudyProgress& progress) {
        if (progress.done == 3) source.requestStop();
      });
  ASSERT_FALSE(interrupted.ok());
  EXPECT_EQ(interrupted.error().kind, ErrorKind::Interrupted);
  EXPECT_EQ(folder.results(warnings).size(), 3U);
  ASSERT_TRUE(run(folder, program("")).ok());
  EXPECT_EQ(folder.results(warnings).size(), 6U);
}

TEST_F(StudyRunnerTest, TablesAreTheSameWhateverTheNumberOfJobs) {
  const StudyFolder one = begin("one");
  const StudyFolder four = begin("four");
  ASSERT_TRUE(run(one, program(""), 1).ok());
  ASSERT_TRUE(run(four, program("sleep 0.$(($8 % 3))"), 4).ok());
  ASSERT_TRUE(writeTables(one, one.path(), warnings).ok());
  ASSERT_TRUE(writeTables(four, four.path(), warnings).ok());
  for (const char* table : {"runs.csv", "summary.csv", "summary.json", "plan.json"}) {
    EXPECT_EQ(test::readWhole(one.file(table)), test::readWhole(four.file(table))) << table;
  }
}

}  // namespace
}  // namespace glissade
