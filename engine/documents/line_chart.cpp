#include "engine/documents/line_chart.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "engine/documents/plot_scale.h"
#include "engine/documents/times_section.h"
#include "engine/documents/xml_text.h"

namespace glissade {
namespace {

constexpr double kLeft = 104.0;  // x where bars begin
constexpr double kWidth = 700.0;
constexpr double kRight = 28.0;
constexpr double kTop = 14.0;
constexpr double kRow = 34.0;
constexpr double kBar = 24.0;
constexpr double kAxis = 46.0;
constexpr double kLegend = 26.0;
constexpr double kDigit = 7.5;  // width of a number's digit

/// The bar of one station, numbered from 0; all steps where there is no line.
struct Bar {
  std::string name;
  std::vector<std::size_t> steps;
  double seconds = 0.0;
};

std::vector<Bar> barsOf(const PlanTiming& timing, const DocumentWords& words) {
  std::vector<Bar> bars;
  if (!timing.line) {
    Bar all{words(GLISSADE_TEXT("One person")), std::vector<std::size_t>(timing.tasks.seconds.size()), timing.sum()};
    std::iota(all.steps.begin(), all.steps.end(), std::size_t{0});
    return {all};
  }
  for (std::size_t s = 0; s < timing.line->load.size(); ++s) {
    bars.push_back(
        {words(GLISSADE_TEXT("Station %1"), {std::to_string(s + 1)}), timing.stepsAt(s), timing.line->load[s]});
  }
  return bars;
}

class ChartDrawing {
 public:
  ChartDrawing(const PlanTiming& timing, const DocumentWords& words, const GraphColours& colours)
      : timing_(timing),
        words_(words),
        colours_(colours),
        bars_(barsOf(timing, words)),
        chain_(timing.chain.begin(), timing.chain.end()),
        scale_(PlotScale::linear(words(GLISSADE_TEXT("seconds")), boundsOf(bars_))) {}

  std::string svg() const {
    const double bottom = kTop + kRow * static_cast<double>(bars_.size());
    std::string svg = svgBegin(kLeft + kWidth + kRight, bottom + kAxis + kLegend, colours_.ground) + axis(bottom);
    for (std::size_t i = 0; i < bars_.size(); ++i) svg += bar(bars_[i], kTop + kRow * static_cast<double>(i));
    if (timing_.line) svg += cycle(bottom);
    return svg + text(kLeft, bottom + kAxis + 12.0, "start", words_(GLISSADE_TEXT("Framed steps: the critical path"))) +
           "</svg>\n";
  }

 private:
  static std::vector<double> boundsOf(const std::vector<Bar>& bars) {
    std::vector<double> bounds{0.0};
    for (const Bar& bar : bars) bounds.push_back(bar.seconds);
    return bounds;
  }

  double at(double seconds) const { return kLeft + kWidth * scale_.position(seconds); }

  std::string text(double x, double y, const std::string& anchor, const std::string& words) const {
    return svgText(x, y, anchor, words, colours_.ink);
  }

  std::string verticalLine(double x, double from, double to, const std::string& stroke) const {
    return "<path d=\"M" + pixels(x) + " " + pixels(from) + " V" + pixels(to) + "\" fill=\"none\" " + stroke + "/>\n";
  }

  std::string axis(double bottom) const {
    std::string svg;
    for (const PlotTick& tick : scale_.ticks()) {
      const double x = kLeft + kWidth * tick.position;
      svg += verticalLine(x, kTop, bottom, "stroke=\"" + colours_.line + "\" stroke-opacity=\"0.35\"");
      svg += text(x, bottom + 16.0, "middle", tick.label);
    }
    return svg + text(kLeft + 0.5 * kWidth, bottom + 34.0, "middle", scale_.title());
  }

  std::string bar(const Bar& bar, double top) const {
    std::string svg = text(kLeft - 10.0, top + 0.5 * kBar + 4.0, "end", bar.name);
    double begin = 0.0;
    for (const std::size_t step : bar.steps) {
      const double end = begin + timing_.tasks.seconds[step];
      svg += piece(step, at(begin), at(end), top);
      begin = end;
    }
    return svg;
  }

  std::string piece(std::size_t step, double left, double right, double top) const {
    const bool isInChain = chain_.count(step) != 0;
    const std::string number = std::to_string(step + 1);
    const double inset = isInChain ? 1.0 : 0.5;  // frames of neighbours lie beside each other
    std::string svg =
        "<rect x=\"" + pixels(left + inset) + "\" y=\"" + pixels(top + inset) + "\" width=\"" +
        pixels(std::max(0.0, right - left - 2.0 * inset)) + "\" height=\"" + pixels(kBar - 2.0 * inset) + "\" fill=\"" +
        colours_.box + "\" stroke=\"" + (isInChain ? colours_.ink : colours_.line) + "\" stroke-width=\"" +
        (isInChain ? "2" : "1") + "\"><title>" +
        escaped(words_(GLISSADE_TEXT("Step %1: %2"), {number, secondsText(timing_.tasks.seconds[step], words_)})) +
        "</title></rect>\n";
    const bool fits = right - left >= kDigit * static_cast<double>(number.size()) + 4.0;
    return fits ? svg + text(0.5 * (left + right), top + 0.5 * kBar + 4.0, "middle", number) : svg;
  }

  std::string cycle(double bottom) const {
    const std::string stroke = "stroke=\"" + colours_.stuck + "\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"";
    return verticalLine(at(timing_.line->cycle), kTop - 8.0, bottom, stroke);
  }

  const PlanTiming& timing_;
  const DocumentWords& words_;
  const GraphColours& colours_;
  std::vector<Bar> bars_;
  std::set<std::size_t> chain_;
  PlotScale scale_;
};

}  // namespace

std::string lineChartSvg(const PlanTiming& timing, const DocumentWords& words, const GraphColours& colours) {
  return ChartDrawing(timing, words, colours).svg();
}

}  // namespace glissade
