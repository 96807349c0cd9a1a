#include "engine/documents/line_chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace glissade {
namespace {

/// Three steps, of which the first two are a chain.
PlanTiming threeSteps() {
  PlanTiming timing{std::vector<StepTime>(3), {{2.0, 3.0, 4.0}, {{}, {0}, {}}}, {0, 1}};
  for (std::size_t i = 0; i < 3; ++i) timing.times[i].place = timing.tasks.seconds[i];
  return timing;
}

std::vector<std::string> allOf(const std::string& svg, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator i(svg.begin(), svg.end(), regex), end; i != end; ++i) found.push_back((*i)[1]);
  return found;
}

using Texts = std::vector<std::string>;

TEST(LineChart, HasABarForEachStationWithItsSteps) {
  PlanTiming timing = threeSteps();
  auto line = balanceLine(timing.tasks, 2);
  ASSERT_TRUE(line);
  timing.line = *line;
  const std::string svg = lineChartSvg(timing, DocumentWords());
  EXPECT_EQ(allOf(svg, ">(Station \\d)</text>"), (Texts{"Station 1", "Station 2"}));
  const Texts steps = allOf(svg, "<title>(Step [^<]*)</title>");
  EXPECT_EQ(steps.size(), 3U);
  EXPECT_NE(std::find(steps.begin(), steps.end(), "Step 3: 4.0 s"), steps.end());
  EXPECT_EQ(allOf(svg, "(stroke-dasharray)").size(), 1U) << "the cycle";
}

TEST(LineChart, WidthsAreTimesAndTheChainIsFramed) {
  const std::string svg = lineChartSvg(threeSteps(), DocumentWords());
  EXPECT_EQ(allOf(svg, ">(One person)</text>").size(), 1U);
  EXPECT_TRUE(allOf(svg, "(stroke-dasharray)").empty()) << "without stations there is no cycle";
  EXPECT_EQ(allOf(svg, "stroke-width=\"(2)\"").size(), 2U);
  const Texts widths = allOf(svg, "width=\"([0-9.]+)\" height=\"2[0-9.]+\" fill");
  ASSERT_EQ(widths.size(), 3U);
  // The frame is inside the piece: by 1 pixel on either side in the chain, else by a half.
  const double second = std::stod(widths[1]) + 2.0;
  EXPECT_NEAR((std::stod(widths[0]) + 2.0) / second, 2.0 / 3.0, 1e-3);
  EXPECT_NEAR((std::stod(widths[2]) + 1.0) / second, 4.0 / 3.0, 1e-3);
}

TEST(LineChart, SpeaksFrench) {
  const std::string svg = lineChartSvg(threeSteps(), DocumentWords(Language::French));
  EXPECT_NE(svg.find("Une personne"), std::string::npos);
  EXPECT_NE(svg.find("Étapes encadrées"), std::string::npos);
}

}  // namespace
}  // namespace glissade
