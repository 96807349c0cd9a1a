#include "engine/study/svg_plot.h"

#include <algorithm>
#include <set>

#include "engine/study/xml_text.h"

namespace glissade {
namespace {

constexpr const char* kInk = "#1d2329";
constexpr const char* kFaint = "#c9d0d8";
constexpr const char* kGround = "#ffffff";
constexpr double kTick = 5.0;
constexpr double kMarker = 4.2;
constexpr double kLegendRow = 18.0;
constexpr double kLetter = 7.2;  ///< width of a letter, or a little more
/// Height of one row of labels and of the title under the axis.
constexpr double kOneRow = 18.0;
constexpr double kFirstOfTwoRows = 14.0;
constexpr double kSecondOfTwoRows = 27.0;
constexpr double kTitleBelowOne = 38.0;
constexpr double kTitleBelowTwo = 42.0;

std::string attribute(const std::string& name, double value) { return " " + name + "=\"" + pixels(value) + "\""; }
std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + escaped(value) + "\"";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& style) {
  return "<line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) + attribute("y2", y2) + style +
         "/>\n";
}

std::string text(double x, double y, const std::string& anchor, const std::string& content,
                 const std::string& more = "") {
  return "<text class=\"ink\"" + attribute("x", x) + attribute("y", y) + attribute("fill", kInk) +
         attribute("text-anchor", anchor) + more + ">" + escaped(content) + "</text>\n";
}

std::string stroke(const std::string& colour, double width) {
  return attribute("stroke", colour) + attribute("stroke-width", width);
}
std::string inkStroke(double width) { return attribute("class", "ink-line") + stroke(kInk, width); }

/// The tooltip of an element.
std::string titled(const std::string& says) { return "<title>" + escaped(says) + "</title>"; }

/// The marker of a style, around the origin. Each style has its own shape, so that colour is not the only distinction.
std::string markerShape(const PlotSeries& series) {
  if (series.ofPaper) return "0,-5.6 5.6,0 0,5.6 -5.6,0";
  switch (series.style % 3) {
    case 1: return "-3.8,-3.8 3.8,-3.8 3.8,3.8 -3.8,3.8";
    case 2: return "0,-4.8 4.6,3.4 -4.6,3.4";
    default: return "";
  }
}

std::string colourOf(const PlotSeries& series) {
  return series.ofPaper ? kInk : kPlotColours[series.style % kPlotStyleCount];
}

std::string marker(const PlotSeries& series, double x, double y, const std::string& says) {
  const std::string shape = markerShape(series);
  const std::string fill = series.ofPaper ? attribute("class", "ink ground-line") : attribute("class", "ground-line");
  const std::string style = fill + attribute("fill", colourOf(series)) + stroke(kGround, 1.0);
  const std::string inner = says.empty() ? "" : titled(says);
  if (shape.empty()) {
    return "<circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", kMarker) + style + ">" + inner +
           "</circle>\n";
  }
  return "<polygon" + attribute("points", shape) +
         attribute("transform", "translate(" + pixels(x) + "," + pixels(y) + ")") + style + ">" + inner +
         "</polygon>\n";
}

/// Draws one plot.
class Drawing {
 public:
  Drawing(const Plot& plot, const PlotFrame& frame) : plot_(plot), frame_(frame), height_(frame.height) {}

  std::string draw() {
    // Series of bars lie under their intervals, and both lie over the grid.
    drawGrid();
    for (const PlotSeries& series : plot_.series) drawSeries(series);
    drawAxes();
    drawLegend();
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"" + attribute("aria-label", plot_.title) +
           attribute("viewBox", "0 0 " + pixels(frame_.width) + " " + pixels(height_)) +
           attribute("width", frame_.width) + attribute("height", height_) +
           attribute("font-family", "DejaVu Sans, Liberation Sans, Arial, sans-serif") + attribute("font-size", 12.0) +
           ">\n" + titled(plot_.title) + "\n" + out_ + "</svg>\n";
  }

 private:
  double xOf(const PlotSeries& series, const PlotPoint& point) const {
    return frame_.xAt(plot_.x.position(point.x) + series.offset);
  }
  double yOf(double value) const { return frame_.yAt(std::clamp(plot_.y.position(value), 0.0, 1.0)); }

  void drawGrid() {
    const std::string faint = attribute("class", "faint") + stroke(kFaint, 1.0);
    for (const PlotTick& tick : plot_.y.ticks()) {
      const double y = frame_.yAt(tick.position);
      if (!tick.label.empty()) out_ += line(frame_.xAt(0), y, frame_.xAt(1), y, faint);
    }
  }

  void drawAxes() {
    out_ += line(frame_.xAt(0), frame_.yAt(0), frame_.xAt(1), frame_.yAt(0), inkStroke(1.0));
    out_ += line(frame_.xAt(0), frame_.yAt(0), frame_.xAt(0), frame_.yAt(1), inkStroke(1.0));
    drawXLabels();
    for (const PlotTick& tick : plot_.y.ticks()) {
      const double y = frame_.yAt(tick.position);
      const double length = tick.label.empty() ? 0.6 * kTick : kTick;
      out_ += line(frame_.xAt(0) - length, y, frame_.xAt(0), y, inkStroke(1.0));
      if (!tick.label.empty()) out_ += text(frame_.xAt(0) - 8.0, y + 4.0, "end", tick.label);
    }
    drawBreak();
    const double middle = frame_.yAt(0.5);
    out_ +=
        text(18.0, middle, "middle", plot_.y.title(), attribute("transform", "rotate(-90 18 " + pixels(middle) + ")"));
  }

