// Tests that scales map values to the right positions, and that the SVG has the same numbers.
#include "engine/study/svg_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "engine/study/cell_value.h"
#include "engine/study/xml_text.h"

namespace glissade {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::string> labelsOf(const PlotScale& scale) {
  std::vector<std::string> labels;
  for (const PlotTick& tick : scale.ticks()) {
    if (!tick.label.empty()) labels.push_back(tick.label);
  }
  return labels;
}

TEST(PlotScale, LinearHasRoundTicksFromZero) {
  const PlotScale scale = PlotScale::linear("t", {12.0, 133.0});
  EXPECT_THAT(labelsOf(scale), testing::ElementsAre("0", "50", "100", "150"));
  EXPECT_DOUBLE_EQ(scale.position(0.0), 0.0);
  EXPECT_DOUBLE_EQ(scale.position(75.0), 0.5);
  EXPECT_DOUBLE_EQ(scale.position(150.0), 1.0);
}

TEST(PlotScale, LogarithmicKeepsRatios) {
  const PlotScale scale = PlotScale::logarithmic("t", {10.0, 100000.0});
  EXPECT_NEAR(scale.position(10.0), 0.0, 1e-12);
  EXPECT_NEAR(scale.position(1000.0), 0.5, 1e-12);
  EXPECT_NEAR(scale.position(100000.0), 1.0, 1e-12);
  EXPECT_THAT(labelsOf(scale), testing::ElementsAre("10", "100", "1000", "10\u202f000", "100\u202f000"));
  EXPECT_EQ(scale.breakPosition(), 0.0);
}

TEST(PlotScale, AZeroHasItsPlaceBeforeTheLogarithms) {
  const PlotScale scale = PlotScale::fitting("t", {0.0, 0.01, 1.0});
  EXPECT_TRUE(scale.isLogarithmic());
  EXPECT_EQ(scale.position(0.0), 0.0);
  EXPECT_GT(scale.position(0.01), scale.breakPosition());
  EXPECT_GT(scale.breakPosition(), 0.0);
  EXPECT_EQ(labelsOf(scale).front(), "0");
}

TEST(PlotScale, TakesValuesThatSayNothing) {
  for (const std::vector<double>& values : {std::vector<double>{}, {0.0}, {5.0}, {0.0, 0.0}}) {
    for (const PlotScale& scale : {PlotScale::linear("", values), PlotScale::fitting("", values)}) {
      EXPECT_TRUE(std::isfinite(scale.position(5.0)));
      EXPECT_FALSE(scale.ticks().empty());
    }
  }
}

TEST(PlotScale, CategoriesLieInTheMiddleOfTheirShare) {
  const PlotScale scale = PlotScale::categories("", {"a", "b"});
  EXPECT_DOUBLE_EQ(scale.position(0.0), 0.25);
  EXPECT_DOUBLE_EQ(scale.position(1.0), 0.75);
}

Plot somePlot(PlotKind kind) {
  Plot plot;
  plot.title = "A < B & \"C\"";
  plot.kind = kind;
  plot.barWidth = 0.1;
  plot.x = PlotScale::linear("x", {0.0, 10.0});
  plot.y = PlotScale::linear("y", {0.0, 100.0});
  plot.series = {{"ours", false, 0, 0.0, {{5.0, 50.0, 25.0, 75.0, "97", "says <it>", 3}}}};
  return plot;
}

TEST(SvgPlot, PutsAPointAndItsIntervalAtTheirPixels) {
  PlotFrame frame;
  frame.width = 200.0;
  frame.height = 150.0;
  frame.left = frame.right = frame.top = frame.bottom = 25.0;  // the plane is 150 x 100
  const std::string svg = svgPlot(somePlot(PlotKind::Lines), frame);
  EXPECT_THAT(svg, HasSubstr("cx=\"100\" cy=\"75\""));
  EXPECT_THAT(svg, HasSubstr("x1=\"100\" y1=\"100\" x2=\"100\" y2=\"50\""));
  EXPECT_THAT(svg, HasSubstr(">97</text>"));
}

TEST(SvgPlot, ABarStandsOnTheAxis) {
  PlotFrame frame;
  frame.width = 200.0;
  frame.height = 150.0;
  frame.left = frame.right = frame.top = frame.bottom = 25.0;
  const std::string svg = svgPlot(somePlot(PlotKind::Bars), frame);
  EXPECT_THAT(svg, HasSubstr("<rect x=\"93.25\" y=\"75\" width=\"13.5\" height=\"50\""));
}

TEST(SvgPlot, TextsAreEscaped) {
  const std::string svg = svgPlot(somePlot(PlotKind::Lines));
  EXPECT_THAT(svg, HasSubstr("A &lt; B &amp; &quot;C&quot;"));
  EXPECT_THAT(svg, HasSubstr("says &lt;it&gt;"));
  EXPECT_THAT(svg, Not(HasSubstr("says <it>")));
}

TEST(XmlText, LeavesOutWhatXmlForbids) {
  EXPECT_EQ(escaped(std::string("a\x01"
                                "b<\n")),
            "ab&lt;\n");
}

TEST(ShortNumber, SaysEnoughAndNoMore) {
  EXPECT_EQ(shortNumber(0.0), "0");
  EXPECT_EQ(shortNumber(27600.0), "27\u202f600");
  EXPECT_EQ(shortNumber(1234567.0), "1\u202f234\u202f567");
  EXPECT_EQ(shortNumber(1234.4), "1234");
  EXPECT_EQ(shortNumber(14.46), "14.5");
  EXPECT_EQ(shortNumber(0.1523), "0.152");
  EXPECT_EQ(shortNumber(0.08), "0.08");
  EXPECT_EQ(percent(0.974), "97 %");
}

TEST(SvgPlot, NamesThatDoNotFitSideBySideAreInTwoRows) {
  const auto heights = [](const std::vector<std::string>& names) {
    Plot plot;
    plot.kind = PlotKind::Bars;
    plot.x = PlotScale::categories("", names);
    const std::string svg = svgPlot(plot);
    std::set<std::string> rows;
    for (const std::string& name : names) {
      const std::size_t label = svg.rfind("<text", svg.find(">" + name + "<"));
      const std::size_t y = svg.find(" y=", label);
      rows.insert(svg.substr(y, svg.find(' ', y + 1) - y));
    }
    return rows.size();
  };
  EXPECT_EQ(heights({"mount", "unmount"}), 1U);
  EXPECT_EQ(heights({"tight-circle", "tight-square", "tight-triangle", "tight-pentagon", "tight-star", "mount",
                     "unmount", "environment-1", "environment-2"}),
            2U);
}

}  // namespace
}  // namespace glissade
