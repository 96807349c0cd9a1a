#include "engine/study/study_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "engine/base/csv_table.h"
#include "tests/engine/study/study_fixture.h"

namespace glissade {
namespace {

using testing::HasSubstr;

TEST(CsvTable, QuotesTextAndPrintsNumbersPlainly) {
  CsvTable table;
  table.header({"a", "b, c", "d"});
  table.row();
  table.text("say \"x\"");
  table.number(100000.0);
  table.number(1e-7);
  table.row();
  table.text("α\nβ");
  table.number(std::nullopt);
  table.number(0.1);
  EXPECT_EQ(table.content(), "a,\"b, c\",d\n\"say \"\"x\"\"\",100000,0.0000001\n\"α\nβ\",,0.1\n");
}

TEST(StudyTables, HaveARowARunAndACell) {
  const test::StudyFiles files;
  Warnings warnings;
  const auto plan = planStudy(files.file, false, warnings);
  const auto folder = StudyFolder::begin(files.folder / "out", *plan, "study text");
  ASSERT_TRUE(folder.ok());
  RunOutcome outcome;
  for (const std::uint64_t seed : {1, 2}) {
    outcome.result.status = seed == 1 ? RunStatus::Solved : RunStatus::LimitReached;
    outcome.result.numbers[0] = static_cast<double>(seed * 10);
    outcome.timing.planningSeconds = 0.5;
    ASSERT_TRUE(folder->save({0, seed}, outcome).ok());
  }
  ASSERT_TRUE(folder->save({1, 1}, RunOutcome()).ok());
  ASSERT_TRUE(writeTables(*folder, folder->path(), warnings).ok());

  std::istringstream runs(test::readWhole(folder->file("runs.csv")));
  std::vector<std::string> lines;
  for (std::string line; std::getline(runs, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_THAT(lines[0], testing::StartsWith("cell,label,row,scenario,strategy,operator,alpha,"));
  EXPECT_THAT(lines[1], testing::StartsWith("1,plain,plain,scenario.json,birrt,none,"));
  EXPECT_THAT(lines[1], HasSubstr(",1,solved,1,10,"));
  EXPECT_THAT(lines[2], HasSubstr(",2,limit-reached,0,20,"));
  EXPECT_THAT(lines[3], HasSubstr("\"steps, extension_step=0.01\""));
  EXPECT_THAT(lines[3], HasSubstr(",1,crashed,0,,"));

  const auto summary = nlohmann::json::parse(test::readWhole(folder->file("summary.json")));
  ASSERT_EQ(summary["cells"].size(), 3U);
  ASSERT_EQ(summary["axes"].size(), 1U) << "limits are no axes";
  EXPECT_EQ(summary["axes"][0]["key"], "extension_step");
  EXPECT_EQ(summary["axes"][0]["unit"], "m");
  const auto& cell = summary["cells"][0];
  EXPECT_EQ(cell["runs"], 2);
  EXPECT_EQ(cell["statuses"]["solved"], 1);
  EXPECT_EQ(cell["success_rate"]["share"], 0.5);
  EXPECT_EQ(cell["measures"]["nodes"]["solved"]["median"], 10);
  EXPECT_EQ(cell["measures"]["nodes"]["all"]["median"], 15);
  EXPECT_EQ(cell["paper"]["time_s"], 12.5);
  EXPECT_EQ(summary["cells"][2]["runs"], 0);
  EXPECT_EQ(summary["cells"][2]["measures"]["nodes"]["all"]["count"], 0);
  EXPECT_THAT(test::readWhole(folder->file("summary.csv")), HasSubstr("12.5,all,\"a, \"\"b\"\"\""));
  EXPECT_THAT(test::readWhole(folder->file("timing.csv")), HasSubstr("1,plain,1,solved,0.5,"));
}

}  // namespace
}  // namespace glissade
