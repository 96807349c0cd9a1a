// Compares moving one body with building the octree anew (paper 2, section 5.1.2: only the cells that the body leaves
// or enters are rebuilt).
#include "engine/base/random_stream.h"
#include "engine/geometry/primitives.h"
#include "engine/places/octree.h"
#include "tests/benchmarks/benchmark_program.h"

namespace glissade {
namespace {

const Box3 kWorkspace(Vector3::Zero(), Vector3::Constant(10.0));
const OctreeResolution kFine{10.0 / 1024, 0};  // cells of just under 1 cm

/// A hall of tilted boxes, and as the last body a part of 10 cm that moves: about two and a half million leaves.
std::vector<RigidBody> hall() {
  RandomStream stream(1, "hall");
  std::vector<RigidBody> bodies;
  for (int i = 0; i < 8; ++i) {
    RigidBody body;
    body.id = BodyId(std::to_string(i));
    body.mesh = std::make_shared<const TriangleMesh>(
        makeBox({stream.uniform(0.5, 2.5), stream.uniform(0.5, 2.5), stream.uniform(0.5, 2.5)}));
    for (int axis = 0; axis < 3; ++axis) body.X_WB.position[axis] = stream.uniform(1.0, 9.0);
    body.X_WB.orientation = fromRollPitchYaw(stream.uniform(0, 3), stream.uniform(0, 3), stream.uniform(0, 3));
    bodies.push_back(body);
  }
  RigidBody part;
  part.id = "part";
  part.mobility = Mobility::Mobile;
  part.mesh = std::make_shared<const TriangleMesh>(makeBox({0.1, 0.1, 0.1}));
  part.X_WB = Pose::translation({0.5, 0.5, 0.5});
  bodies.push_back(part);
  return bodies;
}

void buildAfresh(benchmark::State& state) {
  const std::vector<RigidBody> bodies = hall();
  std::size_t leaves = 0;
  for (auto _ : state) {
    const Octree octree(bodies, kWorkspace, kFine);
    leaves = octree.leafCount();
    benchmark::DoNotOptimize(leaves);
  }
  state.counters["leaves"] = static_cast<double>(leaves);
}
BENCHMARK(buildAfresh)->Unit(benchmark::kMillisecond);

/// Moves the last body 1 cm along an axis and back.
void move(benchmark::State& state, std::vector<RigidBody> bodies) {
  Octree octree(bodies, kWorkspace, kFine);
  Pose X_WB = bodies.back().X_WB;
  double way = 0.01;
  std::uint64_t cells = 0;
  for (auto _ : state) {
    X_WB.position[state.range(0)] += way;
    way = -way;
    const Octree::Change change = octree.moveBody(bodies.size() - 1, X_WB);
    cells = change.cellsLeft + change.cellsEntered;
  }
  state.counters["leaves"] = static_cast<double>(octree.leafCount());
  state.counters["cells"] = static_cast<double>(cells);
}

void moveOnePart(benchmark::State& state) { move(state, hall()); }
BENCHMARK(moveOnePart)->ArgName("axis")->Arg(0)->Unit(benchmark::kMillisecond);

/// Moves a cupboard of 1 x 2 x 3 m, which has about a fourteenth of all surfaces, as in the shape game.
void moveACupboard(benchmark::State& state) {
  std::vector<RigidBody> bodies = hall();
  bodies.back().mesh = std::make_shared<const TriangleMesh>(makeBox({1.0, 2.0, 3.0}));
  bodies.back().X_WB = Pose::translation({1.503, 2.501, 2.502});
  move(state, std::move(bodies));
}
BENCHMARK(moveACupboard)->ArgName("axis")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace glissade

GLISSADE_BENCHMARK_MAIN()
