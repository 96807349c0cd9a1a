#include "widgets/workbench/feature_store.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;
using Found = std::vector<std::pair<MeshPtr, MeshFeaturesPtr>>;

/// Interval at which found features are delivered, so that bodies snap before all meshes are done.
constexpr std::chrono::milliseconds kDeliveryInterval{300};

/// Finds features of the meshes until `end`, but of at least one mesh.
Found findFeatures(const std::vector<MeshPtr>& meshes, const StopToken& stop, Clock::time_point end) {
  Found found;
  for (const MeshPtr& mesh : meshes) {
    if (stop.stopRequested() || (!found.empty() && Clock::now() > end)) break;
    found.emplace_back(mesh, std::make_shared<const MeshFeatures>(mesh));
  }
  return found;
}

}  // namespace

FeatureStore::FeatureStore(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  for (const BackgroundTask* task : {&request_, &round_}) {
    connect(task, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
  }
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (what & Change::Scenario) {
      request_.cancel();
      round_.cancel();
      known_.clear();
      all_ = false;
    } else if (all_ && (what & Change::Arrangement)) {
      prepareAll();  // an edit may have added parts
    }
  });
}

MeshFeaturesPtr FeatureStore::find(const MeshPtr& mesh) const {
  const auto known = known_.find(mesh);
  return known == known_.end() ? nullptr : known->second;
}

void FeatureStore::prepare(const MeshPtr& mesh, const std::function<void()>& then) {
  const auto work = [this, mesh, then](const WorkWatch&) -> BackgroundTask::Delivery {
    auto features = std::make_shared<const MeshFeatures>(mesh);
    return [this, mesh, then, features] {
      known_[mesh] = features;
      then();
    };
  };
  request_.start(GLISSADE_TEXT("finding edges and faces"), work, bench_.work.isAtOnce());
}

std::vector<MeshPtr> FeatureStore::unknownMeshes() const {
  std::vector<MeshPtr> unknown;
  const auto add = [&](const MeshPtr& mesh) {
    if (!find(mesh) && std::find(unknown.begin(), unknown.end(), mesh) == unknown.end()) unknown.push_back(mesh);
  };
  const LoadedScenario& scenario = *bench_.document.scenario();
  for (const RigidBody& body : scenario.obstacles) add(body.mesh);
  add(scenario.object.mesh);
  // Small meshes come first, so that most bodies snap soon.
  std::stable_sort(unknown.begin(), unknown.end(),
                   [](const MeshPtr& a, const MeshPtr& b) { return a->triangles.size() < b->triangles.size(); });
  return unknown;
}

void FeatureStore::prepareAll() {
  if (!bench_.document.scenario() || round_.isBusy()) return;
  all_ = true;
  const std::vector<MeshPtr> unknown = unknownMeshes();
  if (unknown.empty()) return;
  const bool atOnce = bench_.work.isAtOnce();
  const auto work = [this, unknown, atOnce](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const Clock::time_point end = atOnce ? Clock::time_point::max() : Clock::now() + kDeliveryInterval;
    return [this, found = findFeatures(unknown, watch.stop, end)] {
      known_.insert(found.begin(), found.end());
      QMetaObject::invokeMethod(this, &FeatureStore::prepareAll, Qt::QueuedConnection);
    };
  };
  round_.start(GLISSADE_TEXT("finding edges and faces"), work, atOnce);
}

}  // namespace glissade
