// Carries out the recipe "Add a message, with its French".
#include <gtest/gtest.h>

#include "engine/base/parameters.h"
#include "engine/files/path_exporter.h"
#include "engine/operator/device_registry.h"
#include "engine/places/attribute.h"
#include "engine/planning/planner.h"

namespace glissade {
namespace {

TEST(MessageRecipe, TheTextOfTheRecipeIsReadInBothLanguages) {
  const std::string name = "plate";
  const Message message{GLISSADE_TEXT("the object penetrates '%1'"), {name}};
  EXPECT_EQ(toString(message), "the object penetrates 'plate'");
  const std::string french = toString(message, Language::French);
  EXPECT_NE(french, toString(message));
  EXPECT_NE(french.find("plate"), std::string::npos);
}

TEST(MessageRecipe, TheReaderChoosesTheUnitAndTheFormOfTheWord) {
  const Message inside{GLISSADE_TEXT("turn out of %1, %2 {2|turn|turns}"), {Length{0.002}, 1}};
  const Message outside{GLISSADE_TEXT("%1 {1|turn|turns} out, then %2"), {2, inside}};
  MessageStyle style;
  style.length = [](double metres) { return std::to_string(static_cast<int>(1e6 * metres)) + " um"; };
  EXPECT_EQ(toString(outside, style), "2 turns out, then turn out of 2000 um, 1 turn");
}

void expectFrench(const Message& text, const std::string& where) {
  EXPECT_TRUE(text.empty() || hasFrench(text.text)) << where << " has no French: " << text.text;
}

/// A text of a table that is made without GLISSADE_TEXT has no French, and fails here.
TEST(MessageRecipe, EveryEntryOfATableHasFrench) {
  for (const auto make : {makePlannerRegistry, makeLocalPlannerRegistry}) {
    const PlannerRegistry registry = make();
    for (const PlannerEntry& entry : registry.entries()) {
      expectFrench(entry.label, entry.id);
      expectFrench(entry.description, entry.id);
    }
  }
  const DeviceRegistry devices = makeDeviceRegistry();
  for (const DeviceEntry& entry : devices.entries()) {
    expectFrench(entry.label, entry.id);
    expectFrench(entry.description, entry.id);
  }
  const PathExporterRegistry exporters = makePathExporterRegistry();
  for (const PathExporter& exporter : exporters.entries()) expectFrench(exporter.label, exporter.id);
  const AttributeTable attributes;
  for (const AttributeDefinition& definition : attributes.definitions()) {
    expectFrench(definition.label, definition.name);
    expectFrench(definition.description, definition.name);
  }
  for (const ParameterSpec& spec : parameterTable()) {
    expectFrench(spec.label, std::string(spec.key));
    expectFrench(spec.help, std::string(spec.key));
  }
}

}  // namespace
}  // namespace glissade
