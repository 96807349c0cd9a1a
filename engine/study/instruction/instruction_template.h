#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/study/study_words.h"

namespace glissade {

/// Sheets that instructions are printed on, upright.
enum class Paper { A4, Letter };

struct PaperSize {
  double width = 0.0;   ///< millimetres
  double height = 0.0;  ///< millimetres
};
PaperSize sizeOf(Paper paper);

/// "A4" or "Letter".
const char* name(Paper paper);
std::optional<Paper> paperNamed(const std::string& name);

/// A column of the parts list.
enum class PartsColumn { Picture, Part, Designation, Count, Steps };
inline constexpr std::array<PartsColumn, 5> kAllPartsColumns{
    PartsColumn::Picture, PartsColumn::Part, PartsColumn::Designation, PartsColumn::Count, PartsColumn::Steps};

/// What stands over the column; empty over pictures.
std::string titleOf(PartsColumn column, const StudyWords& words);

/// What a company changes of its work instructions.
struct InstructionTemplate {
  std::string company{};   ///< in the head of each page; empty: none
  std::string document{};  ///< its number and revision, in the foot of each page; empty: none
  std::string logo{};      ///< absolute path of a PNG or JPEG file; empty: none
  std::vector<PartsColumn> columns{kAllPartsColumns.begin(), kAllPartsColumns.end()};  ///< in this order
  std::optional<Language> language{};                                                  ///< nothing: that of the window
  std::optional<Paper> paper{};  ///< nothing: as chosen in the window

  bool operator==(const InstructionTemplate&) const = default;
};

/// Reads a template: resources/schema/instruction-template-1.schema.json. Errors: MalformedInput with the JSON pointer
/// as place; that of reading the logo, which has to be a PNG or JPEG file beside the template or below its folder.
Result<InstructionTemplate> readInstructionTemplate(const std::string& file);

/// Of a logo's file.
inline constexpr std::size_t kMostLogoBytes = 4U << 20;

/// What a picture's file is by its first bytes: "image/png", "image/jpeg"; empty: neither.
std::string pictureType(const std::string& bytes);

}  // namespace glissade
