#include "engine/documents/instruction/instruction_template.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/file.h"
#include "engine/base/json_formats.h"
#include "engine/base/limits.h"

namespace glissade {
namespace {

constexpr EnumNames<PartsColumn, kAllPartsColumns.size()> kColumnNames{
    {"picture", "part", "designation", "count", "steps"}};
constexpr EnumNames<Language, 2> kLanguageCodes{{"en", "fr"}};
constexpr EnumNames<Paper, 2> kPaperNames{{"A4", "Letter"}};

/// Distinct columns, at least one.
struct ColumnsFormat {
  std::vector<PartsColumn> read(const JsonCursor& at) const {
    if (at.size() == 0)
      at.fail(GLISSADE_TEXT("names no column"), GLISSADE_TEXT("Name at least one column, or leave the member out."));
    std::vector<PartsColumn> columns = listOf(named(kColumnNames), 1, kAllPartsColumns.size()).read(at);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto end = columns.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::find(columns.begin(), end, columns[i]) != end)
        at.element(i).fail(GLISSADE_TEXT("is given twice"), GLISSADE_TEXT("Name each column once."));
    }
    return columns;
  }
  JsonCursor::Json write(const std::vector<PartsColumn>& columns) const {
    return listOf(named(kColumnNames)).write(columns);
  }
  JsonCursor::Json schema(SchemaDefinitions& definitions) const {
    JsonCursor::Json list = listOf(named(kColumnNames), 1).schema(definitions);
    list["uniqueItems"] = true;
    return list;
  }
};

/// The logo's path, which must be below the template's folder, so that a template from elsewhere cannot read other
/// files. The value is the absolute path.
constexpr FunctionFormat kLogo{
    [](const JsonCursor& at) {
      namespace fs = std::filesystem;
      const fs::path named(at.exactText());
      const bool leaves = std::find(named.begin(), named.end(), "..") != named.end();
      if (named.is_absolute() || leaves) {
        at.fail(GLISSADE_TEXT("is not below the folder of the template"),
                GLISSADE_TEXT("Copy the picture beside the template and give its name."));
      }
      std::string file = fs::absolute(fs::path(at.file()).parent_path() / named).lexically_normal().string();
      const auto bytes = readFile(file, kMostLogoBytes);
      if (!bytes) throw JsonError{bytes.error()};
      if (pictureType(*bytes).empty())
        at.fail(GLISSADE_TEXT("is neither a PNG nor a JPEG picture"), GLISSADE_TEXT("Save the logo as PNG."));
      return file;
    },
    kAsItIs, R"({"type": "string", "minLength": 1})"};

}  // namespace

template <class Archive>
void describe(Archive& made, Type<InstructionTemplate> /*type*/) {
  using Template = InstructionTemplate;
  made.type("instruction_template",
            "A company's settings for the work instructions that Glissade writes. What is left out keeps its default.");
  made.constant("format", "glissade-instruction-template");
  made.constant("version", 1);
  made.ignored("description", kText);
  made.optional("company", &Template::company, kNonEmptyText, "Name in the head of each page.");
  made.optional("document", &Template::document, kNonEmptyText,
                "Number and revision of the document, as \"WI-012, revision B\", in the foot of each page.");
  made.optional("logo", &Template::logo, kLogo,
                "A PNG or JPEG file of at most 4 MiB, relative to the folder of the template and not above it, in the "
                "head of each page.");
  made.optional("columns", &Template::columns, ColumnsFormat(), "Columns of the parts list, in this order.");
  made.optional("language", &Template::language, named(kLanguageCodes), "Absent: the language of the window.");
  made.optional("paper", &Template::paper, named(kPaperNames), "Absent: the paper that is selected in the window.");
}

PaperSize sizeOf(Paper paper) { return paper == Paper::A4 ? PaperSize{210.0, 297.0} : PaperSize{215.9, 279.4}; }

const char* name(Paper paper) { return kPaperNames.of(paper); }

std::optional<Paper> paperNamed(const std::string& word) { return kPaperNames.find(word); }

nlohmann::ordered_json instructionTemplateSchema() {
  return describedSchema<InstructionTemplate>("Template of work instructions");
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
  return readJson(*text, file, readDescribed<InstructionTemplate>);
}

}  // namespace glissade
