// Works with threaded sessions for some time, in cycles, and writes what is in main memory after each.
// usage: session_soak SECONDS SEED FILE
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <thread>

#include "engine/base/memory_use.h"
#include "engine/base/random_stream.h"
#include "engine/files/scenario_io.h"
#include "engine/operator/device_registry.h"
#include "engine/session/replay_session.h"
#include "tests/engine/support/directories.h"

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kSamples[] = {"environment-1", "environment-2", "sliding-plane", "teaching"};
constexpr const char* kPlanners[] = {"contact-birrt", "auto", "gts", "ompl-rrtconnect"};
constexpr std::chrono::milliseconds kPlanning{1500};
/// Time limit of a stop on a loaded machine; device_latency_test measures how soon a session stops.
constexpr std::chrono::milliseconds kStopping{30'000};

struct Failure {
  std::string what;
};

bool hasEnded(const SessionSnapshot& snapshot) {
  return snapshot.run > 0 && !isRunning(snapshot) && !snapshot.pathWork;
}

/// Reads snapshots as a window does. True where the condition holds before the time is over.
template <class Condition>
bool follow(Session& session, const Condition& condition, std::chrono::milliseconds time) {
  const auto end = Clock::now() + time;
  while (Clock::now() < end) {
    if (condition(*session.snapshot())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  return false;
}

SessionConfig configOf(const LoadedScenario& scenario, const std::string& planner, std::uint64_t seed) {
  SessionConfig config{scenario.problem, scenario.parameters, planner, seed, nullptr};
  const DeviceRegistry devices = makeDeviceRegistry();
  const DeviceContext context{
      scenario.scenario.wayPoints, scenario.problem.metric(), seed, nullptr, scenario.problem.world, true};
  if (const DeviceEntry* novice = devices.find("novice")) config.device = novice->make(context);
  return config;
}

void replay(const LoadedScenario& scenario, const SessionSnapshot& end) {
  const auto log = std::make_shared<const RunLog>(joined(end.log));
  const auto problem = withRecordedKnowledge(scenario.problem, *log, {});
  if (!problem) throw Failure{toString(problem.error())};
  const auto session = makeReplaySession(*problem, log, ReplayEnd::WithTheLog);
  session->post(command::Start{});
  session->advance(500);
}

/// Plans, stops or waits for the path, smooths it, changes parameters, plans again, replays.
void cycle(const LoadedScenario& scenario, RandomStream& random) {
  const std::string planner = kPlanners[random.bits() % std::size(kPlanners)];
  const auto session = makeThreadedSession(configOf(scenario, planner, random.bits()));
  session->setWakeUp([] {});
  for (int run = 0; run < 2; ++run) {
    session->post(command::SetParameter{ParameterId::Alpha, random.uniform()});
    session->post(command::Start{});
    if (!follow(*session, hasEnded, kPlanning)) session->post(command::Stop{});
    if (!follow(*session, hasEnded, kStopping)) throw Failure{"the session does not stop"};
    session->post(command::SmoothPath{20});
    session->post(command::SetSeed{random.bits()});
  }
  if (!follow(*session, hasEnded, kStopping)) throw Failure{"smoothing does not end"};
  const SnapshotPtr end = session->snapshot();
  if (end->problem && end->problem->kind == ErrorKind::Internal) throw Failure{toString(*end->problem)};
  replay(scenario, *end);
  session->setWakeUp({});
}

int soak(double seconds, std::uint64_t seed, const std::string& report) {
  std::ofstream lines(report);
  RandomStream random(seed, "soak");
  const auto begin = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  for (std::size_t i = 0; elapsed() < seconds; ++i) {
    const std::string file =
        test::sourceDirectory() + "/samples/" + kSamples[i % std::size(kSamples)] + "/scenario.json";
    const auto scenario = loadScenario(file);
    if (!scenario) throw Failure{toString(scenario.error())};
    cycle(*scenario, random);
    const double resident = residentMegabytes();
    lines << elapsed() << " " << resident << " " << residentMegabytesAfterTrim() << " " << allocatedMegabytes()
          << std::endl;
  }
  return lines ? 0 : 1;
}

}  // namespace
}  // namespace glissade

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: session_soak SECONDS SEED FILE\n";
    return 2;
  }
  glissade::giveFreedMemoryBack();  // as the window does
  try {
    return glissade::soak(std::atof(argv[1]), std::strtoull(argv[2], nullptr, 10), argv[3]);
  } catch (const glissade::Failure& failure) {
    std::cerr << "session_soak: " << failure.what << "\n";
    return 1;
  }
}
