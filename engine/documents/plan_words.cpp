#include "engine/documents/plan_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "engine/fits/contact_report.h"
#include "engine/fits/key_sizes.h"
#include "engine/fits/thread_pitch.h"
#include "engine/model/body_path.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// Cosine of two degrees. A direction nearer to an axis is described as that axis.
constexpr double kAlongAxis = 0.9994;
/// Most legs of a motion that are described separately.
constexpr std::size_t kMostLegs = 3;

std::string decimals(double value, int digits) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

/// A number with the decimal sign of the language.
std::string decimals(double value, int digits, Language language) {
  std::string text = decimals(value, digits);
  if (language == Language::French) std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

std::string degrees(double radians) { return decimals(radians * 180.0 / std::acos(-1.0), 0) + "°"; }

/// The size of the tool for the hexagon that it turns, in millimetres or inches: " 2.5", " 3/16″". The hexagon's size
/// where no tool has that size; empty where it is not known.
std::string sizeOfTool(const StepMotion& motion, Language language) {
  constexpr double kTenths = 1e4;  // tenths of a millimetre per metre
  for (const StepJoint& joint : motion.joints) {
    const bool isHexagon = joint.drive == DriveKind::HexSocket || joint.drive == DriveKind::HexOutside;
    if (joint.body != motion.body || !isHexagon || joint.driveSize <= 0.0) continue;
    const auto key = keyFor(joint.drive, joint.driveSize);
    if (key && key->inches[0] != '\0') return std::string(" ") + key->inches + "″";
    const double tenths = std::round(kTenths * (key ? key->size : joint.driveSize));
    return " " + decimals(0.1 * tenths, std::fmod(tenths, 10.0) == 0.0 ? 0 : 1, language);
  }
  return {};
}

std::string listed(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& each : texts) all += (all.empty() ? "" : "; ") + each;
  return all;
}

/// The designation of the fastener, else the size of its thread, else its name, so that equal fasteners have the same
/// text.
std::string fastenerText(const StepJoint& joint, const AssembledProduct& product) {
  if (!joint.designation.empty()) return joint.designation;
  const std::string size = joint.diameter > 0.0 ? nominalSize(joint.diameter) : std::string();
  return size.empty() ? shownNameOf(joint.body, product) : size;
}

}  // namespace

std::string PlanWords::direction(const Vector3& direction) const {
  static constexpr std::array<CatalogueText, 6> kNames{GLISSADE_TEXT("+X"),      GLISSADE_TEXT("−X"),
                                                       GLISSADE_TEXT("+Y"),      GLISSADE_TEXT("−Y"),
                                                       GLISSADE_TEXT("up (+Z)"), GLISSADE_TEXT("down (−Z)")};
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] > kAlongAxis) return words_(kNames[2 * static_cast<std::size_t>(axis)]);
    if (direction[axis] < -kAlongAxis) return words_(kNames[2 * static_cast<std::size_t>(axis) + 1]);
  }
  return "(" + decimals(direction.x(), 2) + ", " + decimals(direction.y(), 2) + ", " + decimals(direction.z(), 2) + ")";
}

std::string PlanWords::allOf(const std::vector<BodyId>& ids, const AssembledProduct& product) const {
  std::string text;
  for (const BodyId& id : ids) text += (text.empty() ? "" : ", ") + shownNameOf(id, product);
  return text;
}

/// Some of the names, for example "rod, bolt and 3 more".
std::string PlanWords::someOf(const std::vector<BodyId>& ids, const AssembledProduct& product) const {
  constexpr std::size_t kNamed = 2;
  std::string text;
  for (std::size_t i = 0; i < std::min(kNamed, ids.size()); ++i) {
    text += (text.empty() ? "" : ", ") + shownNameOf(ids[i], product);
  }
  return ids.size() <= kNamed ? text
                              : words_(GLISSADE_TEXT("%1 and %2 more"), {text, std::to_string(ids.size() - kNamed)});
}

