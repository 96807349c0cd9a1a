#include <algorithm>
#include <cmath>

#include "engine/import/input_file.h"
#include "engine/scenario/json_cursor.h"
#include "engine/scenario/number_text.h"
#include "engine/scenario/path_format.h"
#include "engine/scenario/path_io.h"

namespace glissade {
namespace {

constexpr std::string_view kBlank = " \t\r";
constexpr std::size_t kLargestPathFile = std::size_t{64} << 20;

Diagnostic malformed(const std::string& file, const std::string& place, const std::string& reason) {
  return {ErrorKind::MalformedInput, file, place, reason,
          "Give a path as CSV, as OMPL's seven columns, or as JSON of Glissade."};
}

/// The fields of a line: between commas, or between any blanks.
std::vector<std::string_view> fields(std::string_view line, bool commas) {
  std::vector<std::string_view> result;
  while (!line.empty()) {
    const std::size_t end = commas ? line.find(',') : line.find_first_of(kBlank);
    const std::string_view field = line.substr(0, end);
    if (commas || !field.empty()) result.push_back(field);
    line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
  }
  return result;
}

/// Seven numbers from `first` on.
std::optional<Pose> readPose(const std::vector<std::string_view>& columns, std::size_t first) {
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < v.size(); ++i) {
    const std::optional<double> number = toNumber(columns[first + i]);
    if (!number) return std::nullopt;
    v[i] = *number;
  }
  const Pose pose{{v[0], v[1], v[2]}, Quaternion(v[6], v[3], v[4], v[5])};
  return isValid(pose) ? std::optional(pose) : std::nullopt;
}

std::optional<Author> readAuthor(std::string_view name) {
  const auto& names = path_format::kAuthors;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Author>(found - names.begin());
}

std::optional<PathPoint> readLine(std::string_view line, bool csv) {
  const std::vector<std::string_view> columns = fields(line, csv);
  if (columns.size() != (csv ? 12U : 7U)) return std::nullopt;
  const std::optional<Pose> q = readPose(columns, csv ? 2 : 0);
  const std::optional<Author> author = csv ? readAuthor(columns.back()) : Author::Computer;
  if (!q || !author) return std::nullopt;
  return PathPoint{*q, *author};
}

Result<std::vector<PathPoint>> readTable(std::string_view text, const std::string& file) {
  const bool csv = text.substr(0, path_format::kCsvHeader.size()) == path_format::kCsvHeader;
  std::vector<PathPoint> points;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    line = line.substr(0, line.find_last_not_of(kBlank) + 1);
    const bool header = csv && number == 1;
    if (line.empty() || header) continue;
    const std::optional<PathPoint> point = readLine(line, csv);
    if (!point) return malformed(file, "line " + std::to_string(number), "this line is not a configuration");
    points.push_back(*point);
  }
  return points;
}

Result<std::vector<PathPoint>> readJson(const std::string& text, const std::string& file) {
  const Result<Json> document = parseJson(text, file);
  if (!document) return document.error();
  try {
    const JsonCursor root(*document);
    if (root.at("format").text() != path_format::kName) root.at("format").fail("this is not a path");
    if (root.at("version").wholeNumber() != path_format::kVersion) {
      root.at("version").fail("this version is not known", "Update Glissade.");
    }
    std::vector<PathPoint> points;
    for (const JsonCursor& point : root.at("points").elements()) {
      const std::size_t author = point.at("author").oneOf({"computer", "operator", "contact"});
      points.push_back({point.at("q").row(), static_cast<Author>(author)});
    }
    return points;
  } catch (const JsonFailure& failure) {
    Diagnostic diagnostic = failure.diagnostic;
    diagnostic.file = file;
    return diagnostic;
  }
}

}  // namespace

Result<std::vector<PathPoint>> readPath(const std::string& file) {
  const Result<std::string> text = readInputFile(file, kLargestPathFile);
  if (!text) return text.error();
  const Result<std::vector<PathPoint>> points = text->front() == '{' ? readJson(*text, file) : readTable(*text, file);
  if (points && points->empty()) return malformed(file, "", "the file holds no configuration");
  return points;
}

}  // namespace glissade
