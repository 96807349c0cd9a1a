#pragma once

#include <string>
#include <vector>

#include "engine/documents/plot_scale.h"

namespace glissade {

struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
  std::string says;  ///< its description with numbers, one line for a tooltip
};

/// A plot of one line as a value.
struct LinePlot {
  std::string title;
  PlotScale x;
  PlotScale y;
  std::vector<PlotPoint> points;
};

/// The plot as an <svg> element that stands alone: axes with ticks and titles, and points on a line. The same plot
/// gives the same text.
std::string svgOf(const LinePlot& plot);

}  // namespace glissade
