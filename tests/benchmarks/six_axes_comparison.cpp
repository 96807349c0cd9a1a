// Prints a row for each product: the parts that straight lines along six axes with sampled penetration remove, and
// those that Glissade removes. Usage: six_axes_comparison FILE...   (STEP files or scenarios)
#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/collision/prepared_bodies.h"
#include "engine/files/judged_product.h"
#include "engine/files/product_file.h"
#include "engine/geometry/thinned_mesh.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/sequence_run.h"

namespace glissade {
namespace {

/// A body that left along one of the six axes.
struct SixAxesStep {
  std::size_t body = 0;
  Vector3 way = Vector3::Zero();  ///< from where it is assembled, metres
  BodySet others;                 ///< that were there
};

constexpr double kAllowedPenetration = 1.5e-4;

constexpr int kSamples = 400;

constexpr double kMargin = 1e-3;

constexpr double kApart = 1e-6;

constexpr std::array<double, 9> kDepths{1.5e-4, 2e-4, 3e-4, 5e-4, 7.5e-4, 1e-3, 1.5e-3, 2e-3, 3e-3};

/// The body itself where it cannot be thinned so.
MeshPtr thinnedBy(double depth, const MeshPtr& mesh) {
  const auto thinnable = ThinnableMesh::of(*mesh);
  auto thinner = thinnable ? thinnable->thinned(depth) : std::nullopt;
  return thinner ? std::make_shared<const TriangleMesh>(std::move(*thinner)) : mesh;
}

/// The bodies whose boxes meet the swept box of the body.
std::vector<PreparedBodies::Against> nearWay(PreparedBodies& prepared, std::size_t body, const Vector3& way,
                                             const BodySet& others, const MeshPtr& mesh) {
  const Box3& box = prepared.boxOf(body);
  Box3 swept = box;
  swept.extend(Box3(box.min() + way, box.max() + way));
  std::vector<PreparedBodies::Against> near;
  for (const std::size_t other : bodiesIn(others)) {
    if (swept.intersects(prepared.boxOf(other))) near.push_back({other, mesh});
  }
  return near;
}

class SixAxes {
 public:
  explicit SixAxes(const AssembledProduct& product) : product_(product), prepared_(product.bodies) {}

  std::optional<SixAxesStep> leave(std::size_t body, const BodySet& others, const StopToken& stop) {
    const Box3 rest = boxOf(product_, others);
    const Box3& box = prepared_.boxOf(body);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        const double length = sign > 0.0 ? rest.max()[axis] - box.min()[axis] : box.max()[axis] - rest.min()[axis];
        const Vector3 way = sign * (std::max(0.0, length) + kMargin) * Vector3::Unit(axis);
        if (stop.stopRequested()) return std::nullopt;
        if (isFree(body, way, others)) return SixAxesStep{body, way, others};
      }
    }
    return std::nullopt;
  }

 private:
  bool isFree(std::size_t body, const Vector3& way, const BodySet& others) {
    const RigidBody& own = product_.bodies[body];
    MeshPtr& thin = thin_[own.mesh];
    if (!thin) thin = thinnedBy(kAllowedPenetration, own.mesh);
    const auto world = prepared_.world(thin, nearWay(prepared_, body, way, others, thin));
    const auto query = world->makeQuery();
    for (int i = 0; i <= kSamples; ++i) {
      Pose at = own.X_WB;
      at.position += static_cast<double>(i) / kSamples * way;
      if (query->collides(at)) return false;
    }
    return true;
  }

  const AssembledProduct& product_;
  PreparedBodies prepared_;
  std::map<MeshPtr, MeshPtr> thin_;
};

/// The usual method in short: removes body after body, straight along one of the six axes of the world, until the body
/// is out of the box of the others, and checks 400 configurations. The body is thinned so that it may penetrate others
/// by 0.15 mm. Nothing is proved between the configurations. Ends if no body can leave, or after a stop.
std::vector<SixAxesStep> sixAxesSequence(const AssembledProduct& product, const BodySet& staying,
                                         const StopToken& stop) {
  SixAxes axes(product);
  BodySet present(product.bodies.size(), true);
  std::vector<SixAxesStep> steps;
  for (bool left = true; left;) {
    left = false;
    for (const std::size_t body : bodiesIn(present)) {
      if (staying[body]) continue;
      auto step = axes.leave(body, without(present, {body}), stop);
      if (!step) continue;
      present[body] = false;
      steps.push_back(std::move(*step));
      left = true;
    }
  }
  return steps;
}

