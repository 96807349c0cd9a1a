#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/base/result.h"
#include "engine/fits/assembled_product.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// The plan's document (resources/schema/plan-2.schema.json) without checksum: fixed key order, shortest round-trip
/// numbers. `product` is the file of the product, as the user named it.
nlohmann::ordered_json planJson(const AssemblyPlan& plan, const std::string& product);

/// The JSON schema of plan files: resources/schema/plan-2.schema.json.
nlohmann::ordered_json planSchema();

/// Saves the plan atomically, with a checksum.
Outcome savePlan(const AssemblyPlan& plan, const std::string& product, const std::string& file);

/// Reads a plan of version 1 or 2. Errors are MalformedInput with the JSON pointer as place: a violation of the format,
/// a body that is not in the plan's list or leaves twice, a wrong checksum.
Result<AssemblyPlan> parsePlan(const std::string& text, const std::string& file);
Result<AssemblyPlan> readPlan(const std::string& file);

/// True if the file's "format" is that of an assembly plan.
bool isPlanFile(const std::string& file);

/// Checks that the bodies of the plan are those of the product. Errors: MalformedInput.
Outcome checkSameBodies(const AssemblyPlan& plan, const AssembledProduct& product, const std::string& file);

}  // namespace glissade
