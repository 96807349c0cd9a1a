// Tests that the report of a folder of results is complete, self-contained and the same every time.
#include "engine/study/study_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/study/finding_check.h"
#include "engine/study/report_html.h"
#include "engine/study/study_plots.h"
#include "tests/engine/study/study_fixture.h"

namespace glissade {
namespace {

using testing::HasSubstr;
using testing::Not;

class Report : public testing::Test {
 protected:
  Report() {
    Warnings warnings;
    const auto plan = planStudy(files.file, false, warnings);
    auto begun = StudyFolder::begin(files.folder / "out", *plan, "{}");
    folder = std::make_unique<StudyFolder>(*begun);
    double nodes = 10.0;
    for (const StudyRun& run : runsOf(plan->study, {})) {
      RunOutcome outcome;
      outcome.result.status = RunStatus::Solved;
      for (auto& number : outcome.result.numbers) number = nodes;
      nodes += 10.0;
      EXPECT_TRUE(folder->save(run, outcome).ok());
    }
  }

  std::string page() {
    Warnings warnings;
    const auto html = reportHtml(reportOf(*folder, warnings));
    return html ? *html : toString(html.error().reason);
  }

  test::StudyFiles files;
  std::unique_ptr<StudyFolder> folder;
};

TEST_F(Report, HasEveryRowWithPaperAndOurs) {
  const std::string html = page();
  for (const StudyCell& cell : folder->plan().study.cells) {
    EXPECT_THAT(html, HasSubstr("<td>" + cell.label + "</td><td class=\"number\">2 of 2</td>"));
  }
  EXPECT_THAT(html, HasSubstr("<td class=\"number\">12.5</td>"));
  EXPECT_THAT(html, HasSubstr("a, &quot;b&quot;"));
}

TEST_F(Report, SpeaksFrench) {
  Warnings warnings;
  const auto html = reportHtml(reportOf(*folder, warnings, Language::French));
  ASSERT_TRUE(html.ok());
  EXPECT_EQ(StudyWords(Language::French)(std::string(name(Verdict::Holds))), "vérifié");
  EXPECT_THAT(*html, HasSubstr("<html lang=\"fr\""));
  for (const char* french : {"Ce qui a été calculé", "2 sur 2", "Comment le refaire", "article"}) {
    EXPECT_THAT(*html, HasSubstr(french));
  }
  for (const char* english : {"What was run", "2 of 2", "How to repeat it", "Median", "Scenario<"}) {
    EXPECT_THAT(*html, Not(HasSubstr(english)));
  }
}

TEST_F(Report, HasEveryCommand) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("glissade-cli study tiny.json --out out/tiny --jobs 2"));
  EXPECT_THAT(html, HasSubstr("glissade-cli plan scenario.json --strategy birrt --operator none --seed 1"));
  EXPECT_THAT(html, HasSubstr("--extension-step 0.02"));
}

TEST_F(Report, NeedsNothingElseAndIsTheSameAgain) {
  const std::string html = page();
  for (const char* outside : {"src=\"http", "href=", "@import", "url(", "<script"}) {
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  }
  EXPECT_EQ(html, page());
}

TEST_F(Report, HasThePicturesInsideIt) {
  files.folder.write("out/pictures/cell1.png", "PNG?");
  files.folder.write("out/pictures/cell1.txt", "A typical roadmap");
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("data:image/png;base64,UE5HPw=="));
  EXPECT_THAT(html, HasSubstr("<figcaption>A typical roadmap</figcaption>"));
}

TEST_F(Report, PlotsVaryWhatTheStudyVaries) {
  Warnings warnings;
  const Study& study = folder->plan().study;
  const auto plots = plotsOf(study, summarise(study, folder->results(warnings)));
  ASSERT_EQ(plots.size(), 2U);
  EXPECT_EQ(plots[0].name, "time_s-over-extension_step");
  ASSERT_EQ(plots[0].series.size(), 1U);  // the paper's row sets no extension step
  ASSERT_EQ(plots[0].series[0].points.size(), 2U);
  EXPECT_EQ(plots[0].series[0].points[0].x, 0.01);
  EXPECT_EQ(plots[0].series[0].points[1].x, 0.02);
  EXPECT_THAT(plots[0].caption, HasSubstr("Not on this axis: plain."));
}

TEST(StudyPlots, SettingsOfPeersArePanelsAndSeriesNotAxes) {
  auto json = test::tinyStudy();
  json.erase("quick");
  json["strategies"] = {"peer-rrtconnect"};
  json["rows"] = {{{"label", "ours"}, {"strategies", {"auto"}}},
                  {{"label", "peers"}, {"grid", {{"ompl_range", {0, 0.03}}, {"ompl_resolution", {0.01, 0.001}}}}}};
  const test::StudyFiles files(json);
  Warnings warnings;
  const auto plan = planStudy(files.file, false, warnings);
  ASSERT_TRUE(plan.ok()) << toString(plan.error());
  const auto plots = plotsOf(plan->study, summarise(plan->study, {}));
  ASSERT_EQ(plots.size(), 4U);  // two columns, two resolutions
  EXPECT_EQ(plots[0].name, "time_s-at-0.01");
  EXPECT_EQ(plots[2].name, "time_s-at-0.001");
  EXPECT_EQ(plots[0].kind, PlotKind::Bars);
  ASSERT_EQ(plots[0].series.size(), 3U);
  EXPECT_EQ(plots[0].series[0].name, "auto");
  EXPECT_EQ(plots[0].series[2].name, "peer-rrtconnect, ompl_range 0.03");
}

TEST(Base64, KnowsTheVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace glissade
