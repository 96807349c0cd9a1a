#pragma once

#include <optional>
#include <string>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/check/product.h"
#include "engine/import/part_solids.h"

namespace glissade::check {

/// What is asked of the fits in place of what a scenario says.
struct FitChoice {
  std::optional<bool> on{};
  std::optional<double> acceptedClash{};  ///< metres; turns fits on unless they are turned off
  std::vector<std::string> cut{};         ///< as FitWords::cut
};

/// Reads a scenario or an OMPL.app file. Errors: MalformedInput with the place, Usage for a part file, Interrupted.
Result<Question> readQuestion(const std::string& file, const FitChoice& fits = {}, const StopToken& stop = {});

/// Reads a product: a scenario with its object at the start, a STEP file, an assembly in one (product.step:pump), or a
/// URDF file; each body about the middle of its box. `deflection`: metres that a plan states for STEP parts, 0:
/// nothing. Parts are read with the usual deflection where what is stated is coarser: a plan cannot choose how coarsely
/// it is judged.
Result<Product> readProduct(const std::string& file, double deflection, const FitChoice& fits = {},
                            const StopToken& stop = {}, const PartChoice& choice = {});

/// Takes away the bodies that a person means by the names, and what is said of their fits; the option --without. A
/// warning says which. A plan cannot ask for that. Errors: as of bodiesMeant().
Outcome leaveOut(const std::vector<std::string>& names, Product& product);

}  // namespace glissade::check
