#include "engine/documents/plan_report.h"

#include <glissade/version.h>

#include <algorithm>
#include <functional>
#include <set>

#include "engine/documents/parts_list.h"
#include "engine/documents/plan_tasks.h"
#include "engine/documents/plan_words.h"
#include "engine/documents/times_section.h"
#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/subassembly_lines.h"

namespace glissade {
namespace {

constexpr const char* kDash = "–";

class Composer {
 public:
  Composer(const PlanReportContent& content, const PlanWords& words)
      : content_(content), plain_(words), parts_(partsList(content.plan, content.product)) {}

  Report compose() {
    report_.language = plain_.words().language();
    report_.title = say(GLISSADE_TEXT("Report of the sequence: %1"), {content_.name});
    addCover();
    addPartsList();
    const std::vector<TaskRange> tasks = taskRanges(content_.plan.steps, parts_);
    for (std::size_t task = 0; task < tasks.size(); ++task) {
      const std::size_t place = tasks[task].place;
      addSubassemblies(content_.plan.lines, content_.access.lines, content_.plan.steps.size() - place,
                       stepNumber(place));
      addPage(task, tasks[task]);
    }
    if (content_.timing) addTimesSection(*content_.timing, plain_.words(), report_);
    addStuck();
    if (!content_.graphPicture.empty()) {
      report_.blocks.emplace_back(ReportHeading{say(GLISSADE_TEXT("Precedence graph")), 2, true});
      picture(content_.graphPicture,
              say(GLISSADE_TEXT("An arrow leads from a step of the removal to each step that has to come after it.")));
    }
    return std::move(report_);
  }

 private:
  std::string say(CatalogueText text, std::initializer_list<MessageArgument> arguments = {}) const {
    return plain_.words()(text, arguments);
  }
  const std::string& nameOf(const BodyId& id) const { return content_.product.body(id).shown(); }
  static ReportTable facts(std::vector<std::vector<std::string>> rows) {
    return {"", {{"", ReportColumn::Kind::Text}, {"", ReportColumn::Kind::Prose}}, std::move(rows)};
  }
  void picture(const std::string& file, const std::string& caption) {
    if (!file.empty()) report_.blocks.emplace_back(ReportPicture{file, caption, 1.0});
  }

  void addCover() {
    const AssemblyPlan& plan = content_.plan;
    report_.blocks.emplace_back(
        facts({{say(GLISSADE_TEXT("Product")), content_.name},
               {say(GLISSADE_TEXT("Parts to assemble")), std::to_string(plan.parts())},
               {say(GLISSADE_TEXT("Assembly steps")), std::to_string(plan.steps.size())},
               {say(GLISSADE_TEXT("Parts without a step")), std::to_string(plan.parts() - plan.removed())},
               {say(GLISSADE_TEXT("Base")), plain_.base(plan, content_.product)},
               {say(GLISSADE_TEXT("Seed")), std::to_string(plan.seed)},
               {say(GLISSADE_TEXT("Program")), std::string("Glissade ") + kVersion}}));
    report_.blocks.emplace_back(
        ReportText{say(GLISSADE_TEXT("Every motion is certified: the part keeps its clearance from all parts that are "
                                     "present, along its whole path."))});
    const auto count = std::count(content_.checks.begin(), content_.checks.end(), StepCheck::Agrees);
    const auto notAsked = std::count(content_.checks.begin(), content_.checks.end(), StepCheck::NotAsked);
    if (static_cast<std::size_t>(notAsked) < content_.checks.size()) {
      report_.blocks.emplace_back(
          ReportText{say(GLISSADE_TEXT("The independent check agrees with %1 of %2 {2|step|steps}."),
                         {std::to_string(count), std::to_string(plan.steps.size())})});
    }
    if (!content_.missing.empty()) {
      report_.blocks.emplace_back(
          ReportText{say(GLISSADE_TEXT("The certificate is about the product without these shapes of the file, which "
                                       "were not made into bodies: %1."),
                         {listOf(content_.missing)})});
    }
    if (const std::string isolated = plain_.isolated(plan, content_.product); !isolated.empty()) {
      report_.blocks.emplace_back(ReportText{isolated});
    }
    for (const std::string& condition : content_.conditions) {
      report_.blocks.emplace_back(ReportText{say(GLISSADE_TEXT("The plan is valid only if %1."), {condition})});
    }
    const std::size_t joined = plan.removed() - bodiesApart(plan);
    if (joined > 0) {
      report_.blocks.emplace_back(ReportText{
          say(GLISSADE_TEXT(
                  "%1 {1|part is removed in a group that is|parts are removed in groups that are} not disassembled."),
              {std::to_string(joined)})});
    }
    if (content_.deviation > 0.0) {
      report_.blocks.emplace_back(ReportText{
          say(GLISSADE_TEXT("CAD accuracy of the certificates: ± %1."), {plain_.length(content_.deviation)})});
    }
    picture(content_.explodedPicture, say(GLISSADE_TEXT("The product, exploded")));
  }

