#pragma once

#include <string>

#include "engine/study/plot.h"

namespace glissade {

/// Margins in the pictures of svgPlot, in their pixels.
struct PlotFrame {
  double width = 760.0;
  double height = 400.0;
  double left = 76.0;
  double right = 40.0;  ///< includes half of a long last label
  double top = 20.0;
  double bottom = 84.0;  ///< includes the legend

  double xAt(double position) const { return left + position * (width - left - right); }
  double yAt(double position) const { return height - bottom - position * (height - top - bottom); }
};

/// A plot as an <svg> element that stands alone: axes with ticks and titles, points with intervals, a legend. Colours
/// are attributes, so that a style sheet can override them by class (ink, faint, ground). The same plot gives the same
/// text.
std::string svgPlot(const Plot& plot, const PlotFrame& frame = {});

}  // namespace glissade
