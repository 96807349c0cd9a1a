#include "engine/import/omplapp_config.h"

#include <map>
#include <optional>
#include <sstream>

#include "engine/base/file.h"
#include "engine/base/limits.h"
#include "engine/base/number_text.h"
#include "engine/base/printable_text.h"

namespace glissade {
namespace {

constexpr std::size_t kMostConfigBytes = 1U << 20;

using Keys = std::map<std::string, std::string>;

Diagnostic malformedConfig(const std::string& file, const Location& location, const Message& reason) {
  return {ErrorKind::MalformedInput, file, location, reason, GLISSADE_TEXT("Correct the OMPL.app problem file.")};
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The keys and values of the section [problem].
Result<Keys> problemSection(const std::string& text, const std::string& file) {
  Keys keys;
  std::istringstream stream(text);
  std::string line;
  std::string section;
  for (int number = 1; std::getline(stream, line); ++number) {
    line = trimmed(line);
    if (line.empty() || line[0] == '#' || line[0] == ';') continue;
    if (line[0] == '[') {
      section = line;
      continue;
    }
    const auto equals = line.find('=');
    const Location place{GLISSADE_TEXT("line %1"), {number}};
    if (equals == std::string::npos) return malformedConfig(file, place, GLISSADE_TEXT("is not 'key = value'"));
    if (section != "[problem]") continue;
    const std::string key = trimmed(line.substr(0, equals));
    if (!keys.emplace(key, trimmed(line.substr(equals + 1))).second) {
      return malformedConfig(file, place, {GLISSADE_TEXT("gives '%1' a second time"), {key}});
    }
  }
  if (keys.empty()) return malformedConfig(file, "[problem]", GLISSADE_TEXT("is missing or empty"));
  return keys;
}

/// Reads numbers by key and stores the first error.
class Numbers {
 public:
  Numbers(const Keys& keys, std::string file) : keys_(keys), file_(std::move(file)) {}

  double get(const std::string& key) {
    const auto entry = keys_.find(key);
    if (entry == keys_.end()) {
      complain(key, GLISSADE_TEXT("is missing"));
      return 0.0;
    }
    const auto number = toNumber(entry->second);
    if (!number) complain(key, GLISSADE_TEXT("is not a finite number"));
    if (number && !limits::isCoordinate(*number)) complain(key, GLISSADE_TEXT("is beyond 1e9"));
    return number.value_or(0.0);
  }

  Vector3 vector(const std::string& key) { return {get(key + ".x"), get(key + ".y"), get(key + ".z")}; }

  Pose pose(const std::string& key) {
    Pose pose;
    pose.position = vector(key);
    const double angle = get(key + ".theta");
    const Vector3 axis = vector(key + ".axis");
    if (axis.norm() > 0.0) pose.orientation = Quaternion(Eigen::AngleAxisd(angle, axis.normalized()));
    if (axis.norm() == 0.0 && angle != 0.0) complain(key + ".axis", GLISSADE_TEXT("is zero"));
    return pose;
  }

  const std::optional<Diagnostic>& complaint() const { return complaint_; }

 private:
  void complain(const std::string& key, const Message& reason) {
    if (!complaint_) complaint_ = malformedConfig(file_, key, reason);
  }

  const Keys& keys_;
  std::string file_;
  std::optional<Diagnostic> complaint_;
};

}  // namespace

Result<OmplAppConfig> readOmplAppConfig(const std::string& file) {
  const auto text = readFile(file, kMostConfigBytes);
  if (!text) return text.error();
  const auto keys = problemSection(*text, file);
  if (!keys) return keys.error();
  const auto textOf = [&](const std::string& key) {
    const auto entry = keys->find(key);
    return entry == keys->end() ? std::string() : entry->second;
  };
  OmplAppConfig config;
  config.name = printableLine(textOf("name"));
  config.robot = textOf("robot");
  config.world = textOf("world");
  if (config.robot.empty()) return malformedConfig(file, "robot", GLISSADE_TEXT("is missing"));
  Numbers numbers(*keys, file);
  config.start = numbers.pose("start");
  config.goal = numbers.pose("goal");
  config.volume = Box3(numbers.vector("volume.min"), numbers.vector("volume.max"));
  if (numbers.complaint()) return *numbers.complaint();
  if (config.volume.isEmpty()) return malformedConfig(file, "volume", GLISSADE_TEXT("has a minimum above its maximum"));
  config.volume.extend(config.start.position);
  config.volume.extend(config.goal.position);
  return config;
}

}  // namespace glissade
