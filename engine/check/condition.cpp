#include "engine/check/condition.h"

#include "engine/base/depth_text.h"
#include "engine/check/verdict_words.h"

namespace glissade::check {
namespace {

/// "'a', 'b', 'c'" or, for many, "'a', 'b', 'c', … (17)".
Message shortListOf(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNames = 3;
  if (names.size() <= kMostNames) return namesInWords(names);
  const Message first = namesInWords({names.begin(), names.begin() + kMostNames});
  return {GLISSADE_TEXT("%1, … (%2)"), {first, names.size()}};
}

}  // namespace

Condition clashIsAccepted(double depth) {
  return {{GLISSADE_TEXT("clashes up to %1 are accepted (--accept-clashes %2)"), {Depth{depth}, depthAsOption(depth)}},
          depth,
          {}};
}

Condition isTheOneCut(const std::string& body, const std::string& option) {
  return {{GLISSADE_TEXT("'%1' is the one that is cut (--cut \"%2\")"), {body, option}}, 0.0, option};
}

Condition hookBends(const std::string& hook, const std::string& edge, double bend) {
  return {{GLISSADE_TEXT("the hook of '%1' in '%2' bends by %3"), {hook, edge, Length{bend}}}};
}

Condition isFlexible(const std::string& body) {
  return {{GLISSADE_TEXT("'%1' is flexible, so that its motion needs no certificate"), {body}}};
}

Condition noJointsAreUsed() { return {GLISSADE_TEXT("no joints are used")}; }

Condition comesApart(const std::string& body, const std::string& other) {
  return {{GLISSADE_TEXT("the joint of '%1' and '%2' is dissolved or pressed out"), {body, other}}};
}

Condition areOneUnit(const std::vector<std::string>& bodies) {
  return {{GLISSADE_TEXT("%1 are one unit"), {shortListOf(bodies)}}};
}

Condition areFixedAsBase(const std::vector<std::string>& bodies) {
  return {{GLISSADE_TEXT("%1 are fixed as base"), {shortListOf(bodies)}}};
}

Condition leavesBefore(const std::string& body, const std::string& other) {
  return {{GLISSADE_TEXT("'%1' may be removed before '%2', although a constraint states the reverse"), {body, other}}};
}

Condition leavesAs(const std::string& body, std::size_t number, std::size_t demanded) {
  return {{GLISSADE_TEXT("'%1' may be removed as number %2, although a constraint states number %3"),
           {body, number, demanded}}};
}

Condition hasPitch(const std::string& body, const std::string& other, double pitch, double diameter) {
  return {{GLISSADE_TEXT("the thread of '%1' in '%2' has a pitch of %3, which no standard thread of %4 has"),
           {body, other, Length{pitch}, Length{diameter}}}};
}

Condition hasOtherPitch(const std::string& body, const std::string& other, double pitch, double said) {
  return {{GLISSADE_TEXT("the thread of '%1' in '%2' has a pitch of %3, although the user states %4"),
           {body, other, Length{pitch}, Length{said}}}};
}

Condition isLeftHanded(const std::string& body, const std::string& other) {
  return {{GLISSADE_TEXT("the thread of '%1' in '%2' is left-handed"), {body, other}}};
}

Condition isRightHanded(const std::string& body, const std::string& other) {
  return {
      {GLISSADE_TEXT("the thread of '%1' in '%2' is right-handed, although a name says left-handed"), {body, other}}};
}

}  // namespace glissade::check
