#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/base/message.h"

namespace glissade::check {

/// A statement of a plan that no scenario and no person confirms, and on which a verdict depends.
struct Condition {
  Message text;                ///< text for people, to follow "valid only if"
  double acceptedClash = 0.0;  ///< metres: clashes up to this overlap are accepted; 0: another condition
  std::string cut{};           ///< name of a body that is cut in accepted clashes; empty: another condition

  bool operator==(const Condition&) const = default;
};

// All conditions that a plan may state. Bodies by their names for people, lengths in metres.

Condition clashIsAccepted(double depth);
/// `option`: the name by which a person names the body (--cut).
Condition isTheOneCut(const std::string& body, const std::string& option);
Condition hookBends(const std::string& hook, const std::string& edge, double bend);
Condition isFlexible(const std::string& body);
Condition noJointsAreUsed();
Condition comesApart(const std::string& body, const std::string& other);
Condition areOneUnit(const std::vector<std::string>& bodies);
Condition areFixedAsBase(const std::vector<std::string>& bodies);
Condition leavesBefore(const std::string& body, const std::string& other);
/// `number`, `demanded`: places in the order of removal, from 1.
Condition leavesAs(const std::string& body, std::size_t number, std::size_t demanded);
Condition hasPitch(const std::string& body, const std::string& other, double pitch, double diameter);
/// `said`: the pitch that a person states.
Condition hasOtherPitch(const std::string& body, const std::string& other, double pitch, double said);
Condition isLeftHanded(const std::string& body, const std::string& other);
Condition isRightHanded(const std::string& body, const std::string& other);

}  // namespace glissade::check
