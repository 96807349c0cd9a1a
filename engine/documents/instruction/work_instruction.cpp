#include "engine/documents/instruction/work_instruction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "engine/documents/instruction/instruction_words.h"
#include "engine/documents/plan_tasks.h"
#include "engine/sequence/accepted_clashes.h"
#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// A panel gets a close-up if the diagonal of the coming parts' box is below this share of the diagonal of all drawn
/// parts.
constexpr double kSmallShare = 0.12;
/// A panel gets a close-up if a smaller share of the coming parts is visible.
constexpr double kHiddenShare = 0.15;

/// Cosine against the downward vertical. A part whose exit direction is steeper falls out; other parts rest on
/// something.
constexpr double kFallsOut = 0.7;

/// Smallest number of screws on one part that are tightened crosswise, so that they clamp it evenly.
constexpr std::size_t kCrosswise = 3;

/// Metres. A nut that is nearer to the end of its rod is flush with it.
constexpr double kFlush = 1e-4;

/// Designation of a fastener, for example "screw M3x8"; the kind of part for others.
std::string partName(const PartsListRow& row) { return namesOnePart(row.designation) ? row.designation : row.name; }

class Instructor {
 public:
  Instructor(const AssemblyPlan& plan, const AssembledProduct& product, const PlanWords& words, const WorkWatch& watch)
      : plan_(plan), product_(product), words_(words), watch_(watch), view_(product) {}

  WorkInstruction instruct(const InstructionHeading& heading) {
    made_.language = words_.words().language();
    made_.title = heading.title;
    made_.imprint = heading.imprint;
    made_.up = plan_.up;
    made_.steps = plan_.steps.size();
    made_.base = plan_.staying.size();
    made_.bodies = idsOf(product_.bodies);
    made_.parts = partsList(plan_, product_);
    made_.incomplete = partsWithoutStep();
    addStatements(heading.excluded);
    std::set<BodyId> leaving;
    for (const AssemblyStep& step : plan_.steps) {
      for (const BodyId& id : step.bodies()) leaving.insert(id);
    }
    std::vector<BodyId> base;
    for (const BodyId& id : made_.bodies) {
      if (leaving.count(id) == 0) base.push_back(id);
    }
    addLine(plan_.steps, plan_.lines, base, plan_.up, {});
    return std::move(made_);
  }

 private:
  using Ids = std::vector<BodyId>;

  std::string say(CatalogueText text, std::initializer_list<MessageArgument> arguments = {}) const {
    return words_.words()(text, arguments);
  }

  std::string partsWithoutStep() const {
    std::string names;
    for (const PartsListRow& row : made_.parts) {
      if (row.withoutStep > 0) names += (names.empty() ? "" : ", ") + countedName(partName(row), row.withoutStep);
    }
    return names.empty() ? names : say(GLISSADE_TEXT("Incomplete: the plan has no step for %1."), {names});
  }

  void addStatements(const std::vector<std::string>& excluded) {
    std::string names;
    for (const std::string& name : excluded) names += (names.empty() ? "" : ", ") + name;
    if (!names.empty()) names = say(GLISSADE_TEXT("Excluded, without a step: %1"), {names});
    for (const std::string& statement : {acceptedClashes(), words_.isolated(plan_, product_), names}) {
      if (!statement.empty()) made_.statements.push_back(statement);
    }
  }

  /// The pairs of two kinds of parts between which a clash is accepted.
  struct ClashOfKinds {
    std::size_t pairs = 0;
    double depth = 0.0;
    std::set<std::string> cut{};  ///< kinds of parts that are cut
  };
  using ClashesOfKinds = std::map<std::pair<std::string, std::string>, ClashOfKinds>;

  std::string acceptedClashes() {
    ClashesOfKinds clashes;
    for (const AcceptedClash& each : acceptedClashesOf(plan_)) {
      const std::string one = partName(rowOf(each.a));
      const std::string other = partName(rowOf(each.b));
      ClashOfKinds& clash = clashes[std::minmax(one, other)];
      ++clash.pairs;
      clash.depth = std::max(clash.depth, each.depth);
      if (!each.cut.empty()) clash.cut.insert(partName(rowOf(each.cut)));
    }
    std::string list;
    for (const auto& [kinds, clash] : clashes) {
      list += (list.empty() ? "" : " · ") + countedName(kinds.first + " / " + kinds.second, clash.pairs) + ", " +
              words_.length(clash.depth);
      std::string cut;
      for (const std::string& name : clash.cut) cut += (cut.empty() ? "" : ", ") + name;
      if (!cut.empty()) list += " (" + say(GLISSADE_TEXT("cut: %1"), {cut}) + ")";
    }
    return list.empty() ? list : say(GLISSADE_TEXT("Accepted clashes: %1"), {list});
  }

