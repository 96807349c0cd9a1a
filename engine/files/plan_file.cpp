#include "engine/files/plan_file.h"

#include <algorithm>

#include "engine/base/file.h"
#include "engine/base/file_save.h"
#include "engine/base/limits.h"
#include "engine/files/plan_json.h"
#include "engine/import/json_checksum.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

}  // namespace

Outcome savePlan(const AssemblyPlan& plan, const std::string& product, const std::string& file) {
  Json json = planJson(plan, product);
  addChecksum(json);
  const SaveResult saved = saveFile(file, jsonText(json, 2) + "\n");
  return saved ? Outcome(Done{}) : Outcome(saved.why);
}

Result<AssemblyPlan> parsePlan(const std::string& text, const std::string& file) {
  auto document = parseJson(text, file);
  if (!document) return document.error();
  const ChecksumState checksum = takeChecksum(*document);
  try {
    AssemblyPlan plan = PlanDocumentFormat().read(JsonCursor(*document, file, "")).plan;
    if (checksum == ChecksumState::Wrong) {
      return wrongChecksum(file, GLISSADE_TEXT("Plan again. To use an edited plan, remove its checksum."));
    }
    return plan;
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}

Result<AssemblyPlan> readPlan(const std::string& file) {
  const auto text = readFile(file, limits::kMostScenarioBytes);
  if (!text) return text.error();
  return parsePlan(*text, file);
}

bool isPlanFile(const std::string& file) {
  const auto text = readFile(file, limits::kMostScenarioBytes);
  if (!text) return false;
  const std::size_t first = text->find_first_not_of(" \t\r\n");
  if (first == std::string::npos || (*text)[first] != '{') return false;
  const auto document = parseJson(*text, file);
  return document && document->is_object() && document->value("format", Json()) == kPlanFormat;
}

Outcome checkSameBodies(const AssemblyPlan& plan, const AssembledProduct& product, const std::string& file) {
  if (plan.bodies == idsOf(product.bodies)) return Done{};
  const auto missing =
      std::find_if(plan.bodies.begin(), plan.bodies.end(), [&](const BodyId& id) { return !product.find(id); });
  const Message reason = missing != plan.bodies.end()
                             ? Message(GLISSADE_TEXT("is about a product that has '%1'"), {missing->text()})
                             : Message(GLISSADE_TEXT("is about a product with other bodies"));
  return Diagnostic{ErrorKind::MalformedInput, file, "/bodies", reason,
                    GLISSADE_TEXT("Give the product that was planned.")};
}

}  // namespace glissade
