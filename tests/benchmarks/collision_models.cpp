#include "tests/benchmarks/collision_models.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <limits>
#include <map>

#include "engine/base/random_stream.h"
#include "engine/files/scenario_io.h"

namespace glissade {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Edge {
  Pose from;
  Pose to;
};

using Poses = std::map<std::string, std::vector<Pose>>;

Pose randomPose(const Box3& bounds, RandomStream& stream) {
  Pose q;
  for (int axis = 0; axis < 3; ++axis) q.position[axis] = stream.uniform(bounds.min()[axis], bounds.max()[axis]);
  q.orientation = Quaternion(stream.normal(), stream.normal(), stream.normal(), stream.normal()).normalized();
  return q;
}

Pose stepFrom(const Pose& from, const Box3& bounds, RandomStream& stream) {
  const Vector3 direction(stream.normal(), stream.normal(), stream.normal());
  const Vector3 axis(stream.normal(), stream.normal(), stream.normal());
  Pose to = from;
  to.position += 0.05 * bounds.diagonal().norm() * direction.normalized();
  to.orientation = from.orientation * Quaternion(Eigen::AngleAxisd(std::acos(-1.0) / 12.0, axis.normalized()));
  return to;
}

/// A free pose between a free and a colliding one, within a thousandth of the object's size of contact.
Pose nearContact(FclSurfaceQuery& fcl, Pose free, Pose colliding, double size) {
  while ((free.position - colliding.position).norm() > 1e-3 * size) {
    const Pose middle = interpolate(free, colliding, 0.5);
    (fcl.touches(middle) ? colliding : free) = middle;
  }
  return free;
}

/// Draws poses and sorts them by their contacts, as FCL sees them.
Poses drawPoses(FclSurfaceQuery& fcl, const Problem& problem, std::size_t count, RandomStream& stream) {
  Poses poses;
  auto& free = poses["free"];
  auto& colliding = poses["colliding"];
  while (free.size() < count || colliding.size() < count) {
    const Pose q = randomPose(problem.bounds, stream);
    auto& list = fcl.touches(q) ? colliding : free;
    if (list.size() < count) list.push_back(q);
  }
  auto& near = poses["near"];
  for (std::size_t i = 0; i < count; ++i) {
    near.push_back(nearContact(fcl, free[i], colliding[i], problem.world->objectRadius()));
  }
  return poses;
}

template <class Answer>
void use(Answer&& answer) {
  asm volatile("" : : "g"(&answer) : "memory");
}

void addQuestions(const std::string& model, const LoadedScenario& scenario, std::size_t count,
                  std::vector<CollisionQuestion>& questions) {
  const auto fcl = std::make_shared<FclSurfaceQuery>(makeFclGeometry(scenario.obstacles, *scenario.object.mesh));
  const auto kernel =
      std::make_shared<KernelQuery>(std::make_shared<const KernelGeometry>(scenario.obstacles, *scenario.object.mesh));
  const double required = scenario.parameters[ParameterId::RequiredClearance];
  RandomStream stream(1, model);
  for (const auto& [kind, drawn] : drawPoses(*fcl, scenario.problem, count, stream)) {
    const auto add = [&, kind = kind](const char* what, auto askFcl, auto askKernel) {
      questions.push_back({what, model, kind, count, askFcl, askKernel});
    };
    const auto poses = std::make_shared<const std::vector<Pose>>(drawn);
    add(
        "collide", [=](std::size_t i) { use(fcl->touches((*poses)[i])); },
        [=](std::size_t i) { use(kernel->touches((*poses)[i])); });
    add(
        "distance", [=](std::size_t i) { use(fcl->nearest((*poses)[i], kInfinity)); },
        [=](std::size_t i) {
          // These are the queries that the world makes: yes/no first, then the distance.
          if (!kernel->touches((*poses)[i])) use(kernel->nearest((*poses)[i], kInfinity));
        });
    auto drawnEdges = std::make_shared<std::vector<Edge>>();
    for (const Pose& q : drawn) drawnEdges->push_back({q, stepFrom(q, scenario.problem.bounds, stream)});
    const std::shared_ptr<const std::vector<Edge>> edges = drawnEdges;
    const auto checkTwenty = [=](std::size_t i) {
      const auto& [from, to] = (*edges)[i];
      bool free = true;
      for (int k = 1; k <= 20 && free; ++k) free = !fcl->touches(interpolate(from, to, k / 20.0));
      use(free);
    };
    const auto prove = [=](SeekViolation seek) {
      return [=](std::size_t i) { use(kernel->checkMotion((*edges)[i].from, (*edges)[i].to, required, seek, {})); };
    };
    add("edge", checkTwenty, prove(SeekViolation::Any));
    add("edge-first", checkTwenty, prove(SeekViolation::First));
  }
}

double cpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double secondsOf(const std::function<void(std::size_t)>& question, std::size_t count) {
  const double begin = cpuSeconds();
  for (std::size_t i = 0; i < count; ++i) question(i);
  return cpuSeconds() - begin;
}

}  // namespace

std::vector<CollisionQuestion> collisionQuestions(const std::string& sourceFolder, std::size_t count) {
  const std::filesystem::path root = sourceFolder;
  const std::vector<std::pair<std::string, std::filesystem::path>> files{
      {"L", root / "samples/environment-1/scenario.json"},
      {"pump", root / "samples/pump/mount.json"},
      {"Twistycool", root / "../shared/problems/omplapp/Twistycool.cfg"},
      {"alpha-1.5", root / "../shared/problems/omplapp/alpha-1.5.cfg"}};
  std::vector<CollisionQuestion> questions;
  for (const auto& [model, file] : files) {
    if (!std::filesystem::exists(file)) {
      std::fprintf(stderr, "%s is not there: left out\n", file.c_str());
      continue;
    }
    const auto scenario = loadScenario(file.string());
    if (scenario) {
      addQuestions(model, *scenario, count, questions);
    } else {
      std::fprintf(stderr, "%s\n", toString(scenario.error()).c_str());
    }
  }
  return questions;
}

double timeRatio(const CollisionQuestion& question, int rounds) {
  std::vector<double> ratios;
  for (int round = 0; round < rounds; ++round) {
    const double fcl = secondsOf(question.fcl, question.count);
    ratios.push_back(fcl / secondsOf(question.kernel, question.count));
  }
  std::nth_element(ratios.begin(), ratios.begin() + rounds / 2, ratios.end());
  return ratios[static_cast<std::size_t>(rounds / 2)];
}

}  // namespace glissade