  /// Draws the labels, alternating between two rows where one is too narrow.
  void drawXLabels() {
    const std::vector<PlotTick>& ticks = plot_.x.ticks();
    const bool crowded = plot_.x.isCategories() && widestLabel(ticks) > (frame_.xAt(1) - frame_.xAt(0)) / ticks.size();
    double below = crowded ? kFirstOfTwoRows : kOneRow;
    for (const PlotTick& tick : ticks) {
      const double x = frame_.xAt(tick.position);
      const double length = tick.label.empty() ? 0.6 * kTick : kTick;
      if (!plot_.x.isCategories()) out_ += line(x, frame_.yAt(0), x, frame_.yAt(0) + length, inkStroke(1.0));
      if (!tick.label.empty()) out_ += text(x, frame_.yAt(0) + below, "middle", tick.label);
      if (crowded) below = kFirstOfTwoRows + kSecondOfTwoRows - below;
    }
    out_ +=
        text(frame_.xAt(0.5), frame_.yAt(0) + (crowded ? kTitleBelowTwo : kTitleBelowOne), "middle", plot_.x.title());
  }

  static double widestLabel(const std::vector<PlotTick>& ticks) {
    std::size_t most = 0;
    for (const PlotTick& tick : ticks) most = std::max(most, tick.label.size());
    return kLetter * static_cast<double>(most);
  }

  /// Draws two strokes across the axis, between the zero and the beginning of the logarithms.
  void drawBreak() {
    if (plot_.x.breakPosition() <= 0.0) return;
    const double x = frame_.xAt(plot_.x.breakPosition());
    const double y = frame_.yAt(0);
    for (const double shift : {-2.5, 2.5}) out_ += line(x + shift - 2, y + 5, x + shift + 2, y - 5, inkStroke(1.0));
  }

  void drawSeries(const PlotSeries& series) {
    if (plot_.kind == PlotKind::Bars && !series.ofPaper) {
      for (const PlotPoint& point : series.points) drawBar(series, point);
    } else if (plot_.kind == PlotKind::Lines) {
      drawLine(series);
    }
    for (const PlotPoint& point : series.points) {
      drawInterval(series, point);
      if (plot_.kind == PlotKind::Lines || series.ofPaper) {
        out_ += marker(series, xOf(series, point), yOf(point.y), point.says);
      }
      if (point.mark.empty()) continue;
      const double top = yOf(std::max(point.y, point.high)) - 5.0;
      out_ += text(xOf(series, point), top, "middle", point.mark, attribute("font-size", 8.5));
    }
  }

  void drawLine(const PlotSeries& series) {
    if (series.points.size() < 2) return;
    std::string points;
    for (const PlotPoint& point : series.points) {
      points += (points.empty() ? "" : " ") + pixels(xOf(series, point)) + "," + pixels(yOf(point.y));
    }
    out_ += "<polyline" + attribute("points", points) + attribute("fill", "none") +
            (series.ofPaper ? inkStroke(1.5) + attribute("stroke-dasharray", "5 4") : stroke(colourOf(series), 1.8)) +
            "/>\n";
  }

  void drawBar(const PlotSeries& series, const PlotPoint& point) {
    const double width = 0.9 * plot_.barWidth * (frame_.xAt(1) - frame_.xAt(0));
    const double top = yOf(point.y);
    out_ += "<rect" + attribute("x", xOf(series, point) - width / 2) + attribute("y", top) + attribute("width", width) +
            attribute("height", frame_.yAt(0) - top) + attribute("fill", colourOf(series)) + ">" + titled(point.says) +
            "</rect>\n";
  }

  void drawInterval(const PlotSeries& series, const PlotPoint& point) {
    if (point.low == point.high) return;
    const double x = xOf(series, point);
    const double low = yOf(point.low);
    const double high = yOf(point.high);
    const std::string style = plot_.kind == PlotKind::Bars ? inkStroke(1.2) : stroke(colourOf(series), 1.4);
    out_ += line(x, low, x, high, style);
    for (const double y : {low, high}) out_ += line(x - 3.0, y, x + 3.0, y, style);
  }

  void drawLegend() {
    std::set<std::string> shown;
    double x = frame_.left;
    double y = frame_.height - frame_.bottom + 62.0;
    for (const PlotSeries& series : plot_.series) {
      if (!shown.insert(series.name).second) continue;
      const double wide = 30.0 + kLetter * static_cast<double>(series.name.size());
      if (x + wide > frame_.width && x > frame_.left) {
        x = frame_.left;
        y += kLegendRow;
        height_ += kLegendRow;
      }
      drawKey(series, x, y);
      out_ += text(x + 26.0, y + 4.0, "start", series.name);
      x += wide + 8.0;
    }
  }

  void drawKey(const PlotSeries& series, double x, double y) {
    if (plot_.kind == PlotKind::Bars && !series.ofPaper) {
      out_ += "<rect" + attribute("x", x + 4.0) + attribute("y", y - 6.0) + attribute("width", 14.0) +
              attribute("height", 12.0) + attribute("fill", colourOf(series)) + "/>\n";
      return;
    }
    if (plot_.kind == PlotKind::Lines) {
      const std::string dashed = inkStroke(1.5) + attribute("stroke-dasharray", "5 4");
      out_ += line(x, y, x + 22.0, y, series.ofPaper ? dashed : stroke(colourOf(series), 1.8));
    }
    out_ += marker(series, x + 11.0, y, "");
  }

  const Plot& plot_;
  const PlotFrame& frame_;
  double height_;  ///< height of the picture, including all rows of the legend
  std::string out_;
};

}  // namespace

std::string svgPlot(const Plot& plot, const PlotFrame& frame) { return Drawing(plot, frame).draw(); }

}  // namespace glissade