  void addPartsList() {
    ReportTable table{"",
                      {{say(GLISSADE_TEXT("Part")), ReportColumn::Kind::Text},
                       {say(GLISSADE_TEXT("Designation")), ReportColumn::Kind::Text},
                       {say(GLISSADE_TEXT("Count")), ReportColumn::Kind::Number},
                       {say(GLISSADE_TEXT("Steps")), ReportColumn::Kind::Prose}},
                      {}};
    for (const PartsListRow& row : parts_) {
      table.rows.push_back({row.name, row.designation.empty() ? kDash : row.designation, std::to_string(row.count),
                            stepsText(row, plain_.words())});
    }
    report_.blocks.emplace_back(ReportHeading{say(GLISSADE_TEXT("Parts list")), 2, true});
    report_.blocks.emplace_back(std::move(table));
  }

  std::string namesOf(const std::vector<BodyId>& ids) const {
    std::string names;
    for (const BodyId& id : ids) names += (names.empty() ? "" : ", ") + nameOf(id);
    return names;
  }

  /// Adds a page for each group that a step brings, before that step, and for the groups in it. `number`: number of the
  /// step, "12", or "12.3" for a step in a group.
  void addSubassemblies(const std::vector<SubassemblyLine>& lines, const std::vector<LineTexts>& access,
                        std::size_t step, const std::string& number) {
    for (std::size_t l = 0; l < lines.size(); ++l) {
      const SubassemblyLine& line = lines[l];
      if (line.step != step) continue;
      const LineTexts reached = l < access.size() ? access[l] : LineTexts();
      for (std::size_t i = line.steps.size(); i > 0; --i) {
        addSubassemblies(line.lines, reached.lines, i, stepNumber(line.steps.size() - i, number));
      }
      addSubassembly(line, reached.steps, number);
    }
  }

  /// `access`: text for each step; empty: not checked.
  void addSubassembly(const SubassemblyLine& line, const std::vector<std::string>& access, const std::string& number) {
    report_.blocks.emplace_back(ReportHeading{say(GLISSADE_TEXT("Subassembly for step %1"), {number}), 2, true});
    report_.blocks.emplace_back(facts(
        {{say(GLISSADE_TEXT("Parts")), namesOf(line.bodies)}, {say(GLISSADE_TEXT("Base")), namesOf(line.staying)}}));
    ReportTable table{"",
                      {{say(GLISSADE_TEXT("Step")), ReportColumn::Kind::Text},
                       {say(GLISSADE_TEXT("Part")), ReportColumn::Kind::Prose},
                       {say(GLISSADE_TEXT("Work")), ReportColumn::Kind::Prose},
                       {say(GLISSADE_TEXT("Tool")), ReportColumn::Kind::Prose}},
                      {}};
    if (!access.empty())
      table.columns.push_back({say(GLISSADE_TEXT("Hand access, sampled")), ReportColumn::Kind::Prose});
    for (std::size_t i = line.steps.size(); i > 0; --i) {
      const AssemblyStep& step = line.steps[i - 1];
      const std::string tool = plain_.tool(step.opening(), content_.product);
      table.rows.push_back({stepNumber(line.steps.size() - i, number), nameOfStep(step, content_.product),
                            plain_.work(step, content_.product, PlanOrder::Assembly), tool.empty() ? kDash : tool});
      if (!access.empty()) table.rows.back().push_back(access[i - 1]);
    }
    report_.blocks.emplace_back(std::move(table));
    for (const StuckBody& stuck : line.stuck) {
      report_.blocks.emplace_back(ReportText{say(GLISSADE_TEXT("%1 is not put on alone."), {nameOf(stuck.body)})});
    }
  }

  using Texts = std::vector<std::string>;
  using Steps = std::vector<const AssemblyStep*>;
  using Rows = std::vector<Texts>;

