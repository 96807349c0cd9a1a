#include "engine/documents/instruction/instruction_words.h"

#include <algorithm>
#include <optional>

#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// Radians. A motion with a larger rotation is described as turning.
constexpr double kTurns = 0.1;

/// The sentence for a joint that the motion makes. Nothing where the motion is described like that of a part without
/// joints.
std::optional<CatalogueText> sentenceOf(const StepJoint& joint, bool isOwn) {
  switch (joint.kind) {
    case JointKind::Screw: return GLISSADE_TEXT("Screw in %1.");
    case JointKind::Nut: return isOwn ? GLISSADE_TEXT("Screw on %1.") : GLISSADE_TEXT("Screw in %1.");
    case JointKind::Thread: return GLISSADE_TEXT("Screw on %1.");
    case JointKind::Insert: return GLISSADE_TEXT("Press in %1.");
    case JointKind::Pin: return GLISSADE_TEXT("Push in %1.");
    case JointKind::Snap: return GLISSADE_TEXT("Snap in %1.");
    case JointKind::Flexible: return GLISSADE_TEXT("Lay on %1.");
    case JointKind::Permanent:
    case JointKind::Unit: break;
  }
  return std::nullopt;
}

bool isInAHole(const StepMotion& motion) {
  return std::any_of(motion.allowances.begin(), motion.allowances.end(), [](const Allowance& allowance) {
    return allowance.kind == ContactKind::Cylindrical || allowance.kind == ContactKind::Press;
  });
}

bool turnsOnItsWay(const StepMotion& motion) {
  const auto legs = legsOf(motion.path);
  return std::any_of(legs.begin(), legs.end(), [](const MotionLeg& leg) { return leg.turn > kTurns; });
}

}  // namespace

std::string workSentence(const StepMotion& motion, const std::string& what, const DocumentWords& words) {
  if (motion.tool.kind == ToolKind::CirclipPliers) return words(GLISSADE_TEXT("Open %1 into its groove."), {what});
  const std::vector<BodyId> bodies = motion.bodies();
  for (const StepJoint& joint : motion.joints) {
    const bool isOwn = std::find(bodies.begin(), bodies.end(), joint.body) != bodies.end();
    if (const auto sentence = sentenceOf(joint, isOwn)) return words(*sentence, {what});
  }
  if (motion.fastener == FastenerKind::Nut) return words(GLISSADE_TEXT("Screw on %1."), {what});
  if (motion.fastener == FastenerKind::Screw && motion.tool.kind != ToolKind::None)
    return words(GLISSADE_TEXT("Screw in %1."), {what});
  if (motion.method == kFlexible) return words(GLISSADE_TEXT("Lay on %1."), {what});
  if (turnsOnItsWay(motion)) return words(GLISSADE_TEXT("Turn in %1."), {what});
  return words(isInAHole(motion) ? GLISSADE_TEXT("Insert %1.") : GLISSADE_TEXT("Place %1."), {what});
}

std::string turnSentence(const Viewpoint& from, const Viewpoint& to, const DocumentWords& words) {
  const int quarters = (to.quarter - from.quarter + 4) % 4;
  const bool over = from.turnedOver != to.turnedOver;
  // Seen from above, the product turns to the left when the viewpoint moves to the right.
  const bool left = (quarters == 1) != to.turnedOver;
  switch (quarters) {
    case 0: return over ? words(GLISSADE_TEXT("Turn the product over.")) : std::string();
    case 2:
      return words(over ? GLISSADE_TEXT("Turn the product over and by half a turn.")
                        : GLISSADE_TEXT("Turn the product by half a turn."));
    default: break;
  }
  if (over) {
    return words(left ? GLISSADE_TEXT("Turn the product over and to the left.")
                      : GLISSADE_TEXT("Turn the product over and to the right."));
  }
  return words(left ? GLISSADE_TEXT("Turn the product to the left.") : GLISSADE_TEXT("Turn the product to the right."));
}

std::string capitalized(std::string text) {
  if (text.empty()) return text;
  const auto first = static_cast<unsigned char>(text[0]);
  if (first >= 'a' && first <= 'z') text[0] = static_cast<char>(first - 'a' + 'A');
  const bool isLatin = first == 0xC3 && text.size() > 1;  // letters from à to þ in UTF-8, without ÷
  if (isLatin && static_cast<unsigned char>(text[1]) >= 0xA0 && static_cast<unsigned char>(text[1]) != 0xB7) {
    text[1] = static_cast<char>(static_cast<unsigned char>(text[1]) - 0x20);
  }
  return text;
}

}  // namespace glissade
