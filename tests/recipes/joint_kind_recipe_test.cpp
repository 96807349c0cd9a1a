// Checks the places of the recipe "Add a joint kind" for every kind that exists.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "engine/check/stated_json.h"
#include "engine/documents/instruction/instruction_words.h"
#include "engine/documents/plan_words.h"
#include "engine/files/joints_json.h"
#include "engine/files/judged_product.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/temporary_folder.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

std::vector<JointKind> allJointKinds() {
  std::vector<JointKind> kinds;
  for (const char* name : kJointKindNames.names) kinds.push_back(*kJointKindNames.find(name));
  return kinds;
}

/// Adds every enumeration of a schema that has the value.
void findEnumerations(const nlohmann::json& schema, const std::string& value,
                      std::vector<std::vector<std::string>>& found) {
  if (schema.is_object() && schema.contains("enum")) {
    std::vector<std::string> names;
    for (const auto& each : schema.at("enum")) names.push_back(each.is_string() ? each.get<std::string>() : "");
    if (std::find(names.begin(), names.end(), value) != names.end()) found.push_back(names);
  }
  if (!schema.is_structured()) return;
  for (const auto& each : schema) findEnumerations(each, value, found);
}

TEST(JointKindRecipe, TheSchemasHaveTheNames) {
  const std::vector<std::string> names(kJointKindNames.names.begin(), kJointKindNames.names.end());
  for (const char* name : {"joints-1", "scenario-1", "plan-2"}) {
    const std::string file = test::sourceDirectory() + "/resources/schema/" + name + ".schema.json";
    std::vector<std::vector<std::string>> found;
    findEnumerations(nlohmann::json::parse(test::readWhole(file)), "permanent", found);
    EXPECT_FALSE(found.empty()) << name;
    for (const auto& enumeration : found) EXPECT_EQ(enumeration, names) << name;
  }
}

/// A step that works on a joint of this kind.
AssemblyStep stepWith(JointKind kind) {
  AssemblyStep step{{StepMotion()}};
  step.only().body = "part";
  step.only().path = {{Pose::identity()}, {Pose::translation({1.0, 0.0, 0.0})}};
  StepJoint joint;
  joint.kind = kind;
  joint.body = "part";
  joint.others = {"host"};
  joint.turns = 3.0;
  joint.bend = 0.001;
  step.only().joints = {joint};
  return step;
}

/// No step works on joints that do not come apart.
bool comesApart(JointKind kind) { return kind != JointKind::Permanent && kind != JointKind::Unit; }

TEST(JointKindRecipe, ReportAndInstructionHaveTheirWordsInBothLanguages) {
  AssembledProduct product;
  product.bodies = {boxBody("part", {1.0, 1.0, 1.0}, {}), boxBody("host", {1.0, 1.0, 1.0}, {})};
  const auto length = [](double metres) { return std::to_string(metres); };
  const PlanWords english(Language::English, length);
  const PlanWords french(Language::French, length);
  const AssemblyStep without = [] {
    AssemblyStep step = stepWith(JointKind::Pin);
    step.only().joints.clear();
    return step;
  }();
  for (const JointKind kind : allJointKinds()) {
    const char* name = kJointKindNames.of(kind);
    const AssemblyStep step = stepWith(kind);
    for (const PlanOrder order : {PlanOrder::Removal, PlanOrder::Assembly}) {
      const auto words = english.joints(step.only(), product, order);
      EXPECT_EQ(words.empty(), !comesApart(kind)) << name;
      EXPECT_TRUE(words.empty() || words != french.joints(step.only(), product, order)) << name;
    }
    const std::string sentence = workSentence(step.only(), "part", Language::English);
    EXPECT_EQ(sentence == workSentence(without.only(), "part", Language::English), !comesApart(kind)) << name;
    EXPECT_NE(sentence, workSentence(step.only(), "part", Language::French)) << name;
  }
}

/// The command line once printed some names in English to a French reader.
TEST(JointKindRecipe, WindowAndCommandLineNameEveryKind) {
  for (const char* file : {"widgets/contacts/joint_texts.cpp", "app/cli/joints_command.cpp"}) {
    const std::string texts = test::readWhole(test::sourceDirectory() + "/" + file);
    for (std::string name : kJointKindNames.names) {
      EXPECT_TRUE(hasFrench(name)) << name;
      name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
      EXPECT_NE(texts.find("JointKind::" + name + ":"), std::string::npos) << file << ": " << name;
    }
  }
  for (const char* name : kJointStateNames.names) EXPECT_TRUE(hasFrench(name)) << name;
}

/// A person's word about a joint of this kind.
JointEdit editOf(JointKind kind, JointEdit::Word word) {
  JointEdit edit{{kind, "part", {"host", "lid"}}, word, {}, {}};
  if (word != JointEdit::Word::Confirmed) return edit;
  Joint made;
  made.kind = kind;
  made.state = JointState::Confirmed;
  made.bend = 0.001;
  made.thread = JointThread{0.005, 0.0008, true, 0.01, 0.01};
  edit.made = made;
  return edit;
}

using Words = std::tuple<std::vector<BodyId>, std::vector<std::vector<BodyId>>, std::set<std::string>,
                         std::set<std::string>, std::vector<std::pair<BodyId, BodyId>>>;

/// The statements about joints that the judge reads, as sorted texts.
Words toldWords(const check::JointWords& words, const std::vector<check::SnapWord>& snaps,
                const check::PartingWords& partings) {
  std::set<std::string> pitches;
  for (const auto& each : words.pitches)
    pitches.insert(each.a.text() + " " + each.b.text() + " " + std::to_string(each.pitch));
  std::set<std::string> bends;
  for (const auto& each : snaps)
    bends.insert(each.hook.text() + " " + each.edge.text() + " " + std::to_string(each.bend));
  return {words.flexible, words.units, pitches, bends, partings.pairs};
}

TEST(JointKindRecipe, TheJudgeIsToldTheSameByAFileAndByTheWindow) {
  for (const JointKind kind : allJointKinds()) {
    for (const auto word : {JointEdit::Word::Confirmed, JointEdit::Word::Dissolved}) {
      AssemblyPlan plan;
      plan.demands.joints = {editOf(kind, word)};
      const JsonCursor::Json json = JointEditsFormat().write(plan.demands.joints);
      const JsonCursor file(json, "plan.json", "/joints");
      const check::Plan window = judgedPlan(plan);
      EXPECT_EQ(toldWords(check::readJointWords(file, {}), check::readSnaps(file), check::readPartings(file, {})),
                toldWords(window.joints, window.snaps, window.partings))
          << kJointKindNames.of(kind);
    }
  }
}

}  // namespace
}  // namespace glissade
