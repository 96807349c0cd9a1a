#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/places/attribute.h"
#include "engine/planning/coarse/expression.h"

namespace glissade {

/// Chooses the planners that cross a place: the first rule whose condition holds decides.
struct FineRule {
  std::string when;          ///< expression over distance, size, place.*, object.*
  bool geometrical = false;  ///< the geometrical planner runs first, and the local planner stays in its region
  std::string local;         ///< id in the local planner registry

  friend bool operator==(const FineRule&, const FineRule&) = default;
};

/// The rules that control a run of the semantic planner. A user can read and change them (paper 2, section 4).
struct StrategyRules {
  std::string node;  ///< f of equation (1): expression over size, a.*, b.* (the places that meet), object.*
  std::string edge;  ///< g of equation (1): expression over distance, size, place.*, object.*
  std::vector<FineRule> fine;
  bool loop = false;    ///< after a failed step its cost is raised and the next best coarse path is tried
  bool fitted = false;  ///< passages are crossed in the configuration that fits best, where there is one

  friend bool operator==(const StrategyRules&, const StrategyRules&) = default;
};

/// The rules of "gt", "gts1", "gts2" (paper 2, sections 6.1 and 6.2) and "gts" (with the extensions that its conclusion
/// proposes). Precondition: one of these.
StrategyRules presetRules(std::string_view strategy);

/// The rules, parsed and checked against the existing attributes.
struct ParsedRules {
  struct Fine {
    Expression when;
    bool geometrical;
    std::string local;
  };
  Expression node;
  Expression edge;
  std::vector<Fine> fine;
  bool loop;
  bool fitted;
};
/// MalformedInput with a JSON pointer as place ("/rules/edge") where a rule does not parse, a name or a local planner
/// is unknown, or no rule is left for some place (the condition of the last rule must be "1").
Result<ParsedRules> parseRules(const StrategyRules& rules, const AttributeTable& table,
                               const std::vector<std::string>& localPlanners);

}  // namespace glissade
