#pragma once

#include <string>

#include "engine/study/plan_graph.h"
#include "engine/study/plan_timing.h"

namespace glissade {

/// How a line carries out a plan, as an SVG picture: a bar for each station with its steps in the order of assembly, as
/// wide as they take, with their numbers; one bar where no line was asked for. Steps of the longest chain are framed.
/// The dashed line is the cycle of the line.
std::string lineChartSvg(const PlanTiming& timing, const StudyWords& words, const GraphColours& colours = {});

}  // namespace glissade
