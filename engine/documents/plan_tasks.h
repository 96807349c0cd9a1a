#pragma once

#include <string>
#include <vector>

#include "engine/documents/parts_list.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// Consecutive steps in the order of assembly that are one task: equal screws that clamp the same parts, or equal parts
/// that come in the same way.
struct TaskRange {
  std::size_t place = 0;  ///< index of the first step in the order of assembly, from 0
  std::size_t count = 1;

  bool operator==(const TaskRange&) const = default;
};

/// The tasks of a plan's or a group's steps, in the order of assembly. Each step is in one of them. A step that brings
/// a group is a task of its own, because the group is put together before it. `parts`: the parts list of the plan.
std::vector<TaskRange> taskRanges(const std::vector<AssemblyStep>& steps, const std::vector<PartsListRow>& parts);

/// The step at this place in the order of assembly, from 0.
const AssemblyStep& stepAtPlace(const std::vector<AssemblyStep>& steps, std::size_t place);

/// The number of a step in the order of assembly for people: "3", or "12.3" for a step in the group that step 12
/// brings. `group`: the number of that step; empty: none.
std::string stepNumber(std::size_t place, const std::string& group = {});

/// The numbers of a task's steps: "3", "3–6", "12.1–12.4".
std::string taskNumber(const TaskRange& range, const std::string& group = {});

}  // namespace glissade
