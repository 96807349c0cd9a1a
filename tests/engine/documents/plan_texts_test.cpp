// Tests the texts about an assembly plan: words, table, graph, report.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "engine/base/quantity_text.h"
#include "engine/documents/parts_list.h"
#include "engine/documents/plan_graph.h"
#include "engine/documents/plan_report.h"
#include "engine/documents/plan_table.h"
#include "engine/documents/report_html.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

AssemblyStep stepOf(const BodyId& body, const std::vector<Pose>& way) {
  AssemblyStep step{{StepMotion()}};
  step.only().body = body;
  for (const Pose& q : way) step.only().path.push_back({q, Author::Computer});
  step.only().method = "straight";
  step.only().proof = {0, 1e-6, 2e-6, 3e-4, "cabinet"};
  return step;
}

AssemblyPlan somePlan() {
  AssemblyPlan plan;
  plan.bodies = {"drawer", "cabinet", "pin", "cap"};
  plan.staying = {"cabinet"};
  plan.steps.push_back(stepOf("cap", {Pose::identity(), Pose::translation({0.0, 0.0, 0.5})}));
  plan.steps.push_back(
      stepOf("pin", {Pose::identity(), Pose::translation({0.0, 0.0, 0.25}), Pose::translation({0.1, 0.0, 0.25})}));
  plan.steps[1].after = {1};
  plan.steps[1].only().allowances.push_back({"cabinet", ContactKind::Thread, 4e-4, 4.1e-4, Message("text")});
  plan.stuck = {{"drawer", {"cabinet"}}};
  plan.end = PlanEnd::Stuck;
  return plan;
}

PlanWords wordsIn(Language language) { return PlanWords(language, inMillimetres); }

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(PlanWords, MotionsAreToldInTheOrderThatIsAskedFor) {
  const AssemblyPlan plan = somePlan();
  const PlanWords english = wordsIn(Language::English);
  EXPECT_EQ(english.motion(plan.steps[0], PlanOrder::Removal), "up (+Z), 500 mm");
  EXPECT_EQ(english.motion(plan.steps[0], PlanOrder::Assembly), "down (−Z), 500 mm");
  EXPECT_EQ(english.motion(plan.steps[1], PlanOrder::Removal), "up (+Z), 250 mm, then +X, 100 mm");
  EXPECT_EQ(english.motion(plan.steps[1], PlanOrder::Assembly), "−X, 100 mm, then down (−Z), 250 mm");
  EXPECT_EQ(wordsIn(Language::French).motion(plan.steps[0], PlanOrder::Assembly), "bas (−Z), 500 mm");
}

TEST(PlanWords, AFastenerIsNamedByItsDesignationOrElseByTheSizeOfItsThread) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyStep step = somePlan().steps[0];
  step.only().joints.push_back({JointKind::Nut, "cap", {"pin"}});
  step.only().joints.back().turns = 2.7;
  const auto work = [&] { return wordsIn(Language::English).work(step, product, PlanOrder::Assembly); };
  EXPECT_EQ(work(), "screw on nut cap, 2.7 turns");
  step.only().joints.back().diameter = 0.009997;
  EXPECT_EQ(work(), "screw on nut M10, 2.7 turns");
  const std::string french = wordsIn(Language::French).work(step, product, PlanOrder::Assembly);
  EXPECT_NE(french.find("2,7 tours"), std::string::npos) << french;
  step.only().joints.back().designation = "ISO 4032 M10";
  EXPECT_EQ(work(), "screw on nut ISO 4032 M10, 2.7 turns");
  step.only().body = "pin";
  EXPECT_EQ(work(), "screw into cap, 2.7 turns") << "the other side is named as a part";
}

TEST(PlanWords, AToolHasTheSizeOfTheHexagonThatItTurns) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyStep step = somePlan().steps[0];
  step.only().tool.kind = ToolKind::HexKey;
  EXPECT_EQ(wordsIn(Language::English).tool(step.only(), product), "hex key");
  step.only().joints.push_back({JointKind::Screw, "cap", {"pin"}});
  step.only().joints.back().drive = DriveKind::HexSocket;
  step.only().joints.back().driveSize = 0.00249998;
  EXPECT_EQ(wordsIn(Language::English).tool(step.only(), product), "hex key 2.5");
  step.only().joints.back().driveSize = 0.014;
  EXPECT_EQ(wordsIn(Language::English).tool(step.only(), product), "hex key 14");
  step.only().joints.back().driveSize = 0.0031;
  EXPECT_EQ(wordsIn(Language::English).tool(step.only(), product), "hex key 3") << "as one buys it";
  step.only().joints.back().driveSize = 0.0047625;
  EXPECT_EQ(wordsIn(Language::English).tool(step.only(), product), "hex key 3/16″");
  step.only().joints.back().drive = DriveKind::Cross;
  EXPECT_EQ(wordsIn(Language::English).tool(step.only(), product), "hex key") << "the width of a cross is no size";
}