  /// Adds the steps of the product, or of a group. `group`: number of the step that brings the group.
  void addLine(const std::vector<AssemblyStep>& steps, const std::vector<SubassemblyLine>& lines, const Ids& base,
               const Vector3& up, const std::string& group) {
    Ids present = base;
    Viewpoint view{0, false, up};
    addStart(base, view, group);
    const std::vector<TaskRange> ranges = taskRanges(steps, made_.parts);
    const PlaceById standsFrom = placesOfSupport(steps);
    for (const TaskRange& range : ranges) {
      if (watch_.stop.stopRequested()) return;
      const SubassemblyLine* line = lineOf(lines, steps.size() - range.place);
      const std::string number = taskNumber(range, group);
      if (line != nullptr) addLine(line->steps, line->lines, baseOf(*line), line->up, number);
      InstructionPanel panel;
      panel.number = number;
      panel.subassembly = group;
      for (std::size_t at = range.place; at < range.place + range.count; ++at) {
        panel.steps.push_back(stepAtPlace(steps, at));
      }
      panel.present = present;
      describe(panel, line != nullptr);
      addHolding(panel, range, ranges, standsFrom, base);
      look(panel, view);
      if (panel.view.turnedOver != view.turnedOver) warnOfLoose(panel, steps, range.place);
      for (const AssemblyStep& step : panel.steps) append(step.bodies(), present);
      view = panel.view;
      made_.panels.push_back(std::move(panel));
      watch_.report(static_cast<double>(range.place + range.count) / static_cast<double>(steps.size()));
    }
  }

  using PlaceById = std::map<BodyId, std::size_t>;

