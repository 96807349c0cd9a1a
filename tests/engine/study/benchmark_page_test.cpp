// Tests that the page of results depends on files only, is complete and self-contained, and is the same every time.
#include "engine/study/benchmarks/benchmark_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/study/report_html.h"
#include "tests/engine/study/benchmark_samples.h"
#include "tests/engine/study/study_fixture.h"

namespace glissade {
namespace {

using testing::HasSubstr;
using testing::Not;

class BenchmarkPage : public testing::Test {
 protected:
  std::string page() {
    warnings.clear();
    const auto report = benchmarkPage(folder / "", warnings);
    if (!report) return toString(report.error());
    const auto html = reportHtml(*report);
    return html ? *html : toString(html.error().reason);
  }

  /// Adds one row with auto and two peers; auto is solved in 1 s, the first peer in 12 s, the second one not.
  void addStudy() {
    auto study = test::tinyStudy();
    study["name"] = "beside";
    study["strategies"] = {"auto", "peer-rrtconnect", "peer-trrt"};
    study["rows"] = {{{"label", "all"}}};
    study.erase("quick");
    const test::StudyFiles files(study);
    const auto plan = planStudy(files.file, false, warnings);
    ASSERT_TRUE(plan.ok()) << toString(plan.error());
    const auto begun = StudyFolder::begin(folder / "beside", *plan, "{}");
    ASSERT_TRUE(begun.ok());
    for (const StudyRun& run : runsOf(plan->study, {})) {
      RunOutcome outcome;
      outcome.result.status = run.cell < 2 ? RunStatus::Solved : RunStatus::NotCertified;
      outcome.timing.planningCpuSeconds = run.cell == 0 ? 1.0 : run.cell == 1 ? 12.0 : 0.5;
      ASSERT_TRUE(begun->save(run, outcome).ok());
    }
  }

  test::TemporaryFolder folder;
  Warnings warnings;
};

TEST_F(BenchmarkPage, HasTheKernelBesideFcl) {
  folder.write("collision.json", test::kCollisionBenchmarks);
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("Collide: 30 times faster than FCL.</td>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"holds\">holds</td><td class=\"number\">60"));
  EXPECT_THAT(html, HasSubstr("<td class=\"refuted\">does not hold</td><td class=\"number\">10"));
  EXPECT_THAT(html, HasSubstr("<td class=\"open\">open</td>")) << "edges were asked of one only";
  EXPECT_THAT(html, HasSubstr("<td>L/near</td>"));
  EXPECT_THAT(html, HasSubstr("abc123"));
  EXPECT_THAT(html, HasSubstr("OMPL 1, FCL 2"));
  EXPECT_THAT(html, Not(HasSubstr("secret"))) << "the name of the machine is nobody's business";
  EXPECT_THAT(html, HasSubstr("Not measured this time (growth_benchmark)."));
}

TEST_F(BenchmarkPage, HasThePlotsOfGrowthWithExponents) {
  folder.write("growth.json", test::kGrowthBenchmarks);
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("id=\"growth-iteration\""));
  EXPECT_THAT(html, HasSubstr("RRT: n^1"));
  EXPECT_THAT(html, HasSubstr("Nodes of its trees"));
}

TEST_F(BenchmarkPage, HasAutoBesideTheBestOfTheOthers) {
  addStudy();
  const std::string html = page();
  EXPECT_TRUE(warnings.empty());
  EXPECT_THAT(html, HasSubstr("all, peer-rrtconnect</td><td>every 1 %</td><td class=\"number\">2 of 2</td>"
                              "<td class=\"number\">12</td><td class=\"number\">12</td>"))
      << "the faster one has not solved";
  EXPECT_THAT(html, HasSubstr("not-certified"));
}

TEST_F(BenchmarkPage, NeedsNothingElseAndIsTheSameAgain) {
  folder.write("collision.json", test::kCollisionBenchmarks);
  folder.write("growth.json", test::kGrowthBenchmarks);
  folder.write("commands.txt", "growth_benchmark <all>\n");
  addStudy();
  const std::string html = page();
  for (const char* outside : {"src=\"http", "href=", "@import", "url(", "<script"}) {
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  }
  EXPECT_THAT(html, HasSubstr("growth_benchmark &lt;all&gt;"));
  EXPECT_EQ(html, page());
  ASSERT_TRUE(writeBenchmarkPage(folder / "", warnings).ok());
  EXPECT_EQ(test::readWhole(folder / "benchmarks.html"), html);
}

TEST_F(BenchmarkPage, SaysWhereThereIsNothing) {
  EXPECT_THAT(page(), HasSubstr("holds no results of benchmarks"));
  const auto none = benchmarkPage(folder / "nowhere", warnings);
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().kind, ErrorKind::MalformedInput);
}

TEST_F(BenchmarkPage, NamesTheFileThatIsBroken) {
  folder.write("collision.json", test::kCollisionBenchmarks);
  folder.write("octree.json", "{\"context\": ");
  const auto report = benchmarkPage(folder / "", warnings);
  ASSERT_FALSE(report.ok());
  EXPECT_THAT(report.error().file, HasSubstr("octree.json"));
}

}  // namespace
}  // namespace glissade
