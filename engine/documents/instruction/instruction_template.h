#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/documents/document_words.h"

namespace glissade {

/// Paper sizes of printed instructions, upright.
enum class Paper { A4, Letter };

struct PaperSize {
  double width = 0.0;   ///< millimetres
  double height = 0.0;  ///< millimetres
};
PaperSize sizeOf(Paper paper);

/// The name "A4" or "Letter".
const char* name(Paper paper);
std::optional<Paper> paperNamed(const std::string& name);

/// A column of the parts list.
enum class PartsColumn { Picture, Part, Designation, Count, Steps };
inline constexpr std::array<PartsColumn, 5> kAllPartsColumns{
    PartsColumn::Picture, PartsColumn::Part, PartsColumn::Designation, PartsColumn::Count, PartsColumn::Steps};

/// The heading of the column; empty for pictures.
std::string titleOf(PartsColumn column, const DocumentWords& words);

/// A company's settings for its work instructions.
struct InstructionTemplate {
  std::string company{};   ///< name in the head of each page; empty: none
  std::string document{};  ///< number and revision of the document, in the foot of each page; empty: none
  std::string logo{};      ///< absolute path of a PNG or JPEG file; empty: none
  std::vector<PartsColumn> columns{kAllPartsColumns.begin(), kAllPartsColumns.end()};  ///< columns in this order
  std::optional<Language> language{};  ///< nothing: the window's language
  std::optional<Paper> paper{};        ///< nothing: the window's choice

  bool operator==(const InstructionTemplate&) const = default;
};

/// Reads a template: resources/schema/instruction-template-1.schema.json. Errors: MalformedInput with the JSON pointer
/// as place; those of reading the logo, which must be a PNG or JPEG file beside the template or below its folder.
Result<InstructionTemplate> readInstructionTemplate(const std::string& file);

/// The JSON schema of templates.
nlohmann::ordered_json instructionTemplateSchema();

/// Largest size of a logo's file.
inline constexpr std::size_t kMostLogoBytes = 4U << 20;

/// Media type of a picture by its first bytes: "image/png" or "image/jpeg"; empty: neither.
std::string pictureType(const std::string& bytes);

}  // namespace glissade
