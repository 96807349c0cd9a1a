#pragma once

#include <string>

#include "engine/documents/plan_graph.h"
#include "engine/documents/plan_timing.h"

namespace glissade {

/// The division of a plan among the stations of a line, as an SVG picture. Each station has a bar with its steps in the
/// order of assembly; the width of a step is its time, and the steps have their numbers. Without a line there is one
/// bar. Steps of the longest chain are framed. The dashed line is the cycle time of the line.
std::string lineChartSvg(const PlanTiming& timing, const DocumentWords& words, const GraphColours& colours = {});

}  // namespace glissade