  /// For each body that does not stand by itself when it is brought: the place in the order of assembly of the step
  /// that supports it. Screws and nuts are not held by hand.
  static PlaceById placesOfSupport(const std::vector<AssemblyStep>& steps) {
    PlaceById places;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      for (const BodyId& id : steps[i].falling()) places.try_emplace(id, steps.size() - 1 - i);
    }
    for (const AssemblyStep& step : steps) {
      for (const StepMotion& motion : step.motions) {
        const bool isHeldByItsThread = motion.fastener == FastenerKind::Screw || motion.fastener == FastenerKind::Nut;
        if (isHeldByItsThread) places.erase(motion.body);
      }
    }
    return places;
  }

  /// States which parts are held by hand: those of the panel until the panel of a later step is done, and those that
  /// this panel supports.
  void addHolding(InstructionPanel& panel, const TaskRange& own, const std::vector<TaskRange>& ranges,
                  const PlaceById& standsFrom, const Ids& base) {
    for (const TaskRange& later : ranges) {
      if (later.place <= own.place) continue;
      Ids held;
      for (const AssemblyStep& step : panel.steps) {
        for (const BodyId& id : step.bodies()) {
          const auto place = standsFrom.find(id);
          if (place != standsFrom.end() && contains(later, place->second)) held.push_back(id);
        }
      }
      note(panel, GLISSADE_TEXT("Hold %1 until step %2 is done."), held, taskNumber(later, panel.subassembly));
    }
    Ids brought;
    Ids others;
    std::set<BodyId> said;
    for (const AssemblyStep& step : panel.steps) {
      for (const BodyId& id : step.falling()) {
        if (standsFrom.count(id) == 0 || !said.insert(id).second) continue;
        const bool isOfBase = std::find(base.begin(), base.end(), id) != base.end();
        const bool isThere = std::find(panel.present.begin(), panel.present.end(), id) != panel.present.end();
        (isThere && !isOfBase ? brought : others).push_back(id);
      }
    }
    note(panel, GLISSADE_TEXT("Needs support: %1"), others);
    note(panel, GLISSADE_TEXT("Then let go of %1."), brought);
  }

  void note(InstructionPanel& panel, CatalogueText text, const Ids& parts, const std::string& number = {}) {
    if (!parts.empty()) panel.notes.push_back(say(text, {supported(parts), number}));
  }

  static bool contains(const TaskRange& range, std::size_t place) {
    return place >= range.place && place < range.place + range.count;
  }

  static void append(const Ids& more, Ids& ids) { ids.insert(ids.end(), more.begin(), more.end()); }

  static const SubassemblyLine* lineOf(const std::vector<SubassemblyLine>& lines, std::size_t step) {
    const auto line = std::find_if(lines.begin(), lines.end(), [&](const SubassemblyLine& each) {
      return each.step == step && !each.steps.empty();
    });
    return line == lines.end() ? nullptr : &*line;
  }

  /// The bodies of a group that are there from its beginning.
  static Ids baseOf(const SubassemblyLine& line) {
    Ids base = line.staying;
    for (const StuckBody& stuck : line.stuck) base.push_back(stuck.body);
    return base;
  }

  void addStart(const Ids& base, const Viewpoint& view, const std::string& group) {
    InstructionPanel panel;
    panel.view = view;
    panel.subassembly = group;
    panel.present = base;
    panel.fetched = fetched(base);
    panel.work = panel.fetched.size() == 1 ? say(GLISSADE_TEXT("Put %1 on the bench."),
                                                 {countedName(panel.fetched[0].name, panel.fetched[0].count)})
                                           : say(GLISSADE_TEXT("Put these parts on the bench."));
    if (group.empty() && !made_.incomplete.empty()) panel.notes.push_back(made_.incomplete);
    made_.panels.push_back(std::move(panel));
  }

  const PartsListRow& rowOf(const BodyId& id) {
    if (rowOf_.empty()) {
      for (const PartsListRow& row : made_.parts) {
        for (const BodyId& body : row.bodies) rowOf_[body] = &row;
      }
    }
    return *rowOf_.at(id);
  }

  /// The parts, with equal ones combined, in their order.
  std::vector<FetchedPart> fetched(const Ids& ids) {
    std::vector<FetchedPart> parts;
    std::map<const PartsListRow*, std::size_t> known;
    for (const BodyId& id : ids) {
      const PartsListRow& row = rowOf(id);
      const auto [at, isNew] = known.emplace(&row, parts.size());
      if (isNew) {
        parts.push_back({{id}, partName(row), 1});
      } else {
        ++parts[at->second].count;
      }
    }
    return parts;
  }

  void describe(InstructionPanel& panel, bool isSubassembly) {
    Ids coming;
    for (const AssemblyStep& step : panel.steps) append(step.bodies(), coming);
    if (isSubassembly) {
      panel.fetched = {{coming, say(GLISSADE_TEXT("subassembly %1"), {panel.number}), 1}};
    } else {
      panel.fetched = fetched(coming);
    }
    panel.work = workOf(panel);
    if (mostClamping(panel.steps) >= kCrosswise) {
      panel.notes.push_back(say(GLISSADE_TEXT("Start all by hand, then tighten crosswise.")));
    }
    std::set<std::string> said;
    for (const StepMotion* motion : motionsOf(panel.steps)) {
      if (const std::string note = placeOnRod(*motion); !note.empty() && said.insert(note).second) {
        panel.notes.push_back(note);
      }
    }
    for (const AssemblyStep& step : panel.steps) {
      const StepMotion& opening = step.opening();
      const std::string tool = capitalized(words_.toolName(opening));
      if (!tool.empty() && panel.tool.empty()) panel.tool = tool;
      if (!tool.empty()) needTool(tool, isHeldWithSecond(opening) ? 2 : 1);
      if (!opening.tool.turned.empty()) {
        const std::string note =
            say(GLISSADE_TEXT("Hold %1, turn %2."), {supported({opening.body}), supported({opening.tool.turned})});
        if (said.insert(note).second) panel.notes.push_back(note);
      }
      if (!opening.tool.held.empty()) {
        const std::string held = supported({opening.tool.held});
        const std::string with = words_.heldWith(opening);
        const std::string note = with.empty()                ? say(GLISSADE_TEXT("Hold %1."), {held})
                                 : isHeldWithSecond(opening) ? say(GLISSADE_TEXT("Hold the other %1 with a second %2."),
                                                                   {held, words_.toolName(opening)})
                                                             : say(GLISSADE_TEXT("Hold %1 (%2)."), {held, with});
        if (said.insert(note).second) panel.notes.push_back(note);
      }
    }
  }

  /// True if what is held on the other side is the same part as what is turned: two tools of one size are needed.
  bool isHeldWithSecond(const StepMotion& motion) {
    const StepTool& tool = motion.tool;
    return !tool.held.empty() && tool.heldWith == tool.kind && &rowOf(tool.held) == &rowOf(motion.body);
  }

  /// Lists the tool, or that two of it are needed.
  void needTool(const std::string& tool, std::size_t count) {
    const std::string counted = countedName(tool, count);
    const auto listed = std::find_if(made_.tools.begin(), made_.tools.end(), [&](const std::string& each) {
      return each == tool || each == countedName(tool, 2);
    });
    if (listed == made_.tools.end()) {
      made_.tools.push_back(counted);
    } else if (count > 1) {
      *listed = counted;
    }
  }

  /// The motions of the steps in the order of assembly.
  static std::vector<const StepMotion*> motionsOf(const std::vector<AssemblyStep>& steps) {
    std::vector<const StepMotion*> all;
    for (const AssemblyStep& step : steps) {
      for (const StepMotion* motion : glissade::motionsOf(step, PlanOrder::Assembly)) all.push_back(motion);
    }
    return all;
  }

  /// A sentence for each kind of work, with the parts that it brings: "Insert 3 × bolt. Screw on 3 × nut."
  std::string workOf(const InstructionPanel& panel) const {
    std::vector<std::pair<const StepMotion*, std::string>> sentences;  // a motion of the work, and its parts
    const auto sentenceOf = [&](const StepMotion& motion, const std::string& what) {
      return workSentence(motion, what, words_.words());
    };
    for (const StepMotion* motion : motionsOf(panel.steps)) {
      const Ids bodies = motion->bodies();
      for (const FetchedPart& part : panel.fetched) {
        if (std::find(bodies.begin(), bodies.end(), part.bodies.front()) == bodies.end()) continue;
        const bool isSameWork =
            !sentences.empty() && sentenceOf(*sentences.back().first, {}) == sentenceOf(*motion, {});
        if (!isSameWork) sentences.emplace_back(motion, "");
        std::string& what = sentences.back().second;
        what += (what.empty() ? "" : ", ") + countedName(part.name, part.count);
      }
    }
    std::string work;
    for (const auto& [motion, what] : sentences) work += (work.empty() ? "" : " ") + sentenceOf(*motion, what);
    return work;
  }

  /// Warns of the parts that fall out when the product is turned over: neither a joint nor a part that was put on later
  /// holds them.
  void warnOfLoose(InstructionPanel& panel, const std::vector<AssemblyStep>& steps, std::size_t placed) {
    Ids loose;
    for (std::size_t at = 0; at < placed; ++at) {
      const AssemblyStep& step = stepAtPlace(steps, at);
      const std::size_t lastOpen = steps.size() - placed;  // steps of the plan up to this number are still to come
      const bool isJoined =
          std::any_of(step.motions.begin(), step.motions.end(), [](const auto& each) { return !each.joints.empty(); });
      const bool held = isJoined || std::any_of(step.after.begin(), step.after.end(),
                                                [&](std::size_t other) { return other > lastOpen; });
      for (const StepMotion& motion : step.motions) {
        const double upwards = exitDirection(motion.path).dot(panel.view.up());
        if (!held && upwards < -kFallsOut * panel.view.up().norm()) append(motion.bodies(), loose);
      }
    }
    if (!loose.empty())
      panel.notes.push_back(say(GLISSADE_TEXT("Hold while you turn it over: %1"), {supported(loose)}));
  }

  /// The largest number of steps that screw down the same part.
  static std::size_t mostClamping(const std::vector<AssemblyStep>& steps) {
    std::map<BodyId, std::size_t> clampedBy;
    for (const AssemblyStep& step : steps) {
      std::set<BodyId> clamped;
      for (const StepMotion& motion : step.motions) {
        for (const StepJoint& joint : motion.joints) {
          if (isScrewed(joint.kind)) clamped.insert(joint.clamped.begin(), joint.clamped.end());
        }
      }
      for (const BodyId& id : clamped) ++clampedBy[id];
    }
    std::size_t most = 0;
    for (const auto& [id, count] : clampedBy) most = std::max(most, count);
    return most;
  }

  /// How far a nut that clamps nothing is turned onto its rod, from where it is assembled: nothing stops it there.
  /// Empty for other motions.
  std::string placeOnRod(const StepMotion& motion) {
    for (const StepJoint& joint : motion.joints) {
      const bool isNut = joint.kind == JointKind::Nut || joint.kind == JointKind::Thread;
      const bool isStopped = !joint.clamped.empty();
      if (!isNut || isStopped || joint.body != motion.body || joint.others.empty() || joint.turns <= 0.0) continue;
      const BodyId& rod = joint.others.front();
      const Vector3 out = exitDirection(motion.path);
      const double length = farthest(rod, out) - farthest(joint.body, out);
      const std::string turns = words_.turns(joint.turns);
      const std::string nut = partName(rowOf(joint.body));
      const std::string onto = partName(rowOf(rod));
      if (std::abs(length) < kFlush) {
        return say(GLISSADE_TEXT("%1: %2 {2|turn|turns}, until flush with the end of %3."), {nut, turns, onto});
      }
      if (length < 0.0) return say(GLISSADE_TEXT("%1: %2 {2|turn|turns} onto %3."), {nut, turns, onto});
      return say(GLISSADE_TEXT("%1: %2 {2|turn|turns}, until %3 of %4 stick out."),
                 {nut, turns, words_.length(length), onto});
    }
    return {};
  }

  /// The largest coordinate of the assembled body along a unit direction, metres.
  double farthest(const BodyId& id, const Vector3& direction) const {
    const RigidBody& body = product_.body(id);
    double most = -std::numeric_limits<double>::infinity();
    for (const Vector3& vertex : body.mesh->vertices) most = std::max(most, direction.dot(body.X_WB * vertex));
    return most;
  }

  std::string supported(const Ids& ids) {
    std::string names;
    for (const FetchedPart& part : fetched(ids)) {
      names += (names.empty() ? "" : ", ") + countedName(part.name, part.count);
    }
    return names;
  }

  void look(InstructionPanel& panel, const Viewpoint& before) {
    BodySet present(product_.bodies.size(), false);
    Box3 box;
    for (const std::size_t body : product_.indicesOf(panel.present)) {
      present[body] = true;
      box.extend(boundingBox(*product_.bodies[body].mesh, product_.bodies[body].X_WB));
    }
    for (const AssemblyStep& step : panel.steps) {
      for (const std::size_t body : bodiesOf(step, product_)) present[body] = true;
    }
    panel.view = view_.choose(panel.steps, present, before);
    panel.turn = turnSentence(before, panel.view, words_.words());
    panel.aspect = aspectFrom(panel.view, present);
    for (const AssemblyStep& step : panel.steps) {
      Box3 coming;
      double seen = 0.0;
      for (const std::size_t body : bodiesOf(step, product_)) {
        coming.extend(boundingBox(*product_.bodies[body].mesh, product_.bodies[body].X_WB));
        seen = std::max(seen, view_.shareSeen(body, present, panel.view.toEye()));
      }
      const double whole = box.merged(coming).diagonal().norm();
      if (coming.diagonal().norm() < kSmallShare * whole || seen < kHiddenShare) panel.closeUp = true;
    }
  }

  double aspectFrom(const Viewpoint& from, const BodySet& present) const {
    const Vector3 right = from.up().cross(from.toEye()).normalized();
    const Vector3 up = from.toEye().cross(right);
    Box3 box;
    for (const std::size_t body : bodiesIn(present)) {
      const RigidBody& there = product_.bodies[body];
      for (const Vector3& vertex : there.mesh->vertices) {
        const Vector3 p_W = there.X_WB * vertex;
        box.extend(Vector3(right.dot(p_W), up.dot(p_W), 0.0));
      }
    }
    return box.isEmpty() || box.sizes().y() <= 0.0 ? 1.0 : box.sizes().x() / box.sizes().y();
  }

  const AssemblyPlan& plan_;
  const AssembledProduct& product_;
  const PlanWords& words_;
  const WorkWatch& watch_;
  StepView view_;
  WorkInstruction made_;
  std::map<BodyId, const PartsListRow*> rowOf_;
};

}  // namespace

