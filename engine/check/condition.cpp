#include "engine/check/condition.h"

#include "engine/base/depth_text.h"
#include "engine/base/quantity_text.h"

namespace glissade::check {

Condition clashIsAccepted(double depth) {
  return {
      "clashes up to " + depthInMillimetres(depth) + " are accepted (--accept-clashes " + depthAsOption(depth) + ")",
      depth};
}

Condition hookBends(const std::string& hook, const std::string& edge, double bend) {
  return {"the hook of '" + hook + "' in '" + edge + "' bends by " + inMillimetres(bend)};
}

Condition isFlexible(const std::string& body) {
  return {"'" + body + "' is flexible, so that its motion needs no proof"};
}

Condition noJointsAreUsed() { return {"no joints are used"}; }

Condition comesApart(const std::string& body, const std::string& other) {
  return {"the joint of '" + body + "' and '" + other + "' is dissolved or pressed out"};
}

Condition areOneUnit(const std::string& bodies) { return {bodies + " are one unit"}; }

Condition areFixedAsBase(const std::string& bodies) { return {bodies + " stay as the base"}; }

Condition leavesBefore(const std::string& body, const std::string& other) {
  return {"'" + body + "' may leave before '" + other + "', although the reverse is demanded"};
}

Condition leavesAs(const std::string& body, std::size_t number, std::size_t demanded) {
  return {"'" + body + "' may leave as number " + std::to_string(number) + ", although it is demanded as number " +
          std::to_string(demanded)};
}

Condition hasPitch(const std::string& body, const std::string& other, double pitch, double diameter) {
  return {"the thread of '" + body + "' in '" + other + "' has a pitch of " + inMillimetres(pitch) +
          ", which no standard thread of " + inMillimetres(diameter) + " has"};
}

Condition hasOtherPitch(const std::string& body, const std::string& other, double pitch, double said) {
  return {"the thread of '" + body + "' in '" + other + "' has a pitch of " + inMillimetres(pitch) +
          ", although a person says " + inMillimetres(said)};
}

Condition isLeftHanded(const std::string& body, const std::string& other) {
  return {"the thread of '" + body + "' in '" + other + "' is left-handed"};
}

Condition isRightHanded(const std::string& body, const std::string& other) {
  return {"the thread of '" + body + "' in '" + other + "' is right-handed, although a name says left-handed"};
}

}  // namespace glissade::check
