#include "engine/documents/instruction/instruction_template.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/enum_names.h"
#include "engine/base/file.h"
#include "engine/base/json_reader.h"
#include "engine/base/limits.h"

namespace glissade {
namespace {

constexpr const char* kTemplateFormat = "glissade-instruction-template";
constexpr int kTemplateVersion = 1;
constexpr EnumNames<PartsColumn, kAllPartsColumns.size()> kColumnNames{
    {"picture", "part", "designation", "count", "steps"}};

std::vector<PartsColumn> columnsIn(const JsonCursor& at) {
  std::vector<PartsColumn> columns;
  const std::size_t count = at.sizeUpTo(kAllPartsColumns.size());
  if (count == 0)
    at.fail(GLISSADE_TEXT("names no column"), GLISSADE_TEXT("Name at least one column, or leave the member out."));
  for (std::size_t i = 0; i < count; ++i) {
    const PartsColumn column = at.element(i).named(kColumnNames);
    if (std::find(columns.begin(), columns.end(), column) != columns.end()) {
      at.element(i).fail(GLISSADE_TEXT("is given twice"), GLISSADE_TEXT("Name each column once."));
    }
    columns.push_back(column);
  }
  return columns;
}

/// Reads the logo's path, which must be below the template's folder, so that a template from elsewhere cannot read
/// other files.
std::string logoIn(const JsonCursor& at) {
  namespace fs = std::filesystem;
  const fs::path named(at.exactText());
  const bool leaves = std::find(named.begin(), named.end(), "..") != named.end();
  if (named.is_absolute() || leaves) {
    at.fail(GLISSADE_TEXT("is not below the folder of the template"),
            GLISSADE_TEXT("Copy the picture beside the template and give its name."));
  }
  const std::string file = fs::absolute(fs::path(at.file()).parent_path() / named).lexically_normal().string();
  const auto bytes = readFile(file, kMostLogoBytes);
  if (!bytes) throw JsonError{bytes.error()};
  if (pictureType(*bytes).empty())
    at.fail(GLISSADE_TEXT("is neither a PNG nor a JPEG picture"), GLISSADE_TEXT("Save the logo as PNG."));
  return file;
}

InstructionTemplate templateIn(const JsonCursor& at) {
  at.allowOnly({"format", "version", "description", "company", "document", "logo", "columns", "language", "paper"});
  if (at.at("format").text() != kTemplateFormat) at.at("format").fail({GLISSADE_TEXT("is not %1"), {kTemplateFormat}});
  if (at.at("version").number() != kTemplateVersion) {
    at.at("version").fail({GLISSADE_TEXT("is not %1"), {kTemplateVersion}});
  }
  InstructionTemplate made;
  if (const auto company = at.find("company")) made.company = company->nonEmptyText();
  if (const auto document = at.find("document")) made.document = document->nonEmptyText();
  if (const auto columns = at.find("columns")) made.columns = columnsIn(*columns);
  if (const auto language = at.find("language")) {
    made.language = languageOf(language->text());
    if (!made.language)
      language->fail(GLISSADE_TEXT("is no language of the instructions"), GLISSADE_TEXT("Take en or fr."));
  }
  if (const auto paper = at.find("paper")) {
    made.paper = paperNamed(paper->text());
    if (!made.paper) paper->fail(GLISSADE_TEXT("is no paper of the instructions"), GLISSADE_TEXT("Take A4 or Letter."));
  }
  if (const auto logo = at.find("logo")) made.logo = logoIn(*logo);
  return made;
}

}  // namespace

PaperSize sizeOf(Paper paper) { return paper == Paper::A4 ? PaperSize{210.0, 297.0} : PaperSize{215.9, 279.4}; }

const char* name(Paper paper) { return paper == Paper::A4 ? "A4" : "Letter"; }

std::optional<Paper> paperNamed(const std::string& word) {
  for (const Paper paper : {Paper::A4, Paper::Letter}) {
    if (word == name(paper)) return paper;
  }
  return std::nullopt;
}

std::string titleOf(PartsColumn column, const DocumentWords& words) {
  static constexpr std::array<CatalogueText, kAllPartsColumns.size()> kTitles{
      CatalogueText{""}, GLISSADE_TEXT("Part"), GLISSADE_TEXT("Designation"), GLISSADE_TEXT("Count"),
      GLISSADE_TEXT("Steps")};
  return words(kTitles[static_cast<std::size_t>(column)]);
}

std::string pictureType(const std::string& bytes) {
  if (bytes.rfind("\x89PNG\r\n\x1a\n", 0) == 0) return "image/png";
  if (bytes.rfind("\xff\xd8\xff", 0) == 0) return "image/jpeg";
  return {};
}

Result<InstructionTemplate> readInstructionTemplate(const std::string& file) {
  const auto text = readFile(file, limits::kMostScenarioBytes);
  if (!text) return text.error();
  return readJson(*text, file, templateIn);
}

}  // namespace glissade