std::string PlanWords::nameOf(ToolKind kind) const {
  static constexpr std::array<CatalogueText, 6> kTools{CatalogueText{""},
                                                       GLISSADE_TEXT("hex key"),
                                                       GLISSADE_TEXT("socket"),
                                                       GLISSADE_TEXT("screwdriver"),
                                                       GLISSADE_TEXT("open wrench"),
                                                       GLISSADE_TEXT("circlip pliers")};
  return kind == ToolKind::None ? std::string() : words_(kTools[static_cast<std::size_t>(kind)]);
}

std::string PlanWords::turns(double turns) const { return decimals(turns, 1, words_.language()); }

std::string PlanWords::toolName(const StepMotion& motion) const {
  if (motion.tool.kind == ToolKind::None) return {};
  const std::string name = nameOf(motion.tool.kind);
  return motion.tool.turned.empty() ? name + sizeOfTool(motion, words_.language()) : name;
}

std::string PlanWords::tool(const StepMotion& motion, const AssembledProduct& product) const {
  std::string text = toolName(motion);
  if (!motion.tool.turned.empty()) {
    return words_(GLISSADE_TEXT("%1 at %2, %3 is held"),
                  {text, someOf({motion.tool.turned}, product), someOf({motion.body}, product)});
  }
  if (motion.tool.access == ToolAccess::Blocked) {
    text = words_(GLISSADE_TEXT("%1, blocked by %2"), {text, someOf(motion.tool.blockedBy, product)});
  }
  if (motion.tool.held.empty()) return text;
  const std::string held = someOf({motion.tool.held}, product);
  if (motion.tool.heldWith == ToolKind::None) return words_(GLISSADE_TEXT("%1, %2 is held"), {text, held});
  return words_(GLISSADE_TEXT("%1, %2 is held (%3)"), {text, held, heldWith(motion)});
}

std::string PlanWords::standing(const AssemblyStep& step, const AssembledProduct& product) const {
  const std::vector<BodyId> falling = step.falling();
  return falling.empty() ? std::string() : words_(GLISSADE_TEXT("hold %1"), {someOf(falling, product)});
}

std::string PlanWords::support(const AssemblyStep& step, const AssembledProduct& product, PlanOrder order) const {
  const std::vector<BodyId> falling = step.falling();
  if (falling.empty()) return {};
  return words_(order == PlanOrder::Assembly
                    ? GLISSADE_TEXT("Hold until this step is done, because nothing supports it before: %1.")
                    : GLISSADE_TEXT("Hold from this step on, because nothing supports it any more: %1."),
                {allOf(falling, product)});
}

std::vector<std::string> PlanWords::violations(const AssemblyStep& step, const AssembledProduct& product) const {
  std::vector<std::string> texts;
  for (const StepViolation& violation : step.violates) {
    const std::string bodies = someOf(violation.bodies, product);
    switch (violation.rule) {
      case StepViolation::Rule::Before:
        texts.push_back(words_(GLISSADE_TEXT("to be removed before: %1"), {bodies}));
        break;
      case StepViolation::Rule::Fastener:
        texts.push_back(words_(GLISSADE_TEXT("nuts still on it: %1"), {bodies}));
        break;
      case StepViolation::Rule::Standing: texts.push_back(words_(GLISSADE_TEXT("falling: %1"), {bodies})); break;
      case StepViolation::Rule::Joint:
        texts.push_back(words_(GLISSADE_TEXT("still joined to it: %1"), {bodies}));
        break;
      case StepViolation::Rule::Place: texts.push_back(words_(GLISSADE_TEXT("constrained to another place"))); break;
    }
  }
  return texts;
}

std::string PlanWords::isolated(const AssemblyPlan& plan, const AssembledProduct& product) const {
  if (plan.isolated.empty()) return {};
  return words_(GLISSADE_TEXT("Touches nothing and may lie beside the product: %1."), {allOf(plan.isolated, product)});
}

std::vector<std::string> PlanWords::joints(const StepMotion& motion, const AssembledProduct& product,
                                           PlanOrder order) const {
  std::vector<std::string> texts;
  for (const StepJoint& each : motion.joints) {
    std::string text = joint(each, motion, product, order);
    const bool isNew = std::find(texts.begin(), texts.end(), text) == texts.end();
    if (isNew && !text.empty()) texts.push_back(std::move(text));
  }
  return texts;
}

std::string PlanWords::base(const AssemblyPlan& plan, const AssembledProduct& product) const {
  return someOf(plan.staying, product);
}

