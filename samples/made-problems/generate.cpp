// Writes the project's own problems: for each a scenario and two meshes.
//
// usage: generate-made-problems FOLDER
#include <filesystem>

#include "samples/made-problems/made_problems.h"
#include "samples/part_files.h"

namespace glissade::made {
namespace {

std::string listed(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + toText(number);
  return "[" + text + "]";
}

std::string listed(const Vector3& v) { return listed({v.x(), v.y(), v.z()}); }

std::string poseText(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  return R"({"position": )" + listed(pose.position) + R"(, "orientation": )" + listed({q.x(), q.y(), q.z(), q.w()}) +
         "}";
}

std::string asset(const std::string& id, const std::string& file) {
  return R"({"id": ")" + id + R"(", "path": ")" + file + R"(", "unit": 1.0, "up_axis": "z"})";
}

std::string scenarioText(const MadeProblem& problem) {
  const std::string identity = poseText(Pose::identity());
  return R"({
  "format": "glissade-scenario",
  "version": 1,
  "name": ")" +
         problem.name + R"(",
  "description": ")" +
         problem.description + R"(",
  "assets": [)" +
         asset("obstacles", problem.name + "-obstacles.obj") + ", " + asset("object", problem.name + "-object.obj") +
         R"(],
  "bodies": [{"id": "obstacles", "name": "obstacles", "mobility": "static", "geometry": {"mesh": "obstacles"}, "pose": )" +
         identity + R"(}],
  "object": {"id": "object", "name": "object", "geometry": {"mesh": "object"}},
  "start": )" +
         poseText(problem.start) + R"(,
  "goal": )" +
         poseText(problem.goal) + R"(,
  "workspace": {"min": )" +
         listed(problem.workspace.min()) + R"(, "max": )" + listed(problem.workspace.max()) + R"(},
  "way_points": [],
  "planner": "auto",
  "parameters": {},
  "seed": 1
}
)";
}

int write(const std::string& folder, const MadeProblem& problem) {
  const std::string file = folder + "/" + problem.name + ".json";
  if (const auto saved = writeFileAtomically(file, scenarioText(problem)); !saved) {
    std::cerr << toString(saved.error()) << "\n";
    return 1;
  }
  return samples::writeParts(
      folder, {{problem.name + "-obstacles.obj", problem.obstacles}, {problem.name + "-object.obj", problem.object}});
}

}  // namespace
}  // namespace glissade::made

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: generate-made-problems FOLDER\n";
    return 2;
  }
  std::filesystem::create_directories(argv[1]);
  for (const glissade::made::MadeProblem& problem : glissade::made::madeProblems()) {
    if (const int code = glissade::made::write(argv[1], problem); code != 0) return code;
  }
  return 0;
}
