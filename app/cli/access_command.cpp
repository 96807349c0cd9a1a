#include "app/cli/commands.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "app/cli/plan_printer.h"
#include "app/cli/text_cells.h"
#include "engine/access/plan_access.h"
#include "engine/documents/plan_tasks.h"
#include "engine/documents/plan_words.h"
#include "engine/files/path_reader.h"
#include "engine/files/plan_file.h"
#include "engine/files/product_file.h"
#include "engine/files/scenario_io.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr CatalogueText kSampled = GLISSADE_TEXT(
    "hand, forearm and tool were sampled along each motion: this is no proof of what lies between the "
    "samples, and the rest of the body is not considered");

/// A body is named by its index in `bodies`, because the answers hold that index.
Json toJson(const MotionAccess& motion, const std::vector<RigidBody>& bodies) {
  const auto name = [&bodies](const std::optional<std::size_t>& body) {
    return body ? Json(bodies[*body].id) : Json(nullptr);
  };
  Json json{{"hand", kHandAccessNames.of(motion.hand.access)}, {"tool", kToolNames.of(motion.tool)}};
  if (motion.hand.access == HandAccess::Free || motion.hand.access == HandAccess::Blocked) {
    json["hand_pose"] = poseJson(motion.hand.hold.X_WH);
    json["blocked_at_share"] = motion.hand.access == HandAccess::Free ? Json(nullptr) : Json(motion.hand.share);
    json["blocked_by"] = name(motion.hand.blockedBy);
  }
  json["holds_tried"] = motion.hand.tried;
  json["sight"] = {{"seen", motion.sight.isSeen()},
                   {"share", motion.sight.share},
                   {"eye_m", vectorJson(motion.sight.eye)},
                   {"hidden_by", name(motion.sight.blockedBy)}};
  return json;
}

std::string wholePercent(double share) { return std::to_string(static_cast<int>(std::floor(100.0 * share))) + " %"; }

Message handInWords(const HandAnswer& hand, const std::vector<RigidBody>& bodies) {
  switch (hand.access) {
    case HandAccess::Free: return GLISSADE_TEXT("the hand reaches the work");
    case HandAccess::Blocked:
      if (!hand.blockedBy) {
        return {GLISSADE_TEXT("the hand is blocked at %1 of the motion"), {wholePercent(hand.share)}};
      }
      return {GLISSADE_TEXT("the hand is blocked by '%1' at %2 of the motion"),
              {bodies[*hand.blockedBy].shown(), wholePercent(hand.share)}};
    case HandAccess::NoGrip: return GLISSADE_TEXT("no grasp by one hand was found");
    case HandAccess::NotAsked: break;
  }
  return GLISSADE_TEXT("not checked");
}

Message sightInWords(const SightAnswer& sight, const std::vector<RigidBody>& bodies) {
  if (sight.isSeen() || !sight.blockedBy) {
    return {GLISSADE_TEXT("%1 of the work is visible"), {wholePercent(sight.share)}};
  }
  return {GLISSADE_TEXT("%1 of the work is visible, hidden by '%2'"),
          {wholePercent(sight.share), bodies[*sight.blockedBy].shown()}};
}

Message accessInWords(const MotionAccess& motion, const std::vector<RigidBody>& bodies) {
  Message hand = handInWords(motion.hand, bodies);
  if (motion.tool != ToolKind::None) {
    hand = {GLISSADE_TEXT("%1 with the tool (%2)"), {hand, CatalogueText{kToolNames.of(motion.tool)}}};
  }
  return glissade::joined({hand, sightInWords(motion.sight, bodies)}, "; ");
}

Json header(const AccessOptions& options) {
  return {{"file", options.file}, {"hand", kHandSizeNames.of(options.hand)}, {"sampled", true}};
}

Person personOf(const AccessOptions& options) {
  Person person{options.hand, std::nullopt};
  if (!options.eye.empty()) person.eye = Vector3(options.eye[0], options.eye[1], options.eye[2]);
  return person;
}

int accessExitCode(bool reached) { return reached ? 0 : exitCode(ErrorKind::NoPath); }

int accessOfPath(const AccessOptions& options, const StopToken& stop) {
  const auto loaded = loadScenario(options.file);
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  const auto points = readPath(options.path);
  if (!points) return reportError(points.error(), options.console);
  const auto access = pathAccess(loaded->obstacles, loaded->object, configurationsOf(*points), personOf(options), stop);
  if (!access) return reportError(access.error(), options.console);
  std::vector<RigidBody> bodies = loaded->obstacles;
  bodies.push_back(loaded->object);
  if (options.console.json) {
    Json json = header(options);
    json["path"] = options.path;
    json["place"] = access->beginsAtEnd ? "end" : "start";
    json.update(toJson(access->motion, bodies));
    json["hand"] = kHandSizeNames.of(options.hand);
    json["access"] = kHandAccessNames.of(access->motion.hand.access);
    printJson(json);
  } else {
    options.console.print(accessInWords(access->motion, bodies));
    options.console.print(kSampled);
  }
  return accessExitCode(access->motion.isReachedAndSeen());
}

