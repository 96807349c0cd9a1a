#include "engine/check/read_path.h"

#include <array>
#include <cmath>
#include <sstream>

#include "engine/base/file.h"
#include "engine/base/limits.h"
#include "engine/base/number_text.h"
#include "engine/base/printable_text.h"
#include "engine/base/tolerances.h"
#include "engine/check/stated_json.h"
#include "engine/import/json_checksum.h"

namespace glissade::check {
namespace {

constexpr std::size_t kMostPathBytes = 256U << 20;
constexpr std::size_t kLongestLine = 8192;
constexpr std::size_t kMostLines = 5'000'000;
constexpr const char* kPathFormat = "glissade-path";
constexpr const char* kHeader = "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author";

std::vector<std::string> columnsOf(const std::string& line, const char* separators) {
  std::vector<std::string> columns;
  std::size_t begin = line.find_first_not_of(separators);
  while (begin != std::string::npos) {
    const std::size_t end = line.find_first_of(separators, begin);
    columns.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return columns;
}

/// Reads lines of numbers: a CSV by its header, or the columns of OMPL.
class ColumnReader {
 public:
  explicit ColumnReader(std::string file) : file_(std::move(file)) {}

  Result<Path> read(const std::string& text) {
    std::istringstream stream(text);
    Path path;
    std::string line;
    for (line_ = 1; std::getline(stream, line); ++line_) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (line.size() > kLongestLine) return wrong({GLISSADE_TEXT("is longer than %1 bytes"), {kLongestLine}});
      if (line_ == 1 && line == kHeader) {
        csv_ = true;
        continue;
      }
      const auto columns = columnsOf(line, csv_ ? "," : " \t");
      if (columns.empty()) continue;
      const auto point = pointIn(columns);
      if (!point) return point.error();
      if (path.points.size() == kMostLines) return wrong(GLISSADE_TEXT("is one configuration too many"));
      path.points.push_back(*point);
    }
    if (path.points.empty()) {
      return Diagnostic{ErrorKind::MalformedInput, file_, "", GLISSADE_TEXT("holds no configuration"),
                        GLISSADE_TEXT("Give a path.")};
    }
    return path;
  }

 private:
  Diagnostic wrong(const Message& reason) const {
    Message advice = GLISSADE_TEXT("Each line holds x y z qx qy qz qw; a CSV begins with its header.");
    if (csv_) advice = {GLISSADE_TEXT("Each line holds %1."), {kHeader}};
    return {ErrorKind::MalformedInput, file_, {GLISSADE_TEXT("line %1"), {line_}}, reason, advice};
  }

  Result<Point> pointIn(const std::vector<std::string>& columns) const {
    const std::size_t expected = csv_ ? 12 : 7;
    if (columns.size() != expected) return wrong({GLISSADE_TEXT("does not have %1 columns"), {expected}});
    std::array<double, 7> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string& column = columns[i + (csv_ ? 2 : 0)];
      const auto number = toNumber(column);
      const std::string shown = printableLine(column.substr(0, 40)) + (column.size() > 40 ? "..." : "");
      if (!number) return wrong({GLISSADE_TEXT("holds '%1', which is not a finite number"), {shown}});
      if (!limits::isCoordinate(*number)) return wrong({GLISSADE_TEXT("holds '%1', which is beyond 1e9 m"), {shown}});
      values[i] = *number;
    }
    Point point;
    point.q.position = {values[0], values[1], values[2]};
    point.q.orientation = Quaternion(values[6], values[3], values[4], values[5]);
    if (std::abs(point.q.orientation.norm() - 1.0) > tolerance::kQuaternionNorm) {
      return wrong(GLISSADE_TEXT("has an orientation that is not a unit quaternion"));
    }
    if (!csv_) return point;
    const std::string& author = columns[11];
    if (author != "computer" && author != "operator" && author != "contact") {
      return wrong({GLISSADE_TEXT("names an unknown author '%1'"), {printableLine(author.substr(0, 40))}});
    }
    point.contact = author == "contact";
    return point;
  }

  std::string file_;
  int line_ = 0;
  bool csv_ = false;
};

Result<Path> pathInJson(const std::string& text, const std::string& file) {
  auto document = parseJson(text, file);
  if (!document) return document.error();
  const ChecksumState checksum = takeChecksum(*document);
  try {
    const JsonCursor root(*document, file, "");
    if (root.at("format").text() != kPathFormat) root.at("format").fail(GLISSADE_TEXT("is not \"glissade-path\""));
    if (root.at("version").wholeNumber() != 1)
      root.at("version").fail(GLISSADE_TEXT("is not 1"), GLISSADE_TEXT("Use a newer Glissade."));
    Path path{readPoints(root.at("configurations")), std::vector<StatedAllowance>()};
    auto allowances = root.find("allowances");
    if (const auto certificate = root.find("certificate"); certificate && !allowances) {
      allowances = certificate->find("allowances");
    }
    if (allowances) path.allowances = readAllowances(*allowances);
    if (checksum == ChecksumState::Wrong) {
      return wrongChecksum(file, GLISSADE_TEXT("Plan again. To check an edited path, remove its checksum."));
    }
    return path;
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}

}  // namespace

Result<Path> readPath(const std::string& file) {
  const auto text = readFile(file, kMostPathBytes);
  if (!text) return text.error();
  const std::string ending = endingOf(file);
  if (ending == "glb" || ending == "gltf" || ending == "obj" || text->rfind("glTF", 0) == 0) {
    return Diagnostic{ErrorKind::MalformedInput, file, "", GLISSADE_TEXT("is in a format that can only be written"),
                      GLISSADE_TEXT("Give the path as CSV, JSON or OMPL's columns.")};
  }
  const std::size_t first = text->find_first_not_of(" \t\r\n");
  if (first != std::string::npos && (*text)[first] == '{') return pathInJson(*text, file);
  return ColumnReader(file).read(*text);
}

}  // namespace glissade::check