TEST(PlanWords, WorkIsWhatIsDoneToJointsOrElseTheMotion) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyStep step = somePlan().steps[0];
  const PlanWords english = wordsIn(Language::English);
  EXPECT_EQ(english.work(step, product, PlanOrder::Assembly), english.motion(step, PlanOrder::Assembly));
  step.only().joints.push_back({JointKind::Pin, "cap", {"pin"}});
  EXPECT_EQ(english.work(step, product, PlanOrder::Assembly), "put into pin");
}

TEST(PlanWords, TurnsAndLongWaysAreSummedUp) {
  const PlanWords english = wordsIn(Language::English);
  const Pose turned{Vector3::Zero(), fromRollPitchYaw(0.0, 0.0, std::acos(0.0))};
  EXPECT_EQ(english.motion(stepOf("cap", {Pose::identity(), turned}), PlanOrder::Removal), "turn 90° about up (+Z)");
  std::vector<Pose> way{Pose::identity()};
  for (int i = 1; i <= 6; ++i) {
    const int x = i / 2;
    way.push_back(Pose::translation({0.1 * x, 0.1 * (i - x), 0.0}));
  }
  const std::string text = english.motion(stepOf("cap", way), PlanOrder::Removal);
  EXPECT_NE(text.find("around obstacles, 600 mm"), std::string::npos) << text;
}

TEST(PlanWords, NamesAreShort) {
  EXPECT_EQ(kindOfPart("bracket-assembly#2/bolt#3"), "bolt");
  EXPECT_EQ(kindOfPart("no#one"), "no#one");
}

TEST(PlanTable, HasALineForEachStepAndEachStuckPart) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = somePlan();
  plan.steps.front().only().tool.kind = ToolKind::HexKey;
  plan.steps.front().only().falling = {"pin", "drawer", "cabinet"};
  plan.steps.front().violates = {{StepViolation::Rule::Fastener, {"pin"}}, {StepViolation::Rule::Place, {}}};
  plan.steps.back().only().tool = {ToolKind::Socket, ToolAccess::Blocked, {"drawer"}};
  const auto removal = linesOf(planAsCsv(plan, product, PlanOrder::Removal));
  ASSERT_EQ(removal.size(), 4U);
  EXPECT_EQ(removal[1],
            "2,cap,straight,\"up (+Z), 500 mm\",0.5,0,0.000002,0.0003,cabinet,0,0,,hex key,\"hold pin, drawer and 1 "
            "more\",nuts still on it: pin; constrained to another place,");
  EXPECT_NE(removal[2].find("\"socket, blocked by drawer\""), std::string::npos) << removal[2];
  EXPECT_EQ(removal[3], ",drawer,,,,,,,,,,cabinet,,,,");
  const auto assembly = linesOf(planAsCsv(somePlan(), product, PlanOrder::Assembly));
  EXPECT_EQ(assembly[2].rfind("2,cap,straight,\"down", 0), 0U) << assembly[2];
  for (const std::string& line : removal) {
    std::size_t columns = 1;
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) ++columns;
    }
    EXPECT_EQ(columns, 16U) << line;
  }
}

/// Cap and pin as one step.
AssemblyPlan planOfAStack() {
  AssemblyPlan plan = somePlan();
  plan.steps[0].motions.push_back(plan.steps[1].only());
  plan.steps.pop_back();
  plan.steps[0].motions[1].allowances.push_back({"cap", ContactKind::Planar, 0.0, 9e-4, Message("text")});
  return plan;
}

TEST(PlanTable, AStepOfSeveralMotionsHasALineForEachInTheOrder) {
  const AssembledProduct product = test::lockedDrawer();
  const auto removal = linesOf(planAsCsv(planOfAStack(), product, PlanOrder::Removal));
  ASSERT_EQ(removal.size(), 4U);
  EXPECT_EQ(removal[1].rfind("1,cap,", 0), 0U) << removal[1];
  EXPECT_EQ(removal[2].rfind("1,pin,", 0), 0U) << removal[2];
  EXPECT_NE(removal[2].find(",0.00041,"), std::string::npos) << "the cap has left: " << removal[2];
  EXPECT_EQ(linesOf(planAsCsv(planOfAStack(), product, PlanOrder::Assembly))[1].rfind("1,pin,", 0), 0U);
}