WorkInstruction workInstruction(const AssemblyPlan& plan, const AssembledProduct& product,
                                const InstructionHeading& heading, const PlanWords& words, const WorkWatch& watch) {
  return Instructor(plan, product, words, watch).instruct(heading);
}

std::string extentText(const WorkInstruction& instruction, const DocumentWords& words) {
  std::size_t parts = 0;
  for (const PartsListRow& row : instruction.parts) parts += row.count;
  const std::size_t coming = parts - std::min(parts, instruction.base);
  return words(instruction.base == 1 ? GLISSADE_TEXT("%1 {1|part|parts} + base, %3 {3|step|steps}")
                                     : GLISSADE_TEXT("%1 {1|part|parts} + base of %2, %3 {3|step|steps}"),
               {std::to_string(coming), std::to_string(instruction.base), std::to_string(instruction.steps)});
}

std::vector<Viewpoint> viewsOfSteps(const WorkInstruction& instruction, const AssemblyPlan& plan) {
  std::map<BodyId, Viewpoint> viewOf;
  for (const InstructionPanel& panel : instruction.panels) {
    if (!panel.subassembly.empty()) continue;
    for (const AssemblyStep& step : panel.steps) viewOf[step.motions.front().body] = panel.view;
  }
  std::vector<Viewpoint> views;
  for (const AssemblyStep& step : plan.steps) views.push_back(viewOf[step.motions.front().body]);
  return views;
}

}  // namespace glissade
