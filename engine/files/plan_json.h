#pragma once

#include "engine/base/json_formats.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

inline constexpr const char* kPlanFormat = "glissade-plan";

/// The content of a plan file.
struct PlanDocument {
  std::string program{};
  std::string product{};  ///< name of the file that was planned
  AssemblyPlan plan{};
};
PlanDocument planDocument(const AssemblyPlan& plan, const std::string& product);

/// Reading throws JsonError. Private to the readers of this folder.
extern template struct ObjectFormat<PlanDocument>;

}  // namespace glissade