TEST(PlanWords, AStepOfSeveralMotionsIsToldInTheOrderOfItsMotions) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyStep step = planOfAStack().steps[0];
  EXPECT_EQ(nameOfStep(step, product), "pin, cap");
  const PlanWords english = wordsIn(Language::English);
  EXPECT_EQ(english.work(step, product, PlanOrder::Removal), "up (+Z), 500 mm; up (+Z), 250 mm, then +X, 100 mm");
  EXPECT_EQ(english.work(step, product, PlanOrder::Assembly), "−X, 100 mm, then down (−Z), 250 mm; down (−Z), 500 mm");
}

std::size_t countOf(const std::string& what, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(PlanGraph, ArrowsThatOthersImplyAreLeftOut) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = somePlan();
  plan.stuck.clear();
  plan.steps.push_back(stepOf("drawer", {Pose::identity(), Pose::translation({1.0, 0.0, 0.0})}));
  plan.steps[2].after = {1, 2};
  const std::string svg = planGraphSvg(plan, product, DocumentWords());
  EXPECT_EQ(countOf("<text", svg), 3U);
  EXPECT_EQ(countOf(" C", svg), 2U) << "cap to pin, pin to drawer";
  EXPECT_NE(svg.find("1  drawer"), std::string::npos) << "numbers are those of the assembly";
}

TEST(PlanGraph, StuckPartsHaveArrowsFromWhatBlocksThem) {
  const std::string svg = planGraphSvg(somePlan(), test::lockedDrawer(), DocumentWords(Language::French));
  EXPECT_EQ(countOf("stroke-dasharray", svg), 1U);
  EXPECT_NE(svg.find("drawer (coincée)"), std::string::npos);
  EXPECT_NE(svg.find("cabinet (base)"), std::string::npos);
}

std::size_t headings(const Report& report) {
  return static_cast<std::size_t>(std::count_if(report.blocks.begin(), report.blocks.end(), [](const auto& block) {
    return std::holds_alternative<ReportHeading>(block);
  }));
}

TEST(PlanReport, HasAPageForEachStepInTheOrderOfAssembly) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = somePlan();
  const Report report =
      planReport({plan, product, "drawer", 1e-5, {}, {StepCheck::Agrees, StepCheck::Disagrees}, {}, "", "", {}},
                 wordsIn(Language::English));
  EXPECT_EQ(headings(report), 4U) << "parts list, two steps, parts without a step";
  const auto page = reportHtml(report);
  ASSERT_TRUE(page.ok());
  EXPECT_LT(page->find("Step 1 of 2: pin"), page->find("Step 2 of 2: cap"));
  EXPECT_NE(page->find("0.41 mm on cabinet (thread)"), std::string::npos);
  EXPECT_NE(page->find("The independent check agrees with 1 of 2 steps."), std::string::npos);
  EXPECT_NE(page->find("the independent check does not agree"), std::string::npos);
  EXPECT_EQ(countOf("class=\"page\"", *page), 4U);
}

/// No English sentence is left in the French one.
TEST(PlanReport, SaysWhetherAHandGetsThereWhereThatWasAsked) {
  const AssemblyPlan plan = somePlan();
  const AssembledProduct product = test::lockedDrawer();
  PlanReportContent content{plan, product, "drawer"};
  const auto page = [&] { return *reportHtml(planReport(content, wordsIn(Language::English))); };
  EXPECT_EQ(page().find("Hand access"), std::string::npos);
  content.access.steps = {"the cap is reached", "the pin is not"};
  EXPECT_NE(page().find("Hand access, sampled"), std::string::npos);
  EXPECT_LT(page().find("the pin is not"), page().find("the cap is reached")) << "in the order of assembly";
}

TEST(PlanReport, IsWhollyInFrench) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = somePlan();
  const auto page =
      reportHtml(planReport({plan, product, "drawer", 1e-5, {}, {}, {}, "", "", {}}, wordsIn(Language::French)));
  ASSERT_TRUE(page.ok());
  EXPECT_NE(page->find("Étape 1 sur 2 : pin"), std::string::npos);
  for (const char* word : {" the ", "Step", "Part", "part ", "Clearance", "Allowance", "thread", "Found", "stuck"}) {
    const std::size_t body = page->find("<body>");
    EXPECT_EQ(page->find(word, body), std::string::npos) << word;
  }
}

