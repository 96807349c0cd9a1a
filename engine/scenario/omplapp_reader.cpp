#include "engine/scenario/omplapp_reader.h"

#include "engine/import/input_file.h"
#include "engine/scenario/number_text.h"

namespace glissade {
namespace {

struct Entry {
  std::string value;
  std::size_t line;
};
using Section = std::map<std::string, Entry>;

/// Thrown inside this file only.
struct Refusal {
  std::string place;
  std::string reason;
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string atLine(std::size_t line) { return "line " + std::to_string(line); }

/// The entries of [problem].
Section problemSection(std::string_view text) {
  Section section;
  bool inProblem = false;
  bool found = false;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    const std::string_view content = trimmed(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (content.empty() || content.front() == '#' || content.front() == ';') continue;
    if (content.front() == '[') {
      inProblem = content == "[problem]";
      found = found || inProblem;
      continue;
    }
    if (!inProblem) continue;
    const std::size_t equals = content.find('=');
    if (equals == std::string_view::npos) throw Refusal{atLine(line), "this is not 'key = value'"};
    const std::string key(trimmed(content.substr(0, equals)));
    const Entry entry{std::string(trimmed(content.substr(equals + 1))), line};
    if (!section.emplace(key, entry).second) throw Refusal{atLine(line), "the key '" + key + "' is there twice"};
  }
  if (!found) throw Refusal{"", "there is no section [problem]"};
  return section;
}

class ProblemReader {
 public:
  explicit ProblemReader(Section section) : section_(std::move(section)) {}

  const Entry& entry(const std::string& key) const {
    const auto found = section_.find(key);
    if (found == section_.end()) throw Refusal{"[problem]", "the key '" + key + "' is missing"};
    return found->second;
  }
  std::string text(const std::string& key) const { return section_.count(key) > 0 ? section_.at(key).value : ""; }

  double number(const std::string& key) const {
    const auto& [value, line] = entry(key);
    const std::optional<double> result = toNumber(value);
    if (!result) throw Refusal{atLine(line), "'" + value + "' is not a finite number"};
    return *result;
  }
  Vector3 vector(const std::string& prefix) const {
    return {number(prefix + ".x"), number(prefix + ".y"), number(prefix + ".z")};
  }
  Pose pose(const std::string& prefix) const {
    const Vector3 axis = vector(prefix + ".axis");
    const double theta = number(prefix + ".theta");
    if (axis.isZero() && theta != 0.0) {
      throw Refusal{atLine(entry(prefix + ".axis.x").line), "the axis of the rotation is zero"};
    }
    const Quaternion orientation =
        axis.isZero() ? Quaternion::Identity() : Quaternion(Eigen::AngleAxisd(theta, axis.normalized()));
    return {vector(prefix), orientation};
  }
  Asset asset(const std::string& key) const {
    const auto& [value, line] = entry(key);
    if (!isRelativeInside(value)) throw Refusal{atLine(line), "'" + value + "' leaves the folder of this file"};
    return {key, value, "", {}};
  }

 private:
  Section section_;
};

Scenario toScenario(const ProblemReader& problem) {
  Scenario scenario;
  scenario.name = problem.text("name");
  scenario.description = "An OMPL.app problem.";
  scenario.assets = {problem.asset("world"), problem.asset("robot")};
  BodyDescription world;
  world.id = "world";
  world.geometry = MeshGeometry{"world"};
  scenario.bodies = {world};
  scenario.object.id = "robot";
  scenario.object.geometry = MeshGeometry{"robot"};
  scenario.object.centreOnVertexMean = true;
  scenario.start = problem.pose("start");
  const Pose goal = problem.pose("goal");
  scenario.goal = goal;
  scenario.workspace = Box3(problem.vector("volume.min"), problem.vector("volume.max"));
  if (scenario.workspace.isEmpty()) {
    throw Refusal{atLine(problem.entry("volume.min.x").line), "volume.min is not below volume.max on every axis"};
  }
  scenario.workspace.extend(scenario.start.position).extend(goal.position);
  scenario.planner = "birrt";
  return scenario;
}

}  // namespace

Result<Scenario> parseOmplApp(const std::string& text, const std::string& file) try {
  return toScenario(ProblemReader(problemSection(text)));
} catch (const Refusal& refusal) {
  return Diagnostic{ErrorKind::MalformedInput, file, refusal.place, refusal.reason, "Mend the file there."};
}

}  // namespace glissade
