#pragma once

#include "engine/sequence/motion_trial.h"
#include "engine/sequence/sequence_strategy.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade::test {

inline AssembledProduct productOf(std::vector<RigidBody> bodies, bool fits = false) {
  AssembledProduct product;
  product.deflections.assign(bodies.size(), 0.0);
  product.bodies = aboutTheirMiddles(std::move(bodies));
  product.fits.on = fits;
  std::vector<ProductBody> tree;
  for (const RigidBody& body : product.bodies) tree.push_back({body.id, {body.name}});
  product.tree = Product(tree);
  return product;
}

/// A ring along z at this height; inner radius 0: a cylinder.
inline RigidBody ringBody(const std::string& name, double inner, double outer, double length, double height,
                          int segments = 24) {
  RigidBody body = boxBody(name, {1.0, 1.0, 1.0}, Pose::translation({0.0, 0.0, height}));
  body.mesh = std::make_shared<const TriangleMesh>(makeRing(inner, outer, length, segments));
  return body;
}

/// A box of a body; the boxes of a body overlap.
struct Piece {
  Vector3 size;
  Vector3 at;
};
inline RigidBody bodyOf(const std::string& name, const std::vector<Piece>& pieces) {
  TriangleMesh mesh;
  for (const Piece& piece : pieces) append(mesh, transformed(makeBox(piece.size), Pose::translation(piece.at)));
  RigidBody body = boxBody(name, {1.0, 1.0, 1.0}, Pose::identity());
  body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return body;
}

/// A box with five walls of 0.1 around a room of 0.8, open at +x, with a hole in its top.
inline RigidBody cabinet() {
  return bodyOf("cabinet", {{{0.1, 1.0, 1.0}, {-0.45, 0.0, 0.0}},
                            {{1.0, 0.1, 1.0}, {0.0, -0.45, 0.0}},
                            {{1.0, 0.1, 1.0}, {0.0, 0.45, 0.0}},
                            {{1.0, 1.0, 0.1}, {0.0, 0.0, -0.45}},
                            {{1.0, 0.45, 0.1}, {0.0, -0.275, 0.45}},
                            {{1.0, 0.45, 0.1}, {0.0, 0.275, 0.45}},
                            {{0.45, 1.0, 0.1}, {-0.275, 0.0, 0.45}},
                            {{0.45, 1.0, 0.1}, {0.275, 0.0, 0.45}}});
}

/// A drawer in a cabinet with a pin through both, and a cap on the pin: cap, then pin, then drawer. The pin has a head
/// in the cabinet's top that holds it from below.
inline AssembledProduct lockedDrawer() {
  return productOf({bodyOf("drawer", {{{0.7, 0.3, 0.7}, {0.0, -0.2, 0.0}},
                                      {{0.7, 0.3, 0.7}, {0.0, 0.2, 0.0}},
                                      {{0.3, 0.7, 0.7}, {-0.2, 0.0, 0.0}},
                                      {{0.3, 0.7, 0.7}, {0.2, 0.0, 0.0}}}),
                    cabinet(), boxBody("pin", {0.08, 0.08, 0.6}, Pose::translation({0.0, 0.0, 0.22})),
                    bodyOf("cap", {{{0.3, 0.3, 0.1}, {0.0, 0.0, 0.58}},
                                   {{0.05, 0.3, 0.2}, {0.13, 0.0, 0.62}},
                                   {{0.05, 0.3, 0.2}, {-0.13, 0.0, 0.62}}})});
}

/// A frame around x = `at`, in the plane across `axis` (1 or 2), 1 wide with a window of 0.8.
inline RigidBody link(const std::string& name, double at, int axis) {
  const int other = 3 - axis;
  const auto along = [&](double x, double o) {
    Vector3 v = Vector3::Constant(0.1);
    v[0] = x;
    v[other] = o;
    return v;
  };
  const auto place = [&](double x, double o) {
    Vector3 v = Vector3::Zero();
    v[0] = at + x;
    v[other] = o;
    return v;
  };
  return bodyOf(name, {{along(1.0, 0.1), place(0.0, 0.45)},
                       {along(1.0, 0.1), place(0.0, -0.45)},
                       {along(0.1, 1.0), place(0.45, 0.0)},
                       {along(0.1, 1.0), place(-0.45, 0.0)}});
}

/// Two links of a chain beside a free block: the links block each other permanently.
inline AssembledProduct chain() {
  return productOf({link("one", 0.0, 1), link("other", 0.5, 2),
                    boxBody("block", {0.2, 0.2, 0.2}, Pose::translation({3.0, 0.0, 0.0}))});
}

/// A host without progress, with this number of threads. Stops after `mostWaves` waves.
class QuietHost final : public SequenceHost {
 public:
  explicit QuietHost(std::size_t threads = 1, std::size_t mostWaves = 1000) : team_(threads - 1), left_(mostWaves) {
    if (left_ == 0) source_.requestStop();
  }
  const StopToken& stopToken() const override { return stop_; }
  ThreadTeam& team() override { return team_; }
  void asking(const std::vector<BodyGroup>&, int) override {}
  void stepFound(const AssemblyPlan&) override {
    if (--left_ == 0) source_.requestStop();
  }

 private:
  ThreadTeam team_;
  std::size_t left_;
  StopSource source_;
  StopToken stop_ = source_.token();
};

inline ProductFits fitsOf(const AssembledProduct& product) {
  ThreadTeam alone(0);
  auto fits = ProductFits::find(product, alone, {});
  return std::move(*fits);
}

/// The plan by a registered strategy; `staying`: id of the body that stays.
inline AssemblyPlan planOf(const AssembledProduct& product, const BodyId& staying, std::size_t threads = 1,
                           const std::string& strategy = "greedy", const AssemblyPlan* resumed = nullptr) {
  const ProductFits fits = fitsOf(product);
  MotionTrial trial(product, fits, 1, 1);
  QuietHost host(threads);
  BodySet stay(product.bodies.size(), false);
  stay[product.indexOf(staying)] = true;
  return makeSequenceStrategyRegistry().find(strategy)->make()->plan({product, stay, 1, trial, resumed}, host);
}

/// The first body of each motion.
inline std::vector<BodyId> orderOf(const AssemblyPlan& plan) {
  std::vector<BodyId> order;
  for (const AssemblyStep& step : plan.steps) {
    for (const StepMotion& motion : step.motions) order.push_back(motion.body);
  }
  return order;
}

}  // namespace glissade::test
