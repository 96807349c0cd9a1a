#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "engine/base/file.h"
#include "engine/base/json_reader.h"
#include "engine/base/limits.h"
#include "engine/base/number_text.h"
#include "engine/base/printable_text.h"
#include "engine/base/tolerances.h"
#include "engine/files/path_reader.h"
#include "engine/geometry/pose_json.h"
#include "engine/import/json_checksum.h"

namespace glissade {
namespace {

constexpr std::size_t kMostPathBytes = 256U << 20;
/// Length of twelve numbers in the longest texts that doubles have.
constexpr std::size_t kLongestLine = 8192;
/// Limit of the configurations, about half a gigabyte.
constexpr std::size_t kMostConfigurations = 5'000'000;
constexpr const char* kJsonFormat = "glissade-path";
constexpr const char* kCsvHeader = "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author";

std::vector<std::string> split(const std::string& line, const char* separators) {
  std::vector<std::string> words;
  std::size_t begin = line.find_first_not_of(separators);
  while (begin != std::string::npos) {
    const std::size_t end = line.find_first_of(separators, begin);
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return words;
}

/// A word of the file for a message.
Message quoted(const std::string& word) {
  constexpr std::size_t kLongest = 40;
  return {GLISSADE_TEXT("'%1'"), {printableLine(word.substr(0, kLongest)) + (word.size() > kLongest ? "..." : "")}};
}

/// Reads one of the two text formats, line by line.
class TextPathReader {
 public:
  explicit TextPathReader(std::string file) : file_(std::move(file)) {}

  Result<std::vector<PathPoint>> read(const std::string& text) {
    std::istringstream stream(text);
    std::string line;
    std::vector<PathPoint> points;
    for (line_ = 1; std::getline(stream, line); ++line_) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (line.size() > kLongestLine) return malformed({GLISSADE_TEXT("is longer than %1 bytes"), {kLongestLine}});
      if (line_ == 1 && line == kCsvHeader) {
        csv_ = true;
        continue;
      }
      const std::vector<std::string> words = split(line, csv_ ? "," : " \t");
      if (words.empty()) continue;
      const auto point = readPoint(words);
      if (!point) return point.error();
      if (points.size() == kMostConfigurations) {
        return malformed(
            {GLISSADE_TEXT("is one too many: a path has at most %1 configurations"), {kMostConfigurations}});
      }
      points.push_back(*point);
    }
    if (points.empty())
      return Diagnostic{ErrorKind::MalformedInput, file_, "", GLISSADE_TEXT("holds no configuration"),
                        GLISSADE_TEXT("Give a path.")};
    return points;
  }

 private:
  Diagnostic malformed(const Message& reason) const {
    return {ErrorKind::MalformedInput,
            file_,
            {GLISSADE_TEXT("line %1"), {line_}},
            reason,
            csv_ ? Message(GLISSADE_TEXT("Each line holds %1."), {kCsvHeader})
                 : Message(GLISSADE_TEXT("Each line holds x y z qx qy qz qw; a CSV begins with its header."))};
  }

  Result<PathPoint> readPoint(const std::vector<std::string>& words) const {
    const std::size_t expected = csv_ ? 12 : 7;
    if (words.size() != expected) return malformed({GLISSADE_TEXT("does not have %1 columns"), {expected}});
    std::array<double, 7> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string& word = words[i + (csv_ ? 2 : 0)];
      const auto number = toNumber(word);
      if (!number) return malformed({GLISSADE_TEXT("holds %1, which is not a finite number"), {quoted(word)}});
      if (!limits::isCoordinate(*number))
        return malformed({GLISSADE_TEXT("holds %1, which is beyond 1e9 m"), {quoted(word)}});
      values[i] = *number;
    }
    PathPoint point;
    point.q.position = {values[0], values[1], values[2]};
    point.q.orientation = Quaternion(values[6], values[3], values[4], values[5]);
    if (std::abs(point.q.orientation.norm() - 1.0) > tolerance::kQuaternionNorm) {
      return malformed(GLISSADE_TEXT("has an orientation that is not a unit quaternion"));
    }
    if (csv_) {
      const auto author = kAuthorNames.find(words[11]);
      if (!author) return malformed({GLISSADE_TEXT("names an unknown author %1"), {quoted(words[11])}});
      point.author = *author;
    }
    return point;
  }

  std::string file_;
  int line_ = 0;
  bool csv_ = false;
};

Result<std::vector<PathPoint>> readJsonPath(const std::string& text, const std::string& file) {
  auto document = parseJson(text, file);
  if (!document) return document.error();
  const ChecksumState checksum = takeChecksum(*document);
  try {
    const JsonCursor root(*document, file, "");
    if (root.at("format").text() != kJsonFormat)
      root.at("format").fail({GLISSADE_TEXT("is not \"%1\""), {kJsonFormat}});
    if (root.at("version").wholeNumber() != 1)
      root.at("version").fail(GLISSADE_TEXT("is not 1"), GLISSADE_TEXT("Use a newer Glissade."));
    const JsonCursor list = root.at("configurations");
    std::vector<PathPoint> points;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const JsonCursor at = list.element(i);
      JsonCursor::Json pose{{"position", at.at("position").json()}, {"orientation", at.at("orientation").json()}};
      PathPoint point;
      point.q = readPose(JsonCursor(pose, file, "/configurations/" + std::to_string(i)));
      point.author = at.at("author").named(kAuthorNames);
      points.push_back(point);
    }
    if (points.empty()) list.fail(GLISSADE_TEXT("is empty"), GLISSADE_TEXT("Give a path."));
    if (checksum == ChecksumState::Wrong) {
      return wrongChecksum(file, GLISSADE_TEXT("Plan again. To check an edited path, remove its checksum."));
    }
    return points;
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}

}  // namespace

Result<std::vector<PathPoint>> readPath(const std::string& file, const PathExporterRegistry& formats) {
  const auto text = readFile(file, kMostPathBytes);
  if (!text) return text.error();
  const auto exporter = formats.forFile(file);
  const bool writtenOnly = exporter && !exporter->readBackError;
  if (writtenOnly || text->rfind("glTF", 0) == 0) {
    return Diagnostic{ErrorKind::MalformedInput,
                      file,
                      "",
                      GLISSADE_TEXT("is in a format that can only be written"),
                      {GLISSADE_TEXT("Give the path as one of: %1."), {formats.readableFormats()}}};
  }
  const std::size_t first = text->find_first_not_of(" \t\r\n");
  if (first != std::string::npos && (*text)[first] == '{') return readJsonPath(*text, file);
  return TextPathReader(file).read(*text);
}

bool isPathFile(const std::string& file) {
  const auto exporter = pathExporterFor(file);
  if (!exporter || !exporter->readBackError) return false;
  if (exporter->id != "json") return true;
  const auto text = readFile(file, kMostPathBytes);
  const auto document = text ? parseJson(*text, file) : Result<JsonCursor::Json>(text.error());
  return document && document->is_object() && document->value("format", JsonCursor::Json()) == kJsonFormat;
}

}  // namespace glissade
