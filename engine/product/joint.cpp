#include "engine/product/joint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace glissade {
namespace {

constexpr std::array<const char*, 9> kJointNames{"screw", "nut",      "thread",    "insert", "pin",
                                                 "snap",  "flexible", "permanent", "unit"};
constexpr std::array<const char*, 3> kJointStateNames{"recognised", "suggested", "confirmed"};
constexpr std::array<const char*, 6> kDriveNames{"none", "hex", "hex_socket", "cross", "slot", "six_lobe"};

template <class Enum, std::size_t N>
std::optional<Enum> enumByName(const std::array<const char*, N>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

bool isSameThread(const std::optional<JointThread>& a, const std::optional<JointThread>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const auto tied = [](const JointThread& thread) {
    return std::tie(thread.diameter, thread.pitch, thread.isPitchStated, thread.engaged, thread.travel);
  };
  return tied(*a) == tied(*b);
}

/// True if all members except indices of bodies are equal; the indices belong to one product.
bool saysTheSame(const Joint& a, const Joint& b) {
  const auto tied = [](const Joint& joint) {
    return std::tie(joint.kind, joint.state, joint.point, joint.direction, joint.drive, joint.driveSize, joint.bend,
                    joint.designation, joint.isDoubtful, joint.evidence);
  };
  return tied(a) == tied(b) && isSameThread(a.thread, b.thread);
}

}  // namespace

const char* jointName(JointKind kind) { return kJointNames[static_cast<std::size_t>(kind)]; }

std::optional<JointKind> jointByName(const std::string& name) { return enumByName<JointKind>(kJointNames, name); }

bool isScrewed(JointKind kind) {
  return kind == JointKind::Screw || kind == JointKind::Nut || kind == JointKind::Thread;
}

const char* jointStateName(JointState state) { return kJointStateNames[static_cast<std::size_t>(state)]; }

std::optional<JointState> jointStateByName(const std::string& name) {
  return enumByName<JointState>(kJointStateNames, name);
}

const char* driveName(DriveKind kind) { return kDriveNames[static_cast<std::size_t>(kind)]; }

std::optional<DriveKind> driveByName(const std::string& name) { return enumByName<DriveKind>(kDriveNames, name); }

double JointThread::turns() const { return pitch == 0.0 ? 0.0 : std::max(engaged, travel) / std::abs(pitch); }

bool JointEdit::operator==(const JointEdit& other) const {
  if (!(key == other.key) || word != other.word || made.has_value() != other.made.has_value() ||
      clamped != other.clamped) {
    return false;
  }
  return !made || saysTheSame(*made, *other.made);
}

}  // namespace glissade