/// Pin and cap come as one group, which is put together before.
AssemblyPlan planWithASubassembly() {
  AssemblyPlan plan = somePlan();
  plan.stuck.clear();
  AssemblyStep group = plan.steps[1];
  group.only().body = "pin";
  group.only().with = {"cap"};
  AssemblyStep cap = plan.steps[0];
  cap.only().joints.push_back({JointKind::Screw, "cap", {"pin"}});
  cap.only().joints.back().designation = "ISO 4762 M3x8";
  cap.only().joints.back().turns = 9.5;
  plan.lines.push_back({1, {"pin", "cap"}, {"pin"}, {cap}});
  plan.steps = {group};
  return plan;
}

TEST(PlanReport, HasAPageForASubassemblyBeforeTheStepThatBringsIt) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = planWithASubassembly();
  const auto page =
      reportHtml(planReport({plan, product, "drawer", 0.0, {}, {}, {}, "", "", {}}, wordsIn(Language::English)));
  ASSERT_TRUE(page.ok());
  const std::size_t own = page->find("Subassembly for step 1");
  ASSERT_NE(own, std::string::npos);
  EXPECT_LT(own, page->find("Step 1 of 1"));
  EXPECT_NE(page->find("screw in ISO 4762 M3x8, 9.5 turns", own), std::string::npos);
  EXPECT_NE(page->find(">1.1<", own), std::string::npos) << "the number of the step";
  PlanReportContent asked{plan, product, "drawer"};
  asked.access = {{"the group is reached"}, {{{"the cap is not"}, {}}}};
  const auto askedPage = reportHtml(planReport(asked, wordsIn(Language::English)));
  ASSERT_TRUE(askedPage.ok());
  EXPECT_LT(askedPage->find("the cap is not"), askedPage->find("Step 1 of 1"));
}

TEST(PlanReport, StepsOfOneTaskAreOnePage) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = somePlan();
  plan.stuck.clear();
  for (AssemblyStep& step : plan.steps) {
    step.task = 1;
    step.only().joints.push_back({JointKind::Screw, step.only().body, {"cabinet"}});
    step.only().joints.back().designation = "M3x8";
    step.only().joints.back().turns = 9.5;
  }
  const auto page =
      reportHtml(planReport({plan, product, "drawer", 0.0, {}, {}, {}, "", "", {}}, wordsIn(Language::English)));
  ASSERT_TRUE(page.ok());
  EXPECT_NE(page->find("Steps 1 to 2 of 2: pin, cap"), std::string::npos);
  EXPECT_EQ(countOf("2 times: screw in M3x8, 9.5 turns", *page), 1U);
  EXPECT_EQ(page->find("Step 2 of 2"), std::string::npos);
}

TEST(PartsList, ConsecutiveStepsAreARange) {
  PartsListRow row{"diode", {}};
  row.hasBase = true;
  row.steps = {2, 3, 5, 7, 8, 9, 12};
  EXPECT_EQ(stepsText(row, DocumentWords(Language::English)), "base, 2, 3, 5, 7–9, 12");
}

TEST(PartsList, FastenersOfOneDesignationAreOneRow) {
  AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = planWithASubassembly();
  AssemblyStep& group = plan.steps.front();
  group.only().joints = plan.lines.front().steps.front().only().joints;
  group.only().joints.front().body = "pin";
  const std::vector<PartsListRow> rows = partsList(plan, product);
  ASSERT_EQ(rows.size(), 3U) << "drawer, cabinet, pin and cap";
  EXPECT_EQ(rows[1].designation, "ISO 4762 M3x8");
  EXPECT_EQ(rows[1].count, 2U);
  EXPECT_EQ(rows[1].steps, std::vector<std::size_t>{1}) << "both come by one step";
  EXPECT_EQ(std::count_if(rows.begin(), rows.end(), [](const PartsListRow& row) { return row.hasBase; }), 1);
}

TEST(PartsList, ScrewsOfADesignationWithoutALengthAreOneRowOnlyIfTheirShapesAreOne) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = planWithASubassembly();
  AssemblyStep& group = plan.steps.front();
  group.only().joints = plan.lines.front().steps.front().only().joints;
  group.only().joints.front().body = "pin";
  const auto rowsWith = [&](const std::string& designation) {
    group.only().joints.front().designation = designation;
    plan.lines.front().steps.front().only().joints.front().designation = designation;
    return partsList(plan, product).size();
  };
  EXPECT_EQ(rowsWith("BHCS #10-32x1/2\""), 3U);
  EXPECT_EQ(rowsWith("BHCS #10-32"), 4U);
}

