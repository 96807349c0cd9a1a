#include "engine/import/step_import.h"

#include <algorithm>
#include <string_view>

#include "engine/base/number_text.h"
#include "engine/import/step_answer.h"
#include "engine/import/step_composition.h"
#include "engine/import/step_ending.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

constexpr std::string_view kBeginning = "ISO-10303-21;";
constexpr std::string_view kEnd = "END-ISO-10303-21;";

/// What a glance at the text tells, before a parser sees it.
std::optional<Diagnostic> precheck(const ImporterCall& call, std::string_view text) {
  constexpr std::size_t kHeader = 65536;
  const std::string_view header = text.substr(0, std::min(text.find("DATA;"), kHeader));
  if (header.find(kBeginning) == std::string_view::npos) {
    return Diagnostic{ErrorKind::MalformedInput, call.file, "",
                      "is not a STEP file (it does not begin with ISO-10303-21)",
                      "Export the part as STEP AP214 or AP242, not compressed and not as XML."};
  }
  const std::size_t schema = header.find("FILE_SCHEMA");
  if (schema != std::string_view::npos && header.find("IFC", schema) != std::string_view::npos) {
    return Diagnostic{ErrorKind::MalformedInput, call.file, "FILE_SCHEMA", "is a building model (IFC), not a product",
                      "Export it as STEP AP214 or AP242."};
  }
  if (text.rfind(kEnd) == std::string_view::npos) return refusalOf(call, "ends before END-ISO-10303-21: it is cut off");
  return std::nullopt;
}

/// Without the files that it names.
Result<StepAnswer> importOneFile(const FileContent& content, double deflection, const StopToken& stop) {
  const std::string millimetres = toText(deflection / protocol::kMillimetre);
  const ImporterCall call{"glissade-import-step",
                          {millimetres},
                          content.file,
                          protocol::stepLimitsFor(content.bytes.size()),
                          "Export it again as STEP AP214 or AP242, or its parts as meshes.",
                          {millimetres, "unnamed"}};
  if (const auto refused = precheck(call, content.bytes)) return *refused;
  auto answer = callImporter(call, content.bytes, stop);
  if (!answer) return answer.error();
  return decodeStepAnswer(call, *answer);
}

}  // namespace

bool isStepFile(const std::string& file) { return hasStepEnding(file); }

Result<StepProduct> importStep(const FileContent& content, double deflection, const StopToken& stop) {
  return composeStepProduct(content, [&](const FileContent& file) { return importOneFile(file, deflection, stop); });
}

Result<StepProduct> importStep(const std::string& file, double deflection, const StopToken& stop) {
  const auto content = readContent(file, protocol::kStepLimits.bytes);
  if (!content) return content.error();
  return importStep(*content, deflection, stop);
}

}  // namespace glissade
