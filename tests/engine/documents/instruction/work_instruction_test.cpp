#include "engine/documents/instruction/work_instruction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "engine/documents/instruction/instruction_layout.h"
#include "engine/documents/instruction/instruction_words.h"
#include "tests/engine/documents/instruction/instructed_products.h"

namespace glissade {
namespace {

using test::InstructedProduct;

TEST(WorkInstruction, EachStepIsInOnePanelWithItsNumberInThePlan) {
  InstructedProduct made = test::blocksOnABase(7);
  for (const std::size_t step : {1U, 2U, 3U}) made.plan.steps[step].task = 4;
  const WorkInstruction instruction = test::instructed(made);
  std::map<BodyId, int> seen;
  std::vector<std::string> numbers;
  for (const InstructionPanel& panel : instruction.panels) {
    numbers.push_back(panel.number);
    for (const AssemblyStep& step : panel.steps) ++seen[step.only().body];
  }
  EXPECT_EQ(numbers, (std::vector<std::string>{"", "1", "2", "3", "4–6", "7"}));
  EXPECT_EQ(seen.size(), 7U);
  for (const auto& [body, times] : seen) EXPECT_EQ(times, 1) << body;
  EXPECT_EQ(instruction.panels[1].steps.front().only().body, "block0") << "in the order of assembly";
  EXPECT_EQ(instruction.panels[4].work, "Place block3, block4, block5.");
}

TEST(WorkInstruction, WhatIsThereGrowsByWhatComes) {
  const WorkInstruction instruction = test::instructed(test::blocksOnABase(3));
  ASSERT_EQ(instruction.panels.size(), 4U);
  EXPECT_EQ(instruction.panels[0].present, std::vector<BodyId>{"base"});
  EXPECT_EQ(instruction.panels[0].work, "Put base on the bench.");
  EXPECT_EQ(instruction.panels[3].present, (std::vector<BodyId>{"base", "block0", "block1"}));
}

TEST(WorkInstruction, AlikePartsAreFetchedTogetherWithTheirCount) {
  InstructedProduct made = test::blocksOnABase(4);
  for (std::size_t i = 0; i < 4; ++i) {
    made.plan.steps[i].task = 1;
    StepJoint screw{JointKind::Screw, made.plan.steps[i].only().body, {"base"}, {"base"}};
    screw.designation = "ISO 4762 M3x8";
    screw.drive = DriveKind::HexSocket;
    screw.driveSize = 0.0025;
    made.plan.steps[i].only().joints = {screw};
    made.plan.steps[i].only().tool = {ToolKind::HexKey, ToolAccess::Blocked, {"base"}};
    made.plan.steps[i].only().falling = {"base"};
  }
  const WorkInstruction instruction = test::instructed(made);
  ASSERT_EQ(instruction.panels.size(), 2U);
  const InstructionPanel& panel = instruction.panels[1];
  ASSERT_EQ(panel.fetched.size(), 1U);
  EXPECT_EQ(panel.fetched[0].count, 4U);
  EXPECT_EQ(panel.work, "Screw in 4 × ISO 4762 M3x8.");
  EXPECT_EQ(panel.tool, "Hex key 2.5");
  EXPECT_EQ(panel.notes,
            (std::vector<std::string>{"Start all by hand, then tighten crosswise.", "Needs support: base"}))
      << "each once";
  EXPECT_EQ(instruction.tools, std::vector<std::string>{"Hex key 2.5"});
  EXPECT_EQ(instruction.parts.size(), 2U) << "base, and one row for the screws";
}

TEST(WorkInstruction, OnlyThreeScrewsThatClampOnePartAreTightenedCrosswise) {
  InstructedProduct made = test::blocksOnABase(5);
  for (std::size_t i = 0; i < 4; ++i) {
    made.plan.steps[i].task = 1;
    made.plan.steps[i].only().joints = {{JointKind::Screw, made.plan.steps[i].only().body, {"base"}}};
  }
  EXPECT_TRUE(test::instructed(made).panels.back().notes.empty()) << "nothing is clamped";
  for (std::size_t i = 0; i < 2; ++i) made.plan.steps[i].only().joints[0].clamped = {"block0"};
  for (std::size_t i = 2; i < 4; ++i) made.plan.steps[i].only().joints[0].clamped = {"base"};
  EXPECT_TRUE(test::instructed(made).panels.back().notes.empty()) << "two screws a part";
  made.plan.steps[2].only().joints[0].clamped = {"block0"};
  EXPECT_FALSE(test::instructed(made).panels.back().notes.empty());
}

/// Nothing but the number says where the nut ends.
TEST(WorkInstruction, ANutThatClampsNothingHasItsTurnsAndItsHeightOnTheRod) {
  InstructedProduct made;
  for (const double height : {0.0, 0.45}) {
    made.product = test::productOf({boxBody("rod", {0.1, 0.1, 1.0}, Pose::identity()),
                                    boxBody("nut", {0.2, 0.2, 0.1}, Pose::translation({0.0, 0.0, height}))});
    made.plan = {};
    made.plan.bodies = {"rod", "nut"};
    made.plan.staying = {"rod"};
    made.plan.steps = {test::stepAlong("nut", Vector3::UnitZ())};
    StepJoint& joint = made.plan.steps[0].only().joints.emplace_back();
    joint = {JointKind::Nut, "nut", {"rod"}};
    joint.turns = 10.0;
    EXPECT_EQ(test::instructed(made).panels.back().notes.front(),
              height > 0.0 ? "nut: 10.0 turns, until flush with the end of rod."
                           : "nut: 10.0 turns, until 450 mm of rod stick out.");
  }
  made.plan.steps[0].only().joints[0].clamped = {"rod"};
  EXPECT_TRUE(test::instructed(made).panels.back().notes.empty()) << "it is tightened";
}

TEST(WorkInstruction, TwoNutsOfOneSizeNeedTheSameToolTwice) {
  InstructedProduct made;
  made.product = test::productOf({boxBody("rod", {0.1, 0.1, 1.0}, Pose::identity()),
                                  boxBody("nut-1", {0.2, 0.2, 0.1}, Pose::translation({0.0, 0.0, 0.3})),
                                  boxBody("nut-2", {0.2, 0.2, 0.1}, Pose::translation({0.0, 0.0, -0.3}))});
  made.plan.bodies = {"rod", "nut-1", "nut-2"};
  made.plan.staying = {"rod", "nut-2"};
  made.plan.steps = {test::stepAlong("nut-1", Vector3::UnitZ())};
  StepMotion& motion = made.plan.steps[0].only();
  motion.tool.kind = motion.tool.heldWith = ToolKind::OpenWrench;
  motion.tool.held = "nut-2";
  const WorkInstruction instruction = test::instructed(made);
  EXPECT_EQ(instruction.panels.back().notes.front(), "Hold the other nut with a second open wrench.");
  EXPECT_EQ(instruction.tools, std::vector<std::string>{"2 × Open wrench"});
}

TEST(WorkInstruction, TheCoverCountsThePartsThatComeAsTheWindowDoes) {
  const WorkInstruction instruction = test::instructed(test::blocksOnABase(3));
  EXPECT_EQ(extentText(instruction, DocumentWords(Language::English)), "3 parts + base, 3 steps");
}

TEST(WorkInstruction, AGroupIsPutTogetherBeforeItIsPutOn) {
  InstructedProduct made = test::blocksOnABase(2);
  AssemblyStep group = made.plan.steps[1];
  group.only().with = {"block1"};
  made.plan.lines.push_back({1, {"block0", "block1"}, {"block0"}, {made.plan.steps[0]}});
  made.plan.steps = {group};
  const WorkInstruction instruction = test::instructed(made);
  std::vector<std::string> numbers;
  for (const InstructionPanel& panel : instruction.panels) numbers.push_back(panel.number + "/" + panel.subassembly);
  EXPECT_EQ(numbers, (std::vector<std::string>{"/", "/1", "1.1/1", "1/"}));
  EXPECT_EQ(instruction.panels[2].present, std::vector<BodyId>{"block0"});
  EXPECT_EQ(instruction.panels[3].work, "Place subassembly 1.");
  EXPECT_EQ(instruction.panels[3].fetched[0].bodies.size(), 2U) << "the group is drawn";
}

/// Bolt first, then the nut: one panel with the tool that tightens it.
TEST(WorkInstruction, AFastenerStackIsOneStep) {
  InstructedProduct made = test::blocksOnABase(2);
  StepMotion nut = made.plan.steps[0].only();
  nut.joints = {{JointKind::Nut, "block1", {"block0"}}};
  nut.tool.kind = ToolKind::Socket;
  nut.tool.held = "block0";
  nut.tool.heldWith = ToolKind::HexKey;
  nut.falling = {"block0"};
  StepMotion bolt = made.plan.steps[1].only();
  bolt.allowances.front().kind = ContactKind::Cylindrical;
  made.plan.steps = {{{nut, bolt}, 1}};
  const WorkInstruction instruction = test::instructed(made);
  ASSERT_EQ(instruction.panels.size(), 2U);
  const InstructionPanel& panel = instruction.panels[1];
  EXPECT_EQ(panel.number, "1");
  EXPECT_EQ(panel.work, "Insert block0. Screw on block1.");
  EXPECT_EQ(panel.tool, "Socket");
  EXPECT_EQ(panel.notes, std::vector<std::string>{"Hold block0 (hex key)."}) << "no support: it is of the step itself";
  EXPECT_EQ(instruction.steps, 1U);
}

/// The last block comes from below.
TEST(WorkInstruction, PartsWithoutAStepAreNamedOnTheCoverAndAtTheStart) {
  InstructedProduct made = test::blocksOnABase(3);
  EXPECT_EQ(test::instructed(made).incomplete, "");
  made.plan.steps.pop_back();  // a time limit ends a plan so
  const WorkInstruction instruction = test::instructed(made);
  EXPECT_EQ(instruction.incomplete, "Incomplete: the plan has no step for block0.");
  EXPECT_EQ(instruction.panels.front().notes, std::vector<std::string>{instruction.incomplete});
}

/// Several overlaps of a pair are one entry.
TEST(WorkInstruction, AcceptedClashesAreOnTheCover) {
  InstructedProduct made = test::blocksOnABase(3);
  EXPECT_TRUE(test::instructed(made).statements.empty());
  const Allowance shallow{"base", ContactKind::Clash, 0.0004};
  const Allowance deep{"base", ContactKind::Clash, 0.0005};
  made.plan.steps[0].only().allowances = {shallow};
  made.plan.steps[1].only().allowances = {deep, shallow};
  made.plan.steps[2].only().allowances = {{"base", ContactKind::Planar, 0.0}};
  const WorkInstruction instruction = test::instructed(made);
  ASSERT_EQ(instruction.statements.size(), 1U);
  EXPECT_EQ(instruction.statements[0], "Accepted clashes: base / block1, 0.5 mm · base / block2, 0.4 mm");
  made.plan.steps[0].only().allowances[0].hollow = true;
  made.plan.steps[1].only().allowances[0].hollow = made.plan.steps[1].only().allowances[0].yields = true;
  EXPECT_EQ(test::instructed(made).statements.front(),
            "Accepted clashes: base / block1, 0.5 mm (cut: base) · base / block2, 0.4 mm (cut: block2)");
  const auto pages = instructionPages(instruction, {}, Paper::A4);
  const auto& texts = pages.front().texts;
  EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [&](const PageText& each) {
    return each.text == instruction.statements[0] && each.rect.bottom() < pages.front().pictures.front().rect.y + 1e-9;
  })) << "above the picture";
}

