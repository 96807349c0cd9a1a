#include "engine/import/step_import.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/base/number_text.h"
#include "engine/import/cad_kind.h"
#include "engine/import/covered_surfaces.h"
#include "engine/import/iges_text_check.h"
#include "engine/import/step_answer.h"
#include "engine/import/step_composition.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

constexpr std::string_view kBeginning = "ISO-10303-21;";
constexpr std::string_view kEnd = "END-ISO-10303-21;";

/// Checks the text quickly before a parser reads it.
std::optional<Diagnostic> precheckStep(const ImporterCall& call, std::string_view text) {
  constexpr std::size_t kHeader = 65536;
  const std::string_view header = text.substr(0, std::min(text.find("DATA;"), kHeader));
  if (header.find(kBeginning) == std::string_view::npos) {
    return Diagnostic{ErrorKind::MalformedInput, call.file, "",
                      GLISSADE_TEXT("is not a STEP file (it does not begin with ISO-10303-21)"),
                      GLISSADE_TEXT("Export the part as STEP AP214 or AP242, not compressed and not as XML.")};
  }
  const std::size_t schema = header.find("FILE_SCHEMA");
  if (schema != std::string_view::npos && header.find("IFC", schema) != std::string_view::npos) {
    return Diagnostic{ErrorKind::MalformedInput, call.file, "FILE_SCHEMA",
                      GLISSADE_TEXT("is a building model (IFC), not a product"),
                      GLISSADE_TEXT("Export it as STEP AP214 or AP242.")};
  }
  if (text.rfind(kEnd) == std::string_view::npos) {
    return refusalOf(call, GLISSADE_TEXT("ends before END-ISO-10303-21: it is cut off"));
  }
  return std::nullopt;
}

std::optional<Diagnostic> precheckIges(const ImporterCall& call, std::string_view text) {
  const auto fault = faultOfIgesText(text);
  if (!fault) return std::nullopt;
  return refusalOf(call, {GLISSADE_TEXT("cannot be read as %1: %2"), {nameOf(CadKind::Iges), *fault}});
}

std::optional<Diagnostic> precheckBrep(const ImporterCall& call, std::string_view text) {
  constexpr std::size_t kHeader = 1024;
  const std::string_view header = text.substr(0, kHeader);
  if (header.find("Open CASCADE Topology") != std::string_view::npos) {
    return refusalOf(call, GLISSADE_TEXT("is a binary BREP file, which is not read: write it as text"));
  }
  if (header.find("CASCADE Topology V") == std::string_view::npos) {
    return refusalOf(call, GLISSADE_TEXT("is not a BREP file (it does not begin with 'CASCADE Topology V')"));
  }
  return std::nullopt;
}

std::optional<Diagnostic> precheck(CadKind kind, const ImporterCall& call, std::string_view text) {
  switch (kind) {
    case CadKind::Step: return precheckStep(call, text);
    case CadKind::Iges: return precheckIges(call, text);
    case CadKind::Brep: return precheckBrep(call, text);
  }
  return std::nullopt;
}

/// `arguments`: arguments after the kind.
ImporterCall callFor(const FileContent& content, const std::vector<std::string>& arguments) {
  const CadKind kind = cadKindOf(content.file).value_or(CadKind::Step);
  ImporterCall call{"glissade-import-step",
                    {nameOf(kind)},
                    content.file,
                    protocol::stepLimitsFor(content.bytes.size()),
                    GLISSADE_TEXT("Export it again as STEP AP214 or AP242, or its parts as meshes.")};
  call.arguments.insert(call.arguments.end(), arguments.begin(), arguments.end());
  return call;
}

Result<ImporterAnswer> run(const ImporterCall& call, const FileContent& content, const StopToken& stop) {
  const CadKind kind = cadKindOf(content.file).value_or(CadKind::Step);
  if (const auto refused = precheck(kind, call, content.bytes)) return *refused;
  return callImporter(call, content.bytes, stop);
}

/// Imports the file without the files that it names.
Result<StepAnswer> importOneFile(const FileContent& content, double deflection, const StopToken& stop) {
  ImporterCall call = callFor(content, {toText(deflection / protocol::kMillimetre)});
  call.argumentsAfterCrash = call.arguments;
  call.argumentsAfterCrash.emplace_back("unnamed");
  auto answer = run(call, content, stop);
  if (!answer) return answer.error();
  return decodeStepAnswer(call, *answer);
}

}  // namespace

Result<std::vector<std::optional<double>>> commonVolumes(const std::string& file,
                                                         const std::vector<std::pair<std::string, std::string>>& parts,
                                                         const StopToken& stop) {
  std::vector<std::optional<double>> volumes(parts.size());
  if (parts.empty()) return volumes;
  const auto content = readContent(file, protocol::kStepLimits.bytes);
  if (!content) return content.error();
  std::vector<std::string> arguments{protocol::kVolumesOf};
  for (const auto& [a, b] : parts) arguments.insert(arguments.end(), {a, b});
  const ImporterCall call = callFor(*content, arguments);
  auto answer = run(call, *content, stop);
  if (!answer) return answer.error();
  std::vector<double> stated(parts.size());
  if (answer->header.kind != protocol::kVolumes || !answer->message.take(stated.data(), stated.size())) {
    return refusalOf(call, GLISSADE_TEXT("the importer failed on it"));
  }
  constexpr double kCubicMillimetre = protocol::kMillimetre * protocol::kMillimetre * protocol::kMillimetre;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    if (std::isfinite(stated[i])) volumes[i] = std::max(0.0, stated[i]) * kCubicMillimetre;
  }
  return volumes;
}

bool isCadFile(const std::string& file) { return cadKindOf(file).has_value(); }

Result<StepProduct> importStep(const FileContent& content, double deflection, const StopToken& stop) {
  auto product =
      composeStepProduct(content, [&](const FileContent& file) { return importOneFile(file, deflection, stop); });
  if (product) leaveOutCoveredSurfaces(*product, content.file);
  return product;
}

Result<StepProduct> importStep(const std::string& file, double deflection, const StopToken& stop) {
  const auto content = readContent(file, protocol::kStepLimits.bytes);
  if (!content) return content.error();
  return importStep(*content, deflection, stop);
}

}  // namespace glissade
