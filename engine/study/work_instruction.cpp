#include "engine/study/work_instruction.h"

#include <glissade/version.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace glissade {
namespace {

constexpr const char* kDash = "–";

class Composer {
 public:
  Composer(const InstructionContent& content, const PlanWords& words) : content_(content), plain_(words) {}

  StudyReport compose() {
    report_.language = plain_.words().language();
    report_.title = say("Work instruction: %1", {content_.name});
    addCover();
    addPartsList();
    for (std::size_t i = 0; i < content_.plan.steps.size(); ++i) addStep(i);
    addTimes();
    addStuck();
    if (!content_.graphPicture.empty()) {
      report_.blocks.emplace_back(ReportHeading{say("Order of the steps"), 2, true});
      picture(content_.graphPicture,
              say("An arrow leads from a step of the removal to each step that it makes way for."));
    }
    return std::move(report_);
  }

 private:
  std::string say(std::string_view english, std::initializer_list<std::string> arguments = {}) const {
    return plain_.words()(english, arguments);
  }
  const std::string& nameOf(const std::string& id) const {
    return content_.product.bodies[*content_.product.indexOf(id)].shown();
  }
  static ReportTable facts(std::vector<std::vector<std::string>> rows) {
    return {"", {{"", ReportColumn::Kind::Text}, {"", ReportColumn::Kind::Prose}}, std::move(rows)};
  }
  void picture(const std::string& file, const std::string& caption) {
    if (!file.empty()) report_.blocks.emplace_back(ReportPicture{file, caption, 1.0});
  }
  /// In the order of assembly, from 1.
  std::size_t numberOf(std::size_t step) const { return content_.plan.steps.size() - step; }

  void addCover() {
    const AssemblyPlan& plan = content_.plan;
    std::string base;
    for (const std::string& id : plan.staying) base += (base.empty() ? "" : ", ") + nameOf(id);
    report_.blocks.emplace_back(facts({{say("Product"), content_.name},
                                       {say("Parts to assemble"), std::to_string(plan.parts())},
                                       {say("Assembly steps"), std::to_string(plan.steps.size())},
                                       {say("Parts without a step"), std::to_string(plan.parts() - plan.removed())},
                                       {say("Base"), base},
                                       {say("Seed"), std::to_string(plan.seed)},
                                       {say("Program"), std::string("Glissade ") + kVersion}}));
    report_.blocks.emplace_back(ReportText{say(
        "Every motion is certified: the part keeps its clearance from all parts that are there, on all of its way.")});
    const auto count = std::count(content_.checks.begin(), content_.checks.end(), StepCheck::Agrees);
    const auto notAsked = std::count(content_.checks.begin(), content_.checks.end(), StepCheck::NotAsked);
    if (static_cast<std::size_t>(notAsked) < content_.checks.size()) {
      report_.blocks.emplace_back(ReportText{say("The independent check agrees with %1 of %2 steps.",
                                                 {std::to_string(count), std::to_string(plan.steps.size())})});
    }
    if (content_.deviation > 0.0) {
      report_.blocks.emplace_back(
          ReportText{say("The certificates are about triangles: surfaces may be %1 nearer than they are.",
                         {plain_.length(content_.deviation)})});
    }
    picture(content_.explodedPicture, say("The product, exploded"));
  }

  /// Parts of one geometry are one row.
  void addPartsList() {
    struct Row {
      std::string name;
      std::size_t count = 0;
      std::string steps;
    };
    std::vector<Row> rows;
    std::map<std::pair<MeshPtr, std::string>, std::size_t> known;
    std::map<std::string, std::size_t> stepOf;
    for (std::size_t i = 0; i < content_.plan.steps.size(); ++i) {
      for (const std::string& id : content_.plan.steps[i].bodies()) stepOf[id] = numberOf(i);
    }
    for (const RigidBody& body : content_.product.bodies) {
      const std::string kind = kindOfPart(body.name);
      const auto [entry, isNew] = known.emplace(std::pair(body.mesh, kind), rows.size());
      if (isNew) rows.push_back({kind, 0, ""});
      Row& row = rows[entry->second];
      ++row.count;
      const auto& staying = content_.plan.staying;
      const bool isBase = std::find(staying.begin(), staying.end(), body.id) != staying.end();
      const auto step = stepOf.find(body.id);
      const std::string when = isBase ? say("base") : step == stepOf.end() ? kDash : std::to_string(step->second);
      row.steps += (row.steps.empty() ? "" : ", ") + when;
    }
    ReportTable table{"",
                      {{say("Part"), ReportColumn::Kind::Text},
                       {say("Count"), ReportColumn::Kind::Number},
                       {say("Steps"), ReportColumn::Kind::Prose}},
                      {}};
    for (const Row& row : rows) table.rows.push_back({row.name, std::to_string(row.count), row.steps});
    report_.blocks.emplace_back(ReportHeading{say("Parts list"), 2, true});
    report_.blocks.emplace_back(std::move(table));
  }

