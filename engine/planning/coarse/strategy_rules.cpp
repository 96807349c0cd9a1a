#include "engine/planning/coarse/strategy_rules.h"

#include <algorithm>

namespace glissade {
namespace {

/// Cost per level of complexity above the first, of each border of a place: a tenth of the workspace.
constexpr const char* kEasiest = "0.1 * size * (max(a.complexity, b.complexity) - 1)";

const std::vector<FineRule>& paperFineRules() {
  static const std::vector<FineRule> rules{{"place.cluttered or place.complexity > 2", true, "rrt"},
                                           {"1", false, "linear"}};
  return rules;
}

}  // namespace

StrategyRules presetRules(std::string_view strategy) {
  StrategyRules rules;
  rules.node = "0";
  rules.edge = "distance";
  if (strategy == "gt") {
    rules.fine = {{"1", false, "rrt"}};
  } else if (strategy == "gts1") {
    // Only holes and objects of the same shape go together; where no hole has the shape, the shortest way is chosen.
    rules.node = std::string("if((a.shape != \"\" and a.shape != object.shape) or ") +
                 "(b.shape != \"\" and b.shape != object.shape), 10 * size, " + kEasiest + ")";
    rules.fine = paperFineRules();
  } else if (strategy == "gts2") {
    rules.node = std::string("if(min(a.compatibility, b.compatibility) < 0.5, 10 * size, ") + kEasiest + ")";
    rules.fine = paperFineRules();
  } else {
    rules.node = std::string("2 * size * (1 - min(a.compatibility, b.compatibility)) + 0.5 * ") + kEasiest;
    rules.fine = {{"place.cluttered or place.complexity > 2", true, "contact-birrt"}, {"1", false, "linear"}};
    rules.loop = true;
    rules.fitted = true;
  }
  return rules;
}

namespace {

/// Names of the form "<prefix>.<attribute>", and plain ones, which are numbers.
class KnownNames {
 public:
  KnownNames(const AttributeTable& table, std::vector<std::string> plain, std::vector<std::string> placePrefixes)
      : table_(table), plain_(std::move(plain)), placePrefixes_(std::move(placePrefixes)) {}

  std::optional<RuleType> operator()(const std::string& name) const {
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos) return has(plain_, name) ? std::make_optional(RuleType::Number) : std::nullopt;
    const std::string prefix = name.substr(0, dot);
    if (prefix != "object" && !has(placePrefixes_, prefix)) return std::nullopt;
    const auto owner = prefix == "object" ? AttributeOwner::Body : AttributeOwner::Place;
    const AttributeDefinition* attribute = table_.find(owner, name.substr(dot + 1));
    if (attribute == nullptr) return std::nullopt;
    const bool text = attribute->type == AttributeType::Text || attribute->type == AttributeType::Choice;
    return text ? RuleType::Text : RuleType::Number;
  }

 private:
  static bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  const AttributeTable& table_;
  std::vector<std::string> plain_;
  std::vector<std::string> placePrefixes_;
};

Diagnostic at(const std::string& pointer, Diagnostic why) {
  why.location = why.location.empty() ? Message(pointer) : Message(GLISSADE_TEXT("%1, %2"), {pointer, why.location});
  return why;
}

}  // namespace

Result<ParsedRules> parseRules(const StrategyRules& rules, const AttributeTable& table,
                               const std::vector<std::string>& localPlanners) {
  auto node = Expression::parse(rules.node, KnownNames(table, {"size"}, {"a", "b"}));
  if (!node) return at("/rules/node", node.error());
  const KnownNames ofPlace(table, {"size", "distance"}, {"place"});
  auto edge = Expression::parse(rules.edge, ofPlace);
  if (!edge) return at("/rules/edge", edge.error());
  std::vector<ParsedRules::Fine> fine;
  for (std::size_t i = 0; i < rules.fine.size(); ++i) {
    const std::string pointer = "/rules/fine/" + std::to_string(i);
    auto when = Expression::parse(rules.fine[i].when, ofPlace);
    if (!when) return at(pointer + "/when", when.error());
    const std::string& local = rules.fine[i].local;
    if (std::find(localPlanners.begin(), localPlanners.end(), local) == localPlanners.end()) {
      std::string known;
      for (const std::string& id : localPlanners) known += (known.empty() ? "" : ", ") + id;
      return Diagnostic{ErrorKind::MalformedInput,
                        "",
                        pointer + "/local",
                        {GLISSADE_TEXT("there is no local planner '%1'"), {local}},
                        {GLISSADE_TEXT("Give one of %1."), {known}}};
    }
    fine.push_back({std::move(*when), rules.fine[i].geometrical, local});
  }
  if (fine.empty() || fine.back().when.text() != "1") {
    return Diagnostic{ErrorKind::MalformedInput, "", "/rules/fine", GLISSADE_TEXT("has no last rule that always holds"),
                      GLISSADE_TEXT("End it with {\"when\": \"1\", ...}.")};
  }
  return ParsedRules{std::move(*node), std::move(*edge), std::move(fine), rules.loop, rules.fitted};
}

}  // namespace glissade
