#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/base/message.h"
#include "engine/check/path_verdict.h"
#include "engine/check/plan_verdict.h"

namespace glissade::check {

// Reports of a verdict for people and, in English, for programs. `edges`: includes every edge of the path.

std::string reportText(const PathVerdict& verdict, const Question& question, bool edges,
                       const MessageStyle& style = {});
nlohmann::ordered_json reportJson(const PathVerdict& verdict, const Question& question, bool edges);

std::string reportText(const PlanVerdict& verdict, const Product& product, const MessageStyle& style = {});
nlohmann::ordered_json reportJson(const PlanVerdict& verdict, const Product& product);

/// The reason why a motion is not valid; empty if it is valid.
Message whyInvalid(const StepVerdict& step, const Product& product);
/// The reasons why the motions of the plan's step with this number are not valid; empty if it is valid.
Message whyInvalid(const PlanVerdict& verdict, std::size_t step, const Product& product);

}  // namespace glissade::check
