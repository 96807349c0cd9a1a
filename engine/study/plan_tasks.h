#pragma once

#include <string>
#include <vector>

#include "engine/sequence/assembly_plan.h"
#include "engine/study/parts_list.h"

namespace glissade {

/// Steps that follow each other in the order of assembly and are one task: alike screws that clamp the same, or alike
/// parts that come in the same way.
struct TaskRange {
  std::size_t place = 0;  ///< of the first one in the order of assembly, from 0
  std::size_t count = 1;

  bool operator==(const TaskRange&) const = default;
};

/// The tasks of a plan's steps, or of those of a group, in the order of assembly: each step is in one of them. A step
/// that brings a group is a task alone, because the group is put together before it. `parts`: the list of the plan.
std::vector<TaskRange> taskRanges(const std::vector<AssemblyStep>& steps, const std::vector<PartsListRow>& parts);

/// The step at this place in the order of assembly, from 0.
const AssemblyStep& stepAtPlace(const std::vector<AssemblyStep>& steps, std::size_t place);

/// The number that people read of a step in the order of assembly: "3"; "12.3" of a step in the group that step 12
/// brings. `group`: the number of that step, empty: none.
std::string stepNumber(std::size_t place, const std::string& group = {});

/// "3", "3–6", "12.1–12.4".
std::string taskNumber(const TaskRange& range, const std::string& group = {});

}  // namespace glissade
