#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/check/product.h"
#include "engine/import/part_solids.h"
#include "engine/model/fit_options.h"

namespace glissade::check {

/// Reads a scenario or an OMPL.app file. Errors: MalformedInput with the place, Usage for a part file, Interrupted.
Result<Question> readQuestion(const std::string& file, const FitOptions& fits = {}, const StopToken& stop = {});

/// Reads a product: a scenario with its object at the start, a STEP file, an assembly in one (product.step:pump), or a
/// URDF file. Each body has its frame at the centre of its box. `deflection`: deflection that a plan states for STEP
/// parts, metres; 0: none. A part is read with the usual deflection if the stated one is coarser, because a plan may
/// not choose how coarsely it is judged.
Result<Product> readProduct(const std::string& file, double deflection, const FitOptions& fits = {},
                            const StopToken& stop = {}, const PartChoice& choice = {});

/// Removes the named bodies and the statements about their fits (option --without). A warning lists them. A plan cannot
/// request this. Errors: see bodiesMeant().
Outcome leaveOut(const std::vector<std::string>& names, Product& product);

}  // namespace glissade::check
