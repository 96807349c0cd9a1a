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

/// Reads documents of version 1 or 2. Reading throws JsonError. Private to the readers of this folder.
struct PlanDocumentFormat {
  PlanDocument read(const JsonCursor& at) const;
  JsonCursor::Json write(const PlanDocument& document) const;
  JsonCursor::Json schema(SchemaDefinitions& definitions) const;
};

}  // namespace glissade