std::string PlanWords::work(const AssemblyStep& step, const AssembledProduct& product, PlanOrder order) const {
  std::vector<std::string> texts;
  for (const StepMotion* motion : motionsOf(step, order)) {
    std::vector<std::string> own = joints(*motion, product, order);
    if (own.empty()) own = {path(*motion, order)};
    texts.insert(texts.end(), own.begin(), own.end());
  }
  return listed(texts);
}

/// The work on a joint. If a shaft turns out of a nut, the text names the nut.
std::string PlanWords::joint(const StepJoint& joint, const StepMotion& motion, const AssembledProduct& product,
                             PlanOrder order) const {
  const bool removal = order == PlanOrder::Removal;
  const std::vector<BodyId> bodies = motion.bodies();
  const bool isOwn = std::find(bodies.begin(), bodies.end(), joint.body) != bodies.end();
  const std::string what = isOwn ? fastenerText(joint, product) : shownNameOf(joint.body, product);
  const std::string turns = this->turns(joint.turns);
  switch (joint.kind) {
    case JointKind::Screw:
    case JointKind::Nut: {
      if (!isOwn)
        return words_(removal ? GLISSADE_TEXT("unscrew from %1, %2 {2|turn|turns}")
                              : GLISSADE_TEXT("screw into %1, %2 {2|turn|turns}"),
                      {what, turns});
      if (joint.kind == JointKind::Nut) {
        return words_(removal ? GLISSADE_TEXT("unscrew nut %1, %2 {2|turn|turns}")
                              : GLISSADE_TEXT("screw on nut %1, %2 {2|turn|turns}"),
                      {what, turns});
      }
      return words_(
          removal ? GLISSADE_TEXT("unscrew %1, %2 {2|turn|turns}") : GLISSADE_TEXT("screw in %1, %2 {2|turn|turns}"),
          {what, turns});
    }
    case JointKind::Thread: {
      const std::string with = isOwn ? someOf(joint.others, product) : what;
      return words_(removal ? GLISSADE_TEXT("unscrew from %1, %2 {2|turn|turns}")
                            : GLISSADE_TEXT("screw together with %1, %2 {2|turn|turns}"),
                    {with, turns});
    }
    case JointKind::Insert:
      return words_(removal ? GLISSADE_TEXT("press out of %1") : GLISSADE_TEXT("press into %1"),
                    {someOf(joint.others, product)});
    case JointKind::Pin:
      return words_(removal ? GLISSADE_TEXT("pull out of %1") : GLISSADE_TEXT("put into %1"),
                    {someOf(joint.others, product)});
    case JointKind::Snap: return words_(GLISSADE_TEXT("bent by %1"), {length_(joint.bend)});
    case JointKind::Flexible:
      return words_(removal ? GLISSADE_TEXT("remove from %1") : GLISSADE_TEXT("lay on %1"),
                    {someOf(joint.others, product)});
    case JointKind::Permanent:
    case JointKind::Unit: break;
  }
  return {};
}

/// Describes a screw motion; its turns are one leg.
std::string PlanWords::turnedPath(const StepMotion& motion, PlanOrder order) const {
  const MotionLeg last = legsOf(motion.path).back();
  const std::string turns = this->turns(motion.joints.front().turns);
  const bool removal = order == PlanOrder::Removal;
  const Vector3 way = removal ? last.direction : Vector3(-last.direction);
  const std::string straight = direction(way) + ", " + length_(last.length);
  return words_(removal ? GLISSADE_TEXT("unscrew %1 {1|turn|turns}, then %2")
                        : GLISSADE_TEXT("%2, then screw in %1 {1|turn|turns}"),
                {turns, straight});
}

std::string PlanWords::motion(const AssemblyStep& step, PlanOrder order) const {
  std::vector<std::string> texts;
  for (const StepMotion* motion : motionsOf(step, order)) texts.push_back(path(*motion, order));
  return listed(texts);
}

