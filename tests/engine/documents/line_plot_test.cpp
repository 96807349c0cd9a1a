// Tests that scales map values to the right positions, and that the SVG has the same numbers.
#include "engine/documents/line_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/documents/short_number.h"
#include "engine/documents/xml_text.h"

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
  const PlotScale scale = PlotScale::fitting("t", {10.0, 100000.0});
  EXPECT_NEAR(scale.position(10.0), 0.0, 1e-12);
  EXPECT_NEAR(scale.position(1000.0), 0.5, 1e-12);
  EXPECT_NEAR(scale.position(100000.0), 1.0, 1e-12);
  EXPECT_THAT(labelsOf(scale), testing::ElementsAre("10", "100", "1000", "10\u202f000", "100\u202f000"));
}

TEST(PlotScale, AZeroHasItsPlaceBeforeTheLogarithms) {
  const PlotScale scale = PlotScale::fitting("t", {0.0, 0.01, 1.0});
  EXPECT_EQ(scale.position(0.0), 0.0);
  EXPECT_GT(scale.position(0.01), 0.05);
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

TEST(LinePlot, PutsPointsAtTheirPixelsWithTheirTexts) {
  const LinePlot plot{"A < B & \"C\"",
                      PlotScale::linear("x", {0.0, 10.0}),
                      PlotScale::linear("y", {0.0, 100.0}),
                      {{5.0, 50.0, "says <it>"}, {10.0, 100.0, ""}}};
  const std::string svg = svgOf(plot);
  EXPECT_THAT(svg, HasSubstr("cx=\"398\" cy=\"168\""));
  EXPECT_THAT(svg, HasSubstr("points=\"398,168 720,20\""));
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
}

}  // namespace
}  // namespace glissade
