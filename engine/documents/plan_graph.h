#pragma once

#include <string>

#include "engine/documents/document_words.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// Colours of a picture in SVG notation.
struct GraphColours {
  std::string ink = "#1d2329";
  std::string line = "#7b8794";
  std::string box = "#eef3f8";
  std::string stuck = "#d55e00";
  std::string ground = "#ffffff";
};

/// The order of a plan as an SVG picture. A box is a step of the removal, with its number. An arrow leads from a step
/// to each step that must come after it; implied arrows are left out. A column holds the steps whose longest chain of
/// predecessors has the same length. Stuck parts follow on the right, with dashed arrows from the parts that block
/// them. Precondition: the plan is about this product.
std::string planGraphSvg(const AssemblyPlan& plan, const AssembledProduct& product, const DocumentWords& words,
                         const GraphColours& colours = {});

}  // namespace glissade