/// By how much the body has to be taken thinner so that the kernel proves the whole motion free: the least of 0.15 mm
/// and a list of larger ones, metres; infinity where none of them does. It is about what the motion penetrates.
double penetrationOf(const AssembledProduct& product, const SixAxesStep& step, const StopToken& stop) {
  const RigidBody& own = product.bodies[step.body];
  PreparedBodies prepared(product.bodies);
  Pose end = own.X_WB;
  end.position += step.way;
  const auto provedFree = [&](const MeshPtr& mesh) {
    const auto world = prepared.world(mesh, nearWay(prepared, step.body, step.way, step.others, mesh));
    const auto check = world->makeQuery()->checkMotion(own.X_WB, end, kApart, SeekViolation::Any, stop);
    return check.status == CertificateStatus::Certified;
  };
  if (provedFree(own.mesh)) return 0.0;
  for (const double depth : kDepths) {
    const MeshPtr thin = thinnedBy(depth, own.mesh);
    if (thin != own.mesh && provedFree(thin)) return depth;
  }
  return std::numeric_limits<double>::infinity();
}

/// Time limit of the straight lines for a product.
constexpr double kSecondsOfAProduct = 3600.0;

/// Processor time of this process.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class SilentHost final : public SequenceHost {
 public:
  explicit SilentHost(StopToken stop) : stop_(std::move(stop)) {}
  const StopToken& stopToken() const override { return stop_; }
  ThreadTeam& team() override { return team_; }
  void asking(const std::vector<BodyGroup>&, int) override {}
  void stepFound(const AssemblyPlan&) override {}

 private:
  StopToken stop_;
  ThreadTeam team_{0};
};

StopToken limit() {
  return StopToken().withDeadline(std::chrono::steady_clock::now() +
                                  std::chrono::seconds(static_cast<long>(kSecondsOfAProduct)));
}

void sixAxesCells(const AssembledProduct& product, const BodySet& staying) {
  const double begin = seconds();
  const auto steps = sixAxesSequence(product, staying, limit());
  const double took = seconds() - begin;
  double deepest = 0.0;
  std::size_t unproved = 0;
  for (const SixAxesStep& step : steps) {
    const double depth = penetrationOf(product, step, {});
    if (std::isfinite(depth)) {
      deepest = std::max(deepest, depth);
    } else {
      ++unproved;
    }
  }
  std::cout << steps.size() << " | " << took << " | " << deepest * 1e3;
  if (unproved > 0) std::cout << ", of " << unproved << " more than 3";
}

Outcome ourCells(const AssembledProduct& product, const BodySet& staying) {
  const double begin = seconds();
  SilentHost host(limit());
  const auto fits = ProductFits::find(product, host.team(), {});
  if (!fits) return fits.error();
  SequenceRequest request;
  request.staying = staying;
  const auto plan = planSequence(product, *fits, request, host);
  if (!plan) return plan.error();
  const double took = seconds() - begin;
  const std::size_t valid = judgePlan(*plan, product, std::nullopt).validSteps();
  std::cout << plan->removed() << " | " << took << " | " << valid << " of " << plan->steps.size();
  return Done{};
}

Outcome compare(const std::string& file) {
  auto loaded = loadProduct(file);
  if (!loaded) return loaded.error();
  AssembledProduct& product = loaded->product;
  product.fits.on = true;
  BodySet staying(product.bodies.size(), false);
  staying[largestBody(product)] = true;
  std::cout << "| " << file.substr(file.rfind('/') + 1) << " | " << product.bodies.size() - 1 << " | " << std::flush;
  sixAxesCells(product, staying);
  std::cout << " | " << std::flush;
  const Outcome ours = ourCells(product, staying);
  std::cout << " |" << std::endl;
  return ours;
}

}  // namespace
}  // namespace glissade

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: six_axes_comparison FILE...\n";
    return 2;
  }
  std::cout
      << "| product | parts | six axes, 400 samples: leave | s | penetration, mm | Glissade: leave | s | steps that "
         "the check agrees with |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (int i = 1; i < argc; ++i) {
    const glissade::Outcome compared = glissade::compare(argv[i]);
    if (compared) continue;
    std::cerr << argv[i] << ": " << toString(compared.error().reason) << "\n";
    return 1;
  }
  return 0;
}
