#include "engine/scenario/scenario_migrations.h"

#include <vector>

#include "engine/scenario/scenario_format.h"

namespace glissade {
namespace {

/// Entry k turns a document of version k + 1 into one of version k + 2; the last one reaches kVersion.
using Migration = void (*)(Json& document);
std::vector<Migration> migrations() { return {}; }

}  // namespace

void migrateScenario(Json& document) {
  const JsonCursor root(document);
  const JsonCursor format = root.at("format");
  if (format.text() != scenario_format::kName) {
    format.fail("this is not a scenario", "Give a file whose format is 'glissade-scenario'.");
  }
  const JsonCursor versionCursor = root.at("version");
  const std::uint64_t version = versionCursor.wholeNumber();
  if (version > scenario_format::kVersion) {
    versionCursor.fail(
        "the file was written by a newer Glissade (version " + std::to_string(version) + " of the format)",
        "Update Glissade; this one reads up to version " + std::to_string(scenario_format::kVersion) + ".");
  }
  if (version == 0) versionCursor.fail("there is no version 0 of the format");
  const std::vector<Migration> steps = migrations();
  for (std::size_t step = version - 1; step < steps.size(); ++step) steps[step](document);
}

}  // namespace glissade
