#include "engine/documents/line_plot.h"

#include <algorithm>

#include "engine/documents/xml_text.h"

namespace glissade {
namespace {

constexpr const char* kInk = "#1d2329";
constexpr const char* kFaint = "#c9d0d8";
constexpr const char* kGround = "#ffffff";
constexpr const char* kColour = "#0072B2";
constexpr double kPlotWidth = 760.0;
constexpr double kPlotHeight = 364.0;
constexpr double kPlotLeft = 76.0;
constexpr double kPlotRight = 40.0;  // includes half of a long last label
constexpr double kPlotTop = 20.0;
constexpr double kPlotBottom = 48.0;
constexpr double kTick = 5.0;

double xAt(double position) { return kPlotLeft + position * (kPlotWidth - kPlotLeft - kPlotRight); }
double yAt(double position) { return kPlotHeight - kPlotBottom - position * (kPlotHeight - kPlotTop - kPlotBottom); }

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
  return "<text" + attribute("x", x) + attribute("y", y) + attribute("fill", kInk) + attribute("text-anchor", anchor) +
         more + ">" + escaped(content) + "</text>\n";
}

std::string stroke(const std::string& colour, double width) {
  return attribute("stroke", colour) + attribute("stroke-width", width);
}
std::string inkStroke(double width) { return stroke(kInk, width); }

/// The tooltip of an element.
std::string titled(const std::string& says) { return "<title>" + escaped(says) + "</title>"; }

double tickLength(const PlotTick& tick) { return tick.label.empty() ? 0.6 * kTick : kTick; }

std::string xAxis(const PlotScale& scale) {
  std::string svg = line(xAt(0), yAt(0), xAt(1), yAt(0), inkStroke(1.0));
  for (const PlotTick& tick : scale.ticks()) {
    const double x = xAt(tick.position);
    svg += line(x, yAt(0), x, yAt(0) + tickLength(tick), inkStroke(1.0));
    if (!tick.label.empty()) svg += text(x, yAt(0) + 18.0, "middle", tick.label);
  }
  return svg + text(xAt(0.5), yAt(0) + 38.0, "middle", scale.title());
}

std::string yAxis(const PlotScale& scale) {
  std::string svg = line(xAt(0), yAt(0), xAt(0), yAt(1), inkStroke(1.0));
  for (const PlotTick& tick : scale.ticks()) {
    const double y = yAt(tick.position);
    if (!tick.label.empty()) {
      svg += line(xAt(0), y, xAt(1), y, stroke(kFaint, 1.0));
      svg += text(xAt(0) - 8.0, y + 4.0, "end", tick.label);
    }
    svg += line(xAt(0) - tickLength(tick), y, xAt(0), y, inkStroke(1.0));
  }
  const double middle = yAt(0.5);
  return svg +
         text(18.0, middle, "middle", scale.title(), attribute("transform", "rotate(-90 18 " + pixels(middle) + ")"));
}

std::string curve(const LinePlot& plot) {
  std::string places;
  std::string markers;
  for (const PlotPoint& point : plot.points) {
    const double x = xAt(plot.x.position(point.x));
    const double y = yAt(std::clamp(plot.y.position(point.y), 0.0, 1.0));
    places += (places.empty() ? "" : " ") + pixels(x) + "," + pixels(y);
    markers += "<circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", 4.2) + attribute("fill", kColour) +
               stroke(kGround, 1.0) + ">" + titled(point.says) + "</circle>\n";
  }
  if (plot.points.size() < 2) return markers;
  return "<polyline" + attribute("points", places) + attribute("fill", "none") + stroke(kColour, 1.8) + "/>\n" +
         markers;
}

}  // namespace

std::string svgOf(const LinePlot& plot) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"" + attribute("aria-label", plot.title) +
         attribute("viewBox", "0 0 " + pixels(kPlotWidth) + " " + pixels(kPlotHeight)) +
         attribute("width", kPlotWidth) + attribute("height", kPlotHeight) +
         attribute("font-family", "DejaVu Sans, Liberation Sans, Arial, sans-serif") + attribute("font-size", 12.0) +
         ">\n" + titled(plot.title) + "\n" + yAxis(plot.y) + xAxis(plot.x) + curve(plot) + "</svg>\n";
}

}  // namespace glissade
