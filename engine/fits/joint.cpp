#include "engine/fits/joint.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace glissade {
namespace {

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

bool isScrewed(JointKind kind) {
  return kind == JointKind::Screw || kind == JointKind::Nut || kind == JointKind::Thread;
}

double JointThread::turns() const { return pitch == 0.0 ? 0.0 : std::max(engaged, travel) / std::abs(pitch); }

bool JointEdit::operator==(const JointEdit& other) const {
  if (!(key == other.key) || word != other.word || made.has_value() != other.made.has_value() ||
      clamped != other.clamped) {
    return false;
  }
  return !made || saysTheSame(*made, *other.made);
}

}  // namespace glissade
