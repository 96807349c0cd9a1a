#include "widgets/scene3d/graph_mutex.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>

#include "widgets/scene3d/scene_view.h"

namespace glissade {
namespace {

using namespace std::chrono_literals;

TEST(GraphMutex, ItsOwnerMayLockItAgain) {
  GraphMutex mutex;
  const std::lock_guard once(mutex);
  const std::lock_guard twice(mutex);
}

TEST(GraphMutex, OneAtATimeHasIt) {
  GraphMutex mutex;
  int count = 0;
  const auto countUp = [&] {
    for (int i = 0; i < 2000; ++i) {
      const std::lock_guard lock(mutex);
      ++count;
    }
  };
  std::thread other(countUp);
  countUp();
  other.join();
  EXPECT_EQ(count, 4000);
}

/// One thread draws without pause, as a headset does if drawing is slow.
TEST(GraphMutex, WhoWaitsIsNextHoweverBusyTheOtherIs) {
  GraphMutex mutex;
  std::atomic<int> drawn{0};
  std::atomic<bool> ends{false};
  std::thread drawer([&] {
    while (!ends) {
      const std::lock_guard lock(mutex);
      ++drawn;
      std::this_thread::sleep_for(500us);
    }
  });
  while (drawn == 0) std::this_thread::yield();
  int most = 0;
  for (int turn = 0; turn < 50; ++turn) {
    const int before = drawn;
    const std::lock_guard lock(mutex);
    most = std::max(most, drawn - before);
    std::this_thread::sleep_for(500us);
  }
  ends = true;
  drawer.join();
  // The system may stop this thread between reading the count and entering the queue.
  EXPECT_LE(most, 20);
}

/// Without the mutex, an edit would remove nodes that the headset is drawing.
TEST(GraphMutex, AnEditOfTheSceneWaitsForWhoDraws) {
  SceneView view;
  const std::function<void()> edits[] = {[&] { view.setHelp({}); },          [&] { view.setReach({}); },
                                         [&] { view.setMeasure({}); },       [&] { view.setScenario(nullptr); },
                                         [&] { view.setHiddenBodies({}); },  [&] { view.setSections({}); },
                                         [&] { view.setSnapshot(nullptr); }, [&] { view.setColours({}); }};
  for (std::size_t i = 0; i < std::size(edits); ++i) {
    std::atomic<bool> done{false};
    std::unique_lock drawing(*view.graphMutex());
    std::thread window([&] {
      edits[i]();
      done = true;
    });
    std::this_thread::sleep_for(20ms);
    EXPECT_FALSE(done) << i;
    drawing.unlock();
    window.join();
    EXPECT_TRUE(done) << i;
  }
}

}  // namespace
}  // namespace glissade