  void addStep(std::size_t place) {
    const std::size_t i = content_.plan.steps.size() - 1 - place;
    const AssemblyStep& step = content_.plan.steps[i];
    const std::string name = nameOfStep(step, content_.product);
    std::string fullNames;
    for (const std::string& id : step.bodies()) fullNames += (fullNames.empty() ? "" : ", ") + nameOf(id);
    report_.blocks.emplace_back(ReportHeading{
        say("Step %1 of %2: %3", {std::to_string(place + 1), std::to_string(content_.plan.steps.size()), name}), 2,
        true});
    if (i < content_.pictures.size()) picture(content_.pictures[i], say("%1 on its way", {name}));
    std::vector<std::vector<std::string>> rows{{say("Full name"), fullNames},
                                               {say("Motion"), plain_.motion(step, PlanOrder::Assembly)},
                                               {say("Clearance"), clearanceText(step)}};
    if (const auto tool = plain_.tool(step, content_.product); !tool.empty()) rows.push_back({say("Tool"), tool});
    if (const auto held = plain_.standing(step, content_.product); !held.empty()) {
      rows.push_back({say("To be held"), held});
    }
    std::string forced;
    for (const std::string& text : plain_.violations(step, content_.product)) {
      forced += (forced.empty() ? "" : "; ") + text;
    }
    if (!forced.empty()) rows.push_back({say("Forced, although"), forced});
    const auto allowances = plain_.allowances(step, content_.product);
    if (allowances.empty()) rows.push_back({say("Allowance"), say("none")});
    for (const std::string& text : allowances) rows.push_back({say("Allowance"), text});
    if (content_.timing) rows.push_back({say("Time"), seconds(content_.timing->times[place].total())});
    rows.push_back({say("Found by"), step.method});
    rows.push_back({say("Check"), checkText(i < content_.checks.size() ? content_.checks[i] : StepCheck::NotAsked)});
    report_.blocks.emplace_back(facts(std::move(rows)));
  }

  std::string seconds(double value) const {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << value;
    return say("%1 s", {text.str()});
  }

  void addTimes() {
    if (!content_.timing) return;
    const PlanTiming& timing = *content_.timing;
    report_.blocks.emplace_back(ReportHeading{say("Times"), 2, true});
    report_.blocks.emplace_back(ReportText{
        say("The times are estimates of the size of tables for manual assembly (Boothroyd, Dewhurst and Knight 2011). "
            "They were not measured.")});
    report_.blocks.emplace_back(facts({{say("One person"), seconds(timing.sum())},
                                       {say("Longest chain"), seconds(timing.chainSeconds())},
                                       {say("Steps of the longest chain"), numbersText(timing.chain)}}));
    if (timing.line) addLine(timing);
  }

  void addLine(const PlanTiming& timing) {
    const LineBalance& line = *timing.line;
    report_.blocks.emplace_back(ReportHeading{say("Line of %1 stations", {std::to_string(line.load.size())}), 3});
    report_.blocks.emplace_back(ReportText{say("A product leaves the line every %1. No division is faster than %2.",
                                               {seconds(line.cycle), seconds(line.least)})});
    ReportTable table{"",
                      {{say("Station"), ReportColumn::Kind::Number},
                       {say("Time"), ReportColumn::Kind::Number},
                       {say("Steps"), ReportColumn::Kind::Prose}},
                      {}};
    for (std::size_t s = 0; s < line.load.size(); ++s) {
      table.rows.push_back({std::to_string(s + 1), seconds(line.load[s]), numbersText(timing.stepsAt(s))});
    }
    report_.blocks.emplace_back(std::move(table));
    report_.blocks.emplace_back(loadPlot(line));
  }

  /// A bar for each station.
  Plot loadPlot(const LineBalance& line) const {
    constexpr double kBarShare = 0.6;
    Plot plot;
    plot.name = "station_load";
    plot.title = say("Work of each station");
    plot.kind = PlotKind::Bars;
    std::vector<std::string> names;
    for (std::size_t s = 0; s < line.load.size(); ++s) names.push_back(std::to_string(s + 1));
    plot.x = PlotScale::categories(say("Station"), names);
    std::vector<double> values = line.load;
    values.push_back(0.0);
    plot.y = PlotScale::linear(say("seconds"), values);
    plot.barWidth = kBarShare / static_cast<double>(line.load.size());
    PlotSeries series;
    for (std::size_t s = 0; s < line.load.size(); ++s) {
      const double load = line.load[s];
      series.points.push_back({static_cast<double>(s), load, load, load, "", seconds(load), std::nullopt});
    }
    plot.series.push_back(std::move(series));
    return plot;
  }

  std::string checkText(StepCheck check) const {
    if (check == StepCheck::NotAsked) return say("not carried out");
    return say(check == StepCheck::Agrees ? "the independent check agrees" : "the independent check does not agree");
  }

  std::string clearanceText(const AssemblyStep& step) const {
    if (step.proof.nearest.empty()) return say("no part is near");
    return say("at least %1, smallest %2 to %3", {plain_.length(step.proof.provedClearance),
                                                  plain_.length(step.proof.minClearance), nameOf(step.proof.nearest)});
  }

  void addStuck() {
    if (content_.plan.stuck.empty()) return;
    report_.blocks.emplace_back(ReportHeading{say("Parts without a step"), 2, true});
    report_.blocks.emplace_back(
        ReportText{say("No motion was found for these parts. They are in the product from the beginning.")});
    ReportTable table{
        "", {{say("Part"), ReportColumn::Kind::Text}, {say("Blocked by"), ReportColumn::Kind::Prose}}, {}};
    for (const StuckBody& stuck : content_.plan.stuck) {
      std::string blockers;
      for (const std::string& other : stuck.blockedBy) blockers += (blockers.empty() ? "" : ", ") + nameOf(other);
      table.rows.push_back({nameOf(stuck.body), blockers.empty() ? kDash : blockers});
    }
    report_.blocks.emplace_back(std::move(table));
  }

  const InstructionContent& content_;
  const PlanWords& plain_;
  StudyReport report_;
};

}  // namespace

StudyReport workInstruction(const InstructionContent& content, const PlanWords& words) {
  return Composer(content, words).compose();
}

}  // namespace glissade
