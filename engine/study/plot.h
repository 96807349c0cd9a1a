#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/plot_scale.h"

namespace glissade {

struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
  double low = 0.0;  ///< lower end of its interval; low == high: no interval
  double high = 0.0;
  std::string mark;                 ///< text printed above it; may be empty
  std::string says;                 ///< its description with numbers, one line for a tooltip
  std::optional<std::size_t> cell;  ///< cell of the study; nothing: a value of the paper
};

struct PlotSeries {
  std::string name;       ///< series of the same name share a place in the legend
  bool ofPaper = false;   ///< drawn with diamonds in the text's colour
  std::size_t style = 0;  ///< index of its colour and marker; unused for the paper
  double offset = 0.0;    ///< shift of its points along x, as a share of the axis, so that intervals do not overlap
  std::vector<PlotPoint> points;
};

enum class PlotKind { Lines, Bars };

/// A plot as a value, drawn by svg_plot.h and by the window.
struct Plot {
  std::string name;  ///< short name for files and ids: "time_s"
  std::string title;
  std::string caption;  ///< explanation of the points and intervals
  PlotKind kind = PlotKind::Lines;
  PlotScale x;
  PlotScale y;
  double barWidth = 0.0;  ///< width of bars as a share of the axis
  std::vector<PlotSeries> series;
};

/// Okabe and Ito's colours, for example "#0072B2". They can be distinguished with any colour blindness, on light and on
/// dark background. Their order keeps neighbouring series distinct.
inline constexpr std::size_t kPlotStyleCount = 6;
inline constexpr const char* kPlotColours[kPlotStyleCount] = {"#0072B2", "#D55E00", "#009E73",
                                                              "#CC79A7", "#E69F00", "#56B4E9"};

}  // namespace glissade