  /// Adds one row for each different text of the steps.
  static void addRows(const std::string& label, const Steps& steps,
                      const std::function<Texts(const AssemblyStep&)>& textsOf, Rows& rows) {
    std::set<std::string> said;
    for (const AssemblyStep* step : steps) {
      for (const std::string& text : textsOf(*step)) {
        if (!text.empty() && said.insert(text).second) rows.push_back({label, text});
      }
    }
  }

  /// Adds a page for a step, or for the steps of a task.
  void addPage(std::size_t task, const TaskRange& range) {
    const std::string all = std::to_string(content_.plan.steps.size());
    Steps steps;
    std::vector<BodyId> bodies;
    for (std::size_t at = range.place; at < range.place + range.count; ++at) {
      steps.push_back(&stepAtPlace(content_.plan.steps, at));
      for (const BodyId& id : steps.back()->bodies()) bodies.push_back(id);
    }
    const std::string name = nameOfStep(*steps.front(), content_.product);
    const std::string first = stepNumber(range.place);
    const std::string title = range.count == 1
                                  ? say(GLISSADE_TEXT("Step %1 of %2: %3"), {first, all, name})
                                  : say(GLISSADE_TEXT("Steps %1 to %2 of %3: %4"),
                                        {first, stepNumber(range.place + range.count - 1), all, kindsIn(steps)});
    report_.blocks.emplace_back(ReportHeading{title, 2, true});
    if (task < content_.pictures.size())
      picture(content_.pictures[task], say(GLISSADE_TEXT("%1, removal path"), {name}));
    report_.blocks.emplace_back(facts(factsOf(steps, bodies, range.place)));
  }

  /// "3 × bolt, 3 × nut": the kinds of parts that the steps bring, in their order.
  std::string kindsIn(const Steps& steps) const {
    std::vector<std::pair<std::string, std::size_t>> kinds;
    for (const AssemblyStep* step : steps) {
      for (const std::size_t body : bodiesOf(*step, content_.product)) {
        const std::string kind = kindOfPart(body, content_.product);
        const auto known =
            std::find_if(kinds.begin(), kinds.end(), [&](const auto& each) { return each.first == kind; });
        if (known == kinds.end()) {
          kinds.emplace_back(kind, 1);
        } else {
          ++known->second;
        }
      }
    }
    std::string text;
    for (const auto& [kind, count] : kinds) text += (text.empty() ? "" : ", ") + countedName(kind, count);
    return text;
  }

  Rows factsOf(const Steps& steps, const std::vector<BodyId>& bodies, std::size_t place) const {
    const AssembledProduct& product = content_.product;
    Rows rows{{say(GLISSADE_TEXT("Full name")), namesOf(bodies)}};
    const auto eachMotion = [](const AssemblyStep& step, const auto& textOf) {
      Texts texts;
      for (const StepMotion* motion : motionsOf(step, PlanOrder::Assembly)) texts.push_back(textOf(*motion));
      return texts;
    };
    const auto pathsOf = [&](const AssemblyStep& step) {
      return eachMotion(step, [&](const StepMotion& motion) { return plain_.path(motion, PlanOrder::Assembly); });
    };
    addRows(
        say(GLISSADE_TEXT("Work")), steps, [&](const AssemblyStep& step) { return workOf(step, steps); }, rows);
    addRows(say(GLISSADE_TEXT("Motion")), steps, pathsOf, rows);
    addRows(
        say(GLISSADE_TEXT("Clearance")), steps,
        [&](const AssemblyStep& step) {
          return eachMotion(step, [&](const StepMotion& motion) { return clearanceText(motion); });
        },
        rows);
    addRows(
        say(GLISSADE_TEXT("Tool")), steps,
        [&](const AssemblyStep& step) { return Texts{plain_.tool(step.opening(), product)}; }, rows);
    for (std::size_t at = place; !content_.access.steps.empty() && at < place + steps.size(); ++at) {
      const std::string& text = content_.access.steps[content_.plan.steps.size() - 1 - at];
      if (rows.back().back() != text) rows.push_back({say(GLISSADE_TEXT("Hand access, sampled")), text});
    }
    addRows(
        say(GLISSADE_TEXT("Support")), steps,
        [&](const AssemblyStep& step) { return Texts{plain_.standing(step, product)}; }, rows);
    addRows(
        say(GLISSADE_TEXT("Forced, although")), steps,
        [&](const AssemblyStep& step) { return plain_.violations(step, product); }, rows);
    addRows(
        say(GLISSADE_TEXT("Allowance")), steps, [&](const AssemblyStep& step) { return allowancesOf(step); }, rows);
    if (content_.timing) {
      double sum = 0.0;
      for (std::size_t at = place; at < place + steps.size(); ++at) sum += content_.timing->times[at].total();
      rows.push_back({say(GLISSADE_TEXT("Time")), secondsText(sum, plain_.words())});
    }
    addRows(
        say(GLISSADE_TEXT("Found by")), steps,
        [&](const AssemblyStep& step) {
          return eachMotion(step, [&](const StepMotion& motion) {
            return toString(methodInWords(motion.method), plain_.words().language());
          });
        },
        rows);
    for (std::size_t at = place; at < place + steps.size(); ++at) {
      const std::string text = checkTextAt(content_.plan.steps.size() - 1 - at);
      if (rows.back().back() != text) rows.push_back({say(GLISSADE_TEXT("Check")), text});
    }
    return rows;
  }