/// Prints the steps of a line and of its groups. A step of several motions names the motion that decides. The steps of
/// a group are numbered after the step that adds the group, as in the work instruction.
void printLine(const LineAccess& access, const std::vector<AssemblyStep>& steps,
               const std::vector<SubassemblyLine>& lines, const std::string& group, const AssembledProduct& product,
               const Console& console) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string number = toRight(stepNumber(steps.size() - 1 - i, group), 4);
    std::string name = number + "  " + nameOfStep(steps[i], product);
    if (steps[i].motions.size() > 1)
      name += " (" + namesOf(steps[i].motions[access.steps[i].motion].bodies(), product, " + ") + ")";
    console.print({GLISSADE_TEXT("%1: %2"), {name, accessInWords(access.steps[i], product.bodies)}});
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string number = stepNumber(steps.size() - lines[i].step, group);
    printLine(access.lines[i], lines[i].steps, lines[i].lines, number, product, console);
  }
}

void printPlanAccess(const PlanAccess& access, const AssemblyPlan& plan, const AssembledProduct& product,
                     const Console& console) {
  printLine(access, plan.steps, plan.lines, {}, product, console);
  console.print({GLISSADE_TEXT("%1 of %2 {2|step|steps} {1|is|are} reachable and visible for the hand %3"),
                 {access.reached(), access.count(), kHandSizeNames.of(access.person.size)}});
  console.print(kSampled);
}

Json stepsJson(const LineAccess& access, const std::vector<AssemblyStep>& steps, const AssembledProduct& product) {
  Json json = Json::array();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    json.push_back({{"bodies", steps[i].bodies()}});
    json.back().update(toJson(access.steps[i], product.bodies));
    if (steps[i].motions.size() == 1) continue;
    json.back()["motion"] = access.steps[i].motion + 1;
    json.back()["motion_bodies"] = steps[i].motions[access.steps[i].motion].bodies();
  }
  return json;
}

Json linesJson(const LineAccess& access, const std::vector<SubassemblyLine>& lines, const AssembledProduct& product) {
  Json json = Json::array();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    json.push_back({{"step", lines[i].step}, {"steps", stepsJson(access.lines[i], lines[i].steps, product)}});
    Json below = linesJson(access.lines[i], lines[i].lines, product);
    if (!below.empty()) json.back()["lines"] = std::move(below);
  }
  return json;
}

int accessOfPlan(const AccessOptions& options, const StopToken& stop) {
  const auto plan = readPlan(options.plan);
  if (!plan) return reportError(plan.error(), options.console);
  const auto loaded = loadProduct(options.file, stop, plan->deflection, {{}, plan->bodies});
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  const AssembledProduct& product = loaded->product;
  if (const Outcome same = checkSameBodies(*plan, product, options.plan); !same) {
    return reportError(same.error(), options.console);
  }
  const auto access = planAccess(product, *plan, personOf(options), stop);
  if (!access) return reportError(access.error(), options.console);
  if (options.console.json) {
    Json json = header(options);
    json["plan"] = options.plan;
    json["steps"] = stepsJson(*access, plan->steps, product);
    if (!plan->lines.empty()) json["lines"] = linesJson(*access, plan->lines, product);
    json["reached"] = access->reached();
    printJson(json);
  } else {
    printPlanAccess(*access, *plan, product, options.console);
  }
  return accessExitCode(access->reached() == access->count());
}

}  // namespace

int runAccess(const AccessOptions& options) {
  if (options.path.empty() == options.plan.empty()) {
    return reportError(
        {ErrorKind::Usage, options.file, "--path, --plan", GLISSADE_TEXT("one of them is needed, and not both"),
         GLISSADE_TEXT("Give a path of the scenario's object, or an assembly plan.")},
        options.console);
  }
  if (!std::all_of(options.eye.begin(), options.eye.end(), [](double x) { return std::isfinite(x); })) {
    return reportError({ErrorKind::Usage, "", "--eye", GLISSADE_TEXT("is not a place"),
                        GLISSADE_TEXT("Give three numbers in metres.")},
                       options.console);
  }
  const Interrupt interrupt;
  return options.path.empty() ? accessOfPlan(options, interrupt.token()) : accessOfPath(options, interrupt.token());
}

}  // namespace glissade::cli