std::string PlanWords::path(const StepMotion& motion, PlanOrder order) const {
  if (!motion.joints.empty() && motion.joints.front().turns > 0.0) return turnedPath(motion, order);
  const auto removal = legsOf(motion.path);
  const auto legs = order == PlanOrder::Assembly ? reversed(removal) : removal;
  if (legs.empty()) return words_(GLISSADE_TEXT("does not move"));
  if (legs.size() > kMostLegs) {
    double length = 0.0;
    double turn = 0.0;
    for (const MotionLeg& leg : legs) {
      length += leg.length;
      turn += leg.turn;
    }
    const Vector3 towards = exitDirection(motion.path);
    const std::string travelled = turn > 0.01 ? length_(length) + ", " + degrees(turn) : length_(length);
    return order == PlanOrder::Removal
               ? words_(GLISSADE_TEXT("around obstacles, %1, out %2"), {travelled, direction(towards)})
               : words_(GLISSADE_TEXT("around obstacles, %1, in %2"), {travelled, direction(-towards)});
  }
  std::string text;
  for (const MotionLeg& leg : legs) {
    if (!text.empty()) text += words_(GLISSADE_TEXT(", then "));
    const std::string turn = leg.turn > 0.0 ? degrees(leg.turn) : "";
    if (leg.length > 0.0 && leg.turn > 0.0) {
      text += words_(GLISSADE_TEXT("%1, %2, turning %3 about %4"),
                     {direction(leg.direction), length_(leg.length), turn, direction(leg.axis)});
    } else if (leg.turn > 0.0) {
      text += words_(GLISSADE_TEXT("turn %1 about %2"), {turn, direction(leg.axis)});
    } else {
      text += direction(leg.direction) + ", " + length_(leg.length);
    }
  }
  return text;
}

std::vector<std::string> PlanWords::allowances(const std::vector<Allowance>& allowances,
                                               const AssembledProduct& product) const {
  std::vector<std::string> texts;
  for (const Allowance& allowance : allowances) {
    const RigidBody& other = product.body(allowance.body);
    const std::string length = length_(allowance.allowance);
    if (allowance.hollow && allowance.kind == ContactKind::Thread) {
      texts.push_back(
          allowance.yields
              ? words_(GLISSADE_TEXT("%1 without what its screw fills (no tapped hole in the file)"), {other.shown()})
              : words_(GLISSADE_TEXT("without what its screw %1 fills (no tapped hole in the file)"), {other.shown()}));
      continue;
    }
    if (allowance.hollow) {
      texts.push_back(allowance.yields
                          ? words_(GLISSADE_TEXT("%1 without what overlaps it, up to %2 deep (accepted clash)"),
                                   {other.shown(), length})
                          : words_(GLISSADE_TEXT("without what overlaps %2, up to %1 deep (accepted clash)"),
                                   {length, other.shown()}));
      continue;
    }
    std::string kind = words_(std::string(kContactKindNames.of(allowance.kind)));
    if (allowance.evidence.byPerson > 0.0) kind += words_(GLISSADE_TEXT(", user-defined"));
    texts.push_back(allowance.yields
                        ? words_(GLISSADE_TEXT("%2 on %1, which gives way (%3)"), {other.shown(), length, kind})
                        : words_(GLISSADE_TEXT("%1 on %2 (%3)"), {length, other.shown(), kind}));
  }
  return texts;
}

std::string nameOfStep(const AssemblyStep& step, const AssembledProduct& product) {
  std::string names;
  for (const StepMotion* motion : motionsOf(step, PlanOrder::Assembly)) {
    for (const BodyId& id : motion->bodies()) names += (names.empty() ? "" : ", ") + shownNameOf(id, product);
  }
  return names;
}

std::string kindOfPart(const std::string& name) { return withoutNumber(lastStepOf(name)); }

std::string kindOfPart(std::size_t body, const AssembledProduct& product) {
  const auto node = product.tree.find(product.bodies[body].id.text());
  const std::string& name = node ? product.tree.nodes()[*node].names.product : product.bodies[body].name;
  return node && !name.empty() ? withoutNumber(name) : kindOfPart(product.bodies[body].name);
}

std::string countedName(const std::string& name, std::size_t count) {
  return count == 1 ? name : std::to_string(count) + " × " + name;
}

std::string shownNameOf(const BodyId& id, const AssembledProduct& product) {
  const auto body = product.find(id);
  return body ? product.bodies[*body].shown() : id.text();
}

}  // namespace glissade