  /// The work of a step, and how many of the steps have the same, for example "4 times: screw in M3x8, 9.5 turns";
  /// nothing where the motion states it.
  Texts workOf(const AssemblyStep& step, const Steps& steps) const {
    const auto textOf = [&](const AssemblyStep& each) {
      return plain_.work(each, content_.product, PlanOrder::Assembly);
    };
    const std::string work = textOf(step);
    if (work == plain_.motion(step, PlanOrder::Assembly)) return {};
    const auto count =
        std::count_if(steps.begin(), steps.end(), [&](const auto* each) { return textOf(*each) == work; });
    return {count == 1 ? work : say(GLISSADE_TEXT("%1 times: %2"), {std::to_string(count), work})};
  }

  /// Precondition: the step is one of the plan's steps.
  Texts allowancesOf(const AssemblyStep& step) const {
    const auto at = static_cast<std::size_t>(&step - content_.plan.steps.data());
    Texts allowances;
    for (const StepMotion* motion : motionsOf(step, PlanOrder::Assembly)) {
      const Texts own = plain_.allowances(allowancesInOrder(content_.plan.steps, at, *motion), content_.product);
      allowances.insert(allowances.end(), own.begin(), own.end());
    }
    return allowances.empty() ? Texts{say(GLISSADE_TEXT("none"))} : allowances;
  }

  std::string checkTextAt(std::size_t step) const {
    return checkText(step < content_.checks.size() ? content_.checks[step] : StepCheck::NotAsked);
  }

  std::string checkText(StepCheck check) const {
    if (check == StepCheck::NotAsked) return say(GLISSADE_TEXT("not carried out"));
    return say(check == StepCheck::Agrees ? GLISSADE_TEXT("the independent check agrees")
                                          : GLISSADE_TEXT("the independent check does not agree"));
  }

  std::string clearanceText(const StepMotion& motion) const {
    if (motion.proof.nearest.empty()) return say(GLISSADE_TEXT("no part is near"));
    return say(GLISSADE_TEXT("at least %1, smallest %2 to %3"),
               {plain_.length(motion.proof.provedClearance), plain_.length(motion.proof.minClearance),
                nameOf(motion.proof.nearest)});
  }

  void addStuck() {
    if (content_.plan.stuck.empty()) return;
    report_.blocks.emplace_back(ReportHeading{say(GLISSADE_TEXT("Parts without a step")), 2, true});
    report_.blocks.emplace_back(ReportText{
        say(GLISSADE_TEXT("No motion was found for these parts. They are in the product from the beginning."))});
    ReportTable table{"",
                      {{say(GLISSADE_TEXT("Part")), ReportColumn::Kind::Text},
                       {say(GLISSADE_TEXT("Blocked by")), ReportColumn::Kind::Prose}},
                      {}};
    for (const StuckBody& stuck : content_.plan.stuck) {
      std::string blockers;
      for (const BodyId& other : stuck.blockedBy) blockers += (blockers.empty() ? "" : ", ") + nameOf(other);
      table.rows.push_back({nameOf(stuck.body), blockers.empty() ? kDash : blockers});
    }
    report_.blocks.emplace_back(std::move(table));
  }

  const PlanReportContent& content_;
  const PlanWords& plain_;
  std::vector<PartsListRow> parts_;
  Report report_;
};

}  // namespace

Report planReport(const PlanReportContent& content, const PlanWords& words) {
  return Composer(content, words).compose();
}

}  // namespace glissade
