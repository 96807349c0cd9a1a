// Produces certified paths for path_oracle, with the engine: planned paths, and many straight motions near surfaces
// that the certificate accepts.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "engine/base/random_stream.h"
#include "engine/files/path_text.h"
#include "engine/files/scenario_io.h"
#include "engine/planning/path_certificate.h"
#include "engine/session/session.h"
#include "tests/engine/support/independent_check.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// Most attempts at a certified motion in a scene.
constexpr int kMostTries = 60;
constexpr double kMostSteps = 300;

struct Counts {
  int scenes = 0;
  int planned = 0;
  int motions = 0;
  int refusedByJudge = 0;  ///< certified paths with which the independent check does not agree
  int undecided = 0;       ///< paths with turns by half a circle, which the check does not decide
  int unloadable = 0;
};

class PathMaker {
 public:
  PathMaker(LoadedScenario loaded, std::string folder, std::uint64_t seed, Counts& counts)
      : loaded_(std::move(loaded)),
        folder_(std::move(folder)),
        stream_(seed, "motions"),
        counts_(counts),
        query_(loaded_.problem.world->makeQuery()),
        check_(loaded_.problem.world->obstacles(), loaded_.problem.world->object()) {}

  void plan() {
    const Pose* goal = std::get_if<Pose>(&loaded_.problem.goal);
    if (goal == nullptr || query_->collides(loaded_.problem.start) || query_->collides(*goal)) return;
    SessionConfig config{loaded_.problem, loaded_.parameters, "birrt", 1, nullptr};
    if (!config.parameters.set(ParameterId::MaxSteps, kMostSteps).ok()) return;
    const auto session = makeLockstepSession(std::move(config));
    session->post(command::Start{});
    session->advance(0);
    while (isRunning(*session->snapshot())) session->advance(100);
    const SnapshotPtr end = session->snapshot();
    if (!end->path) return;
    deliver(end->path->points, "planned");
    ++counts_.planned;
  }

  void move(int count) {
    for (int i = 0; i < count; ++i) {
      for (int attempt = 0; attempt < kMostTries; ++attempt) {
        if (tryMotion(i)) break;
      }
    }
  }

 private:
  bool tryMotion(int index) {
    const auto from = nearContact();
    if (!from) return false;
    PathPoint a;
    PathPoint b;
    a.q = *from;
    b.q = neighbourOf(*from);
    if (certifyPath(*query_, {a, b}, loaded_.parameters).status != CertificateStatus::Certified) return false;
    deliver({a, b}, "motion" + std::to_string(index));
    ++counts_.motions;
    return true;
  }

  double radius() const { return loaded_.problem.world->objectRadius(); }

  /// A free configuration, mostly as near to a surface as halving finds.
  std::optional<Pose> nearContact() {
    const std::optional<Pose> free = freePose();
    if (!free || stream_.uniform() < 0.2) return free;
    Pose good = *free;
    Pose bad = neighbourOf(good, 3.0);
    if (!query_->collides(bad)) return good;
    const int halvings = 2 + static_cast<int>(stream_.uniform(0.0, 12.0));
    for (int i = 0; i < halvings; ++i) {
      const Pose middle = interpolate(good, bad, 0.5);
      (query_->collides(middle) ? bad : good) = middle;
    }
    return good;
  }

  /// A free configuration near the start or the goal, between them, or anywhere.
  std::optional<Pose> freePose() {
    const Box3& bounds = loaded_.problem.bounds;
    const Pose* goal = std::get_if<Pose>(&loaded_.problem.goal);
    for (int i = 0; i < 20; ++i) {
      Pose pose = loaded_.problem.start;
      if (goal != nullptr && stream_.uniform() < 0.6) {
        pose = interpolate(loaded_.problem.start, *goal, stream_.uniform());
      } else {
        pose = neighbourOf(pose, 0.0);
        for (int k = 0; k < 3; ++k) pose.position[k] = stream_.uniform(bounds.min()[k], bounds.max()[k]);
        pose.orientation =
            Quaternion(stream_.normal(), stream_.normal(), stream_.normal(), stream_.normal()).normalized();
      }
      if (!query_->collides(pose)) return pose;
    }
    return std::nullopt;
  }

  /// A pose moved by up to `reach` radii and turned by any angle, often by none or by half a circle.
  Pose neighbourOf(const Pose& pose, double reach = 1.0) {
    Pose other = pose;
    const double way = radius() * reach * std::exp(stream_.uniform(-7.0, 0.0));
    other.position += way * Vector3(stream_.normal(), stream_.normal(), stream_.normal()).normalized();
    const double kind = stream_.uniform();
    const double angle = kind < 0.3 ? 0.0 : kind < 0.5 ? 3.141592653589793 : std::exp(stream_.uniform(-7.0, 1.0));
    const Vector3 axis = Vector3(stream_.normal(), stream_.normal(), stream_.normal()).normalized();
    other.orientation = (pose.orientation * Quaternion(Eigen::AngleAxisd(angle, axis))).normalized();
    return other;
  }

  void deliver(const std::vector<PathPoint>& points, const std::string& name) {
    const std::vector<EdgeDemand> demands = demandsOf(points, loaded_.parameters);
    const CertificateStatus judged = check_.check(configurationsOf(points), demands).status;
    counts_.refusedByJudge += judged == CertificateStatus::Violated ? 1 : 0;
    counts_.undecided += judged == CertificateStatus::Undecided ? 1 : 0;
    if (judged == CertificateStatus::Violated) std::cout << "REFUSED " << folder_ << "/" << name << ".csv\n";
    std::ofstream(folder_ + "/" + name + ".csv") << *pathAsCsv({points, {}}, loaded_, {"birrt", 1});
  }

  LoadedScenario loaded_;
  std::string folder_;
  RandomStream stream_;
  Counts& counts_;
  std::unique_ptr<CollisionQuery> query_;
  IndependentCheck check_;
};

int makePaths(const std::string& root, int motions) {
  Counts counts;
  for (const auto& entry : fs::directory_iterator(root)) {
    const std::string folder = entry.path().string();
    auto loaded = loadScenario(folder + "/scenario.json");
    ++counts.scenes;
    if (!loaded) {
      ++counts.unloadable;
      std::cout << "NOT LOADED " << toString(loaded.error()) << "\n";
      continue;
    }
    PathMaker maker(std::move(*loaded), folder, static_cast<std::uint64_t>(counts.scenes), counts);
    maker.plan();
    maker.move(motions);
  }
  std::cout << "made " << counts.planned + counts.motions << " certified paths (" << counts.planned << " planned, "
            << counts.motions << " motions) in " << counts.scenes << " scenes; the independent check refuses "
            << counts.refusedByJudge << ", leaves open " << counts.undecided << "; " << counts.unloadable
            << " scenes not loaded\n";
  return counts.refusedByJudge == 0 ? 0 : 1;
}

}  // namespace
}  // namespace glissade

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: path_maker FOLDER MOTIONS\n";
    return 2;
  }
  return glissade::makePaths(argv[1], std::stoi(argv[2]));
}
