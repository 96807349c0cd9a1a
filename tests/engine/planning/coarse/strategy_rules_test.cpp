#include "engine/planning/coarse/strategy_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/planning/planner.h"

namespace glissade {
namespace {

using testing::HasSubstr;

std::vector<std::string> locals() {
  std::vector<std::string> ids;
  const PlannerRegistry registry = makeLocalPlannerRegistry();
  for (const PlannerEntry& entry : registry.entries()) ids.push_back(entry.id);
  return ids;
}

StrategyRules sound() {
  return {"0", "distance", {{"place.cluttered", true, "rrt"}, {"1", false, "linear"}}, false, false};
}

TEST(StrategyRules, EveryPresetParses) {
  for (const char* strategy : {"gt", "gts1", "gts2", "gts"}) {
    const StrategyRules rules = presetRules(strategy);
    const auto parsed = parseRules(rules, AttributeTable(), locals());
    ASSERT_TRUE(parsed.ok()) << strategy << ": " << toString(parsed.error());
    EXPECT_EQ(parsed->fine.size(), rules.fine.size());
    EXPECT_EQ(parsed->loop, std::string(strategy) == "gts");
    EXPECT_EQ(parsed->edge.text(), "distance");
  }
  EXPECT_FALSE(presetRules("gts1") == presetRules("gts2"));
}

TEST(StrategyRules, EachFaultIsNamedWithItsPlace) {
  struct Row {
    void (*spoil)(StrategyRules&);
    const char* place;
    const char* reason;
  };
  const std::vector<Row> rows{
      {[](StrategyRules& r) { r.node = "distance"; }, "/rules/node, column 1", "unknown"},
      {[](StrategyRules& r) { r.node = "place.complexity"; }, "/rules/node, column 1", "unknown"},
      {[](StrategyRules& r) { r.node = "1 + a.colour"; }, "/rules/node, column 5", "'a.colour' is unknown"},
      {[](StrategyRules& r) { r.node = "a.mobility == \"static\""; }, "/rules/node, column 1", "unknown"},
      {[](StrategyRules& r) { r.edge = "distance *"; }, "/rules/edge, column 11", "ends too early"},
      {[](StrategyRules& r) { r.edge = "a.complexity"; }, "/rules/edge, column 1", "unknown"},
      {[](StrategyRules& r) { r.edge = "object.complexity"; }, "/rules/edge, column 1", "unknown"},
      {[](StrategyRules& r) { r.edge = "speed"; }, "/rules/edge, column 1", "'speed' is unknown"},
      {[](StrategyRules& r) { r.edge = "distance * place.shape"; }, "/rules/edge, column 12", "'place.shape', a text"},
      {[](StrategyRules& r) { r.node = "object.mobility"; }, "/rules/node, column 1", "'object.mobility', a text"},
      {[](StrategyRules& r) { r.fine[0].when = "place.shape"; }, "/rules/fine/0/when, column 1", "a text"},
      {[](StrategyRules& r) { r.fine[0].when = "place."; }, "/rules/fine/0/when, column 1", "unknown"},
      {[](StrategyRules& r) { r.fine[1].local = "prm"; }, "/rules/fine/1/local", "no local planner 'prm'"},
      {[](StrategyRules& r) { r.fine[0].local = "gts"; }, "/rules/fine/0/local", "no local planner 'gts'"},
      {[](StrategyRules& r) { r.fine.pop_back(); }, "/rules/fine", "no last rule"},
      {[](StrategyRules& r) { r.fine.clear(); }, "/rules/fine", "no last rule"},
  };
  ASSERT_TRUE(parseRules(sound(), AttributeTable(), locals()).ok());
  for (const Row& row : rows) {
    StrategyRules rules = sound();
    row.spoil(rules);
    const auto parsed = parseRules(rules, AttributeTable(), locals());
    ASSERT_FALSE(parsed.ok()) << row.place << " " << row.reason;
    EXPECT_EQ(parsed.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(toString(parsed.error().location), row.place);
    EXPECT_THAT(toString(parsed.error().reason), HasSubstr(row.reason));
  }
}

TEST(StrategyRules, KnowTheUsersOwnAttributes) {
  AttributeTable table;
  AttributeDefinition danger;
  danger.name = "danger";
  danger.type = AttributeType::Number;
  danger.initial = 0.0;
  StrategyRules rules = sound();
  rules.edge = "distance * (1 + place.danger)";
  rules.node = "max(a.danger, b.danger)";
  EXPECT_FALSE(parseRules(rules, table, locals()).ok());
  ASSERT_TRUE(table.add(danger));
  EXPECT_TRUE(parseRules(rules, table, locals()).ok());
}

}  // namespace
}  // namespace glissade