TEST(WorkInstruction, ExcludedPartsPartsBesideAndTheDateAreOnTheCover) {
  InstructedProduct made = test::blocksOnABase(3);
  made.plan.isolated = {"block1"};
  const WorkInstruction instruction = workInstruction(
      made.plan, made.product, {"stand", "1 May 2026", {"cover", "cover#2"}}, test::wordsIn(Language::English));
  EXPECT_EQ(instruction.statements, (std::vector<std::string>{"Touches nothing and may lie beside the product: block1.",
                                                              "Excluded, without a step: cover, cover#2"}));
  const auto pages = instructionPages(instruction, {}, Paper::A4);
  std::string all;
  for (const PageText& each : pages.front().texts) all += each.text + "\n";
  for (const std::string& statement : instruction.statements) EXPECT_NE(all.find(statement), std::string::npos);
  EXPECT_NE(all.find("1 May 2026"), std::string::npos);
}

/// The first block of the product comes last.
TEST(WorkInstruction, PartsAreListedInTheOrderOfTheirUse) {
  InstructedProduct made = test::blocksOnABase(3);
  std::reverse(made.plan.steps.begin(), made.plan.steps.end());
  std::vector<std::size_t> firstSteps;
  for (const PartsListRow& row : partsList(made.plan, made.product)) {
    firstSteps.push_back(row.hasBase ? 0 : row.steps.front());
  }
  EXPECT_EQ(firstSteps, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(WorkInstruction, EachStepOfThePlanHasTheViewOfItsPanel) {
  InstructedProduct made = test::blocksOnABase(3);
  made.plan.steps.back() = test::stepAlong("block0", -Vector3::UnitZ());
  const WorkInstruction instruction = test::instructed(made);
  const std::vector<Viewpoint> views = viewsOfSteps(instruction, made.plan);
  ASSERT_EQ(views.size(), made.plan.steps.size());
  for (const InstructionPanel& panel : instruction.panels) {
    for (const AssemblyStep& step : panel.steps) {
      for (std::size_t i = 0; i < views.size(); ++i) {
        if (made.plan.steps[i].bodies() != step.bodies()) continue;
        EXPECT_EQ(views[i], panel.view);
      }
    }
  }
}

TEST(WorkInstruction, APartThatFallsOutWhenTheProductIsTurnedOverIsNamed) {
  InstructedProduct made = test::blocksOnABase(3);
  const auto block2 = made.product.indexOf("block2");
  made.product.bodies[block2].X_WB = Pose::translation({0.2, 0.0, -0.125});
  made.plan.steps[0] = test::stepAlong("block2", -Vector3::UnitZ());
  const auto turned = [](const WorkInstruction& instruction) {
    for (const InstructionPanel& panel : instruction.panels) {
      if (panel.view.turnedOver) return panel;
    }
    return InstructionPanel();
  };
  const InstructionPanel panel = turned(test::instructed(made));
  ASSERT_FALSE(panel.turn.empty());
  EXPECT_EQ(panel.notes, std::vector<std::string>{"Hold while you turn it over: block0, block1"});

  made.plan.steps[1].only().joints = {{JointKind::Screw, "block1", {"base"}}};
  EXPECT_EQ(turned(test::instructed(made)).notes, std::vector<std::string>{"Hold while you turn it over: block0"});
  made.plan.steps[2].after = {2};
  EXPECT_TRUE(turned(test::instructed(made)).notes.empty()) << "block1 keeps it";
  made.plan.steps[2].after = {1};
  EXPECT_EQ(turned(test::instructed(made)).notes.size(), 1U) << "what comes now does not keep it yet";
}

TEST(WorkInstruction, HasNoWordOfTheCertificate) {
  for (const Language language : {Language::English, Language::French}) {
    for (const std::string& text : test::textsOf(test::instructed(test::blocksOnABase(5), language))) {
      for (const char* word :
           {"straight", "certif", "clearance", "jeu", "allowance", "mm", "proved", "blocked", "thinner", "check"}) {
        EXPECT_EQ(text.find(word), std::string::npos) << text;
      }
    }
  }
}

TEST(WorkInstruction, IsWhollyInFrench) {
  const DocumentWords french(Language::French);
  const AssemblyStep step = test::stepAlong("block", Vector3::UnitZ());
  EXPECT_EQ(workSentence(step.only(), "block", french), "Placer block.");
  EXPECT_EQ(test::instructed(test::blocksOnABase(1), Language::French).panels[0].work, "Poser base sur l'établi.");
}

TEST(InstructionWords, ASentenceHasTheVerbOfTheJoint) {
  const DocumentWords english;
  AssemblyStep step = test::stepAlong("block", Vector3::UnitZ());
  const auto sentence = [&](JointKind kind, const BodyId& body) {
    step.only().joints = {{kind, body, {}}};
    return workSentence(step.only(), "x", english);
  };
  EXPECT_EQ(sentence(JointKind::Screw, "block"), "Screw in x.");
  EXPECT_EQ(sentence(JointKind::Nut, "block"), "Screw on x.");
  EXPECT_EQ(sentence(JointKind::Nut, "rod"), "Screw in x.") << "a shaft into a nut";
  EXPECT_EQ(sentence(JointKind::Insert, "block"), "Press in x.");
  EXPECT_EQ(sentence(JointKind::Unit, "block"), "Place x.");
  step.only().joints.clear();
  step.only().fastener = FastenerKind::Screw;
  EXPECT_EQ(workSentence(step.only(), "x", english), "Place x.") << "a bolt whose nut is turned";
  step.only().tool.kind = ToolKind::HexKey;
  EXPECT_EQ(workSentence(step.only(), "x", english), "Screw in x.");
  step.only().fastener = FastenerKind::Nut;
  EXPECT_EQ(workSentence(step.only(), "x", english), "Screw on x.");
  step.only().fastener = FastenerKind::None;
  step.only().allowances.push_back({"base", ContactKind::Cylindrical, 0.0, 1e-5, {}});
  EXPECT_EQ(workSentence(step.only(), "x", english), "Insert x.");
  step.only().path.back().q.orientation = fromRollPitchYaw(0.0, 0.0, 1.0);
  EXPECT_EQ(workSentence(step.only(), "x", english), "Turn in x.");
}

TEST(InstructionWords, TurnsOfTheProductAreSaid) {
  const DocumentWords english;
  const auto turn = [&](const Viewpoint& from, const Viewpoint& to) { return turnSentence(from, to, english); };
  EXPECT_EQ(turn({0, false}, {0, false}), "");
  EXPECT_EQ(turn({0, false}, {0, true}), "Turn the product over.");
  EXPECT_EQ(turn({0, false}, {1, false}), "Turn the product to the left.");
  EXPECT_EQ(turn({3, false}, {0, false}), "Turn the product to the left.") << "quarters go round";
  EXPECT_EQ(turn({1, false}, {0, false}), "Turn the product to the right.");
  EXPECT_EQ(turn({0, true}, {1, true}), "Turn the product to the right.") << "it lies upside down";
  EXPECT_EQ(turn({0, false}, {2, false}), "Turn the product by half a turn.");
}

/// The viewpoint and the up direction are consistent with the sentence: the turn in it leads from one viewpoint to the
/// other.
TEST(InstructionWords, ATurnToTheLeftTakesTheFrontToTheLeft) {
  for (const bool over : {false, true}) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Viewpoint from{quarter, over};
      const Viewpoint to{(quarter + 1) % 4, over};
      const Vector3 front = (from.toEye() - from.toEye().z() * Vector3::UnitZ()).normalized();
      const Vector3 right = to.up().cross(to.toEye());
      const bool goesLeft = front.dot(right) < 0.0;
      EXPECT_EQ(turnSentence(from, to, {}),
                goesLeft ? "Turn the product to the left." : "Turn the product to the right.");
    }
  }
}

TEST(InstructionWords, TheFirstLetterIsACapitalOne) {
  EXPECT_EQ(capitalized("hex key"), "Hex key");
  EXPECT_EQ(capitalized("écrou"), "Écrou");
  EXPECT_EQ(capitalized("M3"), "M3");
  EXPECT_EQ(capitalized(""), "");
}

}  // namespace
}  // namespace glissade
