#include "engine/documents/plan_tasks.h"

#include <algorithm>

#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// Cosine of the largest angle between two motions of the same direction.
constexpr double kSameDirection = 0.99;

bool isOneKind(const StepMotion& a, const StepMotion& b, const std::vector<PartsListRow>& parts) {
  return std::any_of(parts.begin(), parts.end(), [&](const PartsListRow& row) {
    const auto has = [&row](const BodyId& id) {
      return std::find(row.bodies.begin(), row.bodies.end(), id) != row.bodies.end();
    };
    return has(a.body) && has(b.body);
  });
}

bool areAlike(const StepMotion& a, const StepMotion& b, const std::vector<PartsListRow>& parts) {
  const bool haveJoints = !a.joints.empty() && !b.joints.empty();
  const bool areJoinedAlike =
      haveJoints ? a.joints.front().kind == b.joints.front().kind : a.joints.empty() && b.joints.empty();
  return areJoinedAlike && a.tool.kind == b.tool.kind && isOneKind(a, b, parts) &&
         exitDirection(a.path).dot(exitDirection(b.path)) > kSameDirection;
}

bool areAlike(const AssemblyStep& a, const AssemblyStep& b, const std::vector<PartsListRow>& parts) {
  return std::equal(a.motions.begin(), a.motions.end(), b.motions.begin(), b.motions.end(),
                    [&](const StepMotion& one, const StepMotion& other) { return areAlike(one, other, parts); });
}

bool bringsGroup(const AssemblyStep& step) { return !step.motions.front().with.empty(); }

}  // namespace

std::vector<TaskRange> taskRanges(const std::vector<AssemblyStep>& steps, const std::vector<PartsListRow>& parts) {
  std::vector<TaskRange> ranges;
  for (std::size_t place = 0; place < steps.size(); ++place) {
    const AssemblyStep& step = stepAtPlace(steps, place);
    const auto goesOnWith = [&](const AssemblyStep& before) {
      const bool isOneTask = step.task != 0 && step.task == before.task;
      return !bringsGroup(step) && !bringsGroup(before) && (isOneTask || areAlike(before, step, parts));
    };
    if (place > 0 && goesOnWith(stepAtPlace(steps, place - 1))) {
      ++ranges.back().count;
    } else {
      ranges.push_back({place, 1});
    }
  }
  return ranges;
}

const AssemblyStep& stepAtPlace(const std::vector<AssemblyStep>& steps, std::size_t place) {
  return steps[steps.size() - 1 - place];
}

std::string stepNumber(std::size_t place, const std::string& group) {
  return (group.empty() ? "" : group + ".") + std::to_string(place + 1);
}

std::string taskNumber(const TaskRange& range, const std::string& group) {
  const std::string first = stepNumber(range.place, group);
  return range.count == 1 ? first : first + "–" + stepNumber(range.place + range.count - 1, group);
}

}  // namespace glissade