TEST(PartsList, PartsOfOneShapeAreOneRowWhateverTheirCounterAndPlace) {
  AssembledProduct product = test::productOf(
      {boxBody("base", {2.0, 1.0, 0.1}, Pose::identity()), boxBody("nut-1", {0.1, 0.1, 0.1}, Pose::identity()),
       boxBody("nut-2", {0.1, 0.1, 0.1}, Pose::translation({0.5, 0.0, 0.0})),
       boxBody("nut-3", {0.1, 0.1, 0.2}, Pose::identity()), boxBody("M5 x 20", {0.1, 0.2, 0.1}, Pose::identity())});
  const auto moved = transformed(*product.bodies[2].mesh, {{0.3, 0.2, 0.1}, fromRollPitchYaw(0.3, 0.2, 0.1)});
  product.bodies[2].mesh = std::make_shared<const TriangleMesh>(moved);
  AssemblyPlan plan;
  plan.staying = {"base"};
  const std::vector<PartsListRow> rows = partsList(plan, product);
  std::vector<std::string> texts;
  for (const PartsListRow& row : rows) texts.push_back(std::to_string(row.count) + " " + row.name);
  EXPECT_EQ(texts, (std::vector<std::string>{"1 base", "1 M5 x 20", "2 nut", "1 nut-3"}));
}

/// "/" and commas in names do not separate steps of a path or columns.
TEST(PartsList, NamesAreThoseOfTheFile) {
  AssembledProduct product = test::productOf({boxBody("base", {2.0, 1.0, 0.1}, Pose::identity()),
                                              boxBody("1_4-20", {0.1, 0.1, 0.1}, Pose::translation({0, 0, 1}))});
  product.tree = Product({{"base", {"base"}}, {"1_4-20", {"1_4-20", productNames({"1/4-20 x 1, zinc"})}}});
  AssemblyPlan plan;
  plan.staying = {"base"};
  plan.steps.push_back(stepOf("1_4-20", {Pose::identity(), Pose::translation({0, 0, 1})}));
  plan.steps.back().only().proof.nearest = "base";
  EXPECT_EQ(partsList(plan, product).back().name, "1/4-20 x 1, zinc");
  EXPECT_NE(planAsCsv(plan, product, PlanOrder::Removal).find("\n1,\"1/4-20 x 1, zinc\","), std::string::npos);
}

TEST(PlanReport, SaysTimesAndTheLine) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = somePlan();
  const auto timing = planTiming(plan, product, WorkTimes(), 2);
  ASSERT_TRUE(timing.ok());
  for (const Language language : {Language::English, Language::French}) {
    const auto page =
        reportHtml(planReport({plan, product, "drawer", 1e-5, {}, {}, {}, "", "", {}, *timing}, wordsIn(language)));
    ASSERT_TRUE(page.ok());
    const bool english = language == Language::English;
    EXPECT_NE(page->find(english ? "Critical path" : "Chemin critique"), std::string::npos);
    EXPECT_NE(page->find(english ? "Line of 2 stations" : "Ligne de 2 postes"), std::string::npos);
    EXPECT_NE(page->find("<svg"), std::string::npos);
    EXPECT_EQ(page->find("The times are") == std::string::npos, !english);
  }
}

TEST(PlanReport, SaysThatTheTableOfTimesWasEdited) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = somePlan();
  WorkTimes table;
  table.fetchLarge += 1.0;
  table.fetchWithAid += 1.0;
  const auto usual = planTiming(plan, product, WorkTimes());
  const auto timing = planTiming(plan, product, table);
  ASSERT_TRUE(usual.ok() && timing.ok());
  EXPECT_EQ(usual->edited, 0U);
  EXPECT_EQ(timing->edited, 2U);
  EXPECT_GT(timing->sum(), usual->sum());
  for (const Language language : {Language::English, Language::French}) {
    const auto page =
        reportHtml(planReport({plan, product, "drawer", 1e-5, {}, {}, {}, "", "", {}, *timing}, wordsIn(language)));
    ASSERT_TRUE(page.ok());
    const bool english = language == Language::English;
    EXPECT_NE(page->find(english ? "2 of its 18 values were edited" : "2 de ses 18 valeurs ont été modifiées"),
              std::string::npos);
  }
}

TEST(PlanReport, AMissingPictureIsAnError) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = somePlan();
  EXPECT_FALSE(reportHtml(planReport({plan, product, "drawer", 0.0, {}, {}, {}, "/gone.png", "", {}},
                                     wordsIn(Language::English)))
                   .ok());
}

}  // namespace
}  // namespace glissade
