// Exceptions of background work and of event handlers become diagnostics in the window.
#include <gtest/gtest.h>

#include <QTimer>
#include <QtTest>
#include <atomic>
#include <functional>

#include "app/window/guarded_application.h"
#include "app/window/window_actions.h"
#include "engine/base/guarded.h"
#include "engine/files/scenario_io.h"
#include "engine/session/run_comparison.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/failing_allocation.h"
#include "tests/engine/support/session_support.h"
#include "tests/engine/support/thrown_exceptions.h"
#include "widgets/document/knowledge_builder.h"
#include "widgets/document/replay_runner.h"
#include "widgets/workbench/work_controller.h"

namespace glissade {
namespace {

using test::FailingAllocation;
using test::kThrown;
using test::Thrown;
using Where = FailingAllocation::Where;

/// Records the diagnostics that a sender announces by failed().
template <class Sender>
class Failures {
 public:
  explicit Failures(Sender& sender) {
    QObject::connect(&sender, &Sender::failed, &sender, [this](const Diagnostic& why) { said_.push_back(why); });
  }
  bool come() {
    return QTest::qWaitFor([this] { return !said_.empty(); });
  }
  const std::vector<Diagnostic>& said() const { return said_; }

 private:
  std::vector<Diagnostic> said_;
};

class BackgroundExceptions : public testing::TestWithParam<std::tuple<bool, Thrown>> {
 protected:
  bool atOnce() const { return std::get<0>(GetParam()); }
  const Thrown& thrown() const { return std::get<1>(GetParam()); }
};

TEST_P(BackgroundExceptions, OfTheWorkAreTold) {
  BackgroundTask task;
  Failures failures(task);
  bool delivered = false;
  task.start(
      GLISSADE_TEXT("reading the parts"),
      [&](const WorkWatch&) -> BackgroundTask::Delivery {
        thrown().raise();
        return [&] { delivered = true; };
      },
      atOnce());
  ASSERT_TRUE(failures.come());
  EXPECT_EQ(failures.said().front().kind, thrown().kind);
  EXPECT_NE(toString(failures.said().front().reason).find("while reading the parts"), std::string::npos);
  EXPECT_FALSE(task.isBusy());
  EXPECT_FALSE(delivered);
  // The next work runs as usual.
  task.start(
      GLISSADE_TEXT("reading the parts"),
      [&](const WorkWatch&) -> BackgroundTask::Delivery { return [&] { delivered = true; }; }, atOnce());
  EXPECT_TRUE(QTest::qWaitFor([&] { return delivered; }));
  EXPECT_EQ(failures.said().size(), 1U);
}

TEST_P(BackgroundExceptions, OfTheDeliveryAreTold) {
  BackgroundTask task;
  Failures failures(task);
  task.start(
      GLISSADE_TEXT("reading the parts"),
      [&](const WorkWatch&) -> BackgroundTask::Delivery { return [&] { thrown().raise(); }; }, atOnce());
  ASSERT_TRUE(failures.come());
  EXPECT_EQ(failures.said().front().kind, thrown().kind);
  EXPECT_FALSE(task.isBusy());
}

TEST_P(BackgroundExceptions, OfWorkThatIsCancelledAreNotTold) {
  BackgroundTask task;
  Failures failures(task);
  std::atomic<bool> thrownNow{false};
  const auto work = [&](const WorkWatch& watch) -> BackgroundTask::Delivery {
    while (!atOnce() && !watch.stop.stopRequested()) QThread::msleep(1);
    thrownNow = true;
    thrown().raise();
    return [] {};
  };
  if (atOnce()) GTEST_SKIP() << "what is done at once cannot be cancelled";
  task.start(GLISSADE_TEXT("reading the parts"), work, false);
  task.cancel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return thrownNow.load(); }));
  QTest::qWait(20);
  EXPECT_TRUE(failures.said().empty());
}

TEST_P(BackgroundExceptions, ReachTheWindowThroughTheWorkController) {
  QStatusBar bar;
  ActionCatalogue actions{windowActions(), nullptr};
  SessionBridge bridge{atOnce() ? SessionClock::Lockstep : SessionClock::RealTime};
  WorkController works{bridge, actions, bar};
  Failures failures(works);
  bool next = false;
  works.run(QStringLiteral("Reading the parts"), [&](const WorkWatch&) -> BackgroundTask::Delivery {
    thrown().raise();
    return [] {};
  });
  ASSERT_TRUE(failures.come());
  EXPECT_NE(toString(failures.said().front().reason).find("while reading the parts"), std::string::npos);
  EXPECT_FALSE(actions[QStringLiteral("work.cancel")]->isEnabled());
  works.run(QStringLiteral("Reading the parts"),
            [&](const WorkWatch&) -> BackgroundTask::Delivery { return [&] { next = true; }; });
  EXPECT_TRUE(QTest::qWaitFor([&] { return next; }));
}

INSTANTIATE_TEST_SUITE_P(Both, BackgroundExceptions, testing::Combine(testing::Bool(), testing::ValuesIn(kThrown)),
                         [](const testing::TestParamInfo<std::tuple<bool, Thrown>>& parameter) {
                           return std::string(std::get<0>(parameter.param) ? "AtOnce" : "InBackground") +
                                  std::get<1>(parameter.param).name;
                         });

LoadedScenario environment2() {
  auto loaded = loadScenario(test::sourceDirectory() + "/samples/environment-2/scenario.json");
  EXPECT_TRUE(loaded.ok());
  return std::move(loaded).value();
}

TEST(KnowledgeExceptions, AreToldAndTheNextBuildSucceeds) {
  const LoadedScenario scenario = environment2();
  KnowledgeBuilder builder;
  Failures failures(builder);
  bool finished = false;
  QObject::connect(&builder, &KnowledgeBuilder::finished, [&] { finished = true; });
  {
    const FailingAllocation failing(Where::OtherThreads, 50);
    builder.build(scenario.problem, 1e-4, nullptr, false);
    ASSERT_TRUE(failures.come());
  }
  EXPECT_EQ(failures.said().front().kind, ErrorKind::LimitReached);
  EXPECT_NE(toString(failures.said().front().reason).find("while building the environment model"), std::string::npos);
  EXPECT_FALSE(finished);
  builder.build(scenario.problem, 1e-4, nullptr, false);
  EXPECT_TRUE(QTest::qWaitFor([&] { return finished; }, 60'000));
}

TEST(ReplayExceptions, AreToldOrEndTheReplay) {
  const Problem problem = windowProblem();
  const auto session = makeLockstepSession(sessionConfig(problem));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, hasEnded));
  const auto log = std::make_shared<const RunLog>(joined(session->snapshot()->log));
  ReplayRunner runner;
  Failures failures(runner);
  ReplayProgress last;
  QObject::connect(&runner, &ReplayRunner::progressed, [&](const ReplayProgress& progress) { last = progress; });
  for (std::uint64_t first = 1; first < 3000; first *= 3) {
    last = {};
    const std::size_t before = failures.said().size();
    {
      const FailingAllocation failing(Where::OtherThreads, first);
      runner.run(problem, log, ReplayEnd::WithTheLog, false);
      ASSERT_TRUE(QTest::qWaitFor([&] { return last.ended || failures.said().size() > before; })) << first;
    }
    if (!last.ended) {
      EXPECT_EQ(failures.said().back().kind, ErrorKind::LimitReached);
    }
  }
  EXPECT_FALSE(failures.said().empty());
  last = {};
  runner.run(problem, log, ReplayEnd::WithTheLog, false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return last.ended; }));
  EXPECT_FALSE(firstDifference(*log, joined(last.latest->log)));
}

class SessionExceptions : public testing::TestWithParam<SessionClock> {};

/// If making a session fails anywhere, a snapshot says so, and the next call makes the session.
TEST_P(SessionExceptions, OfMakingASessionAreToldAndTheNextCallMakesIt) {
  const auto scenario = std::make_shared<const LoadedScenario>(environment2());
  auto renamed = std::make_shared<LoadedScenario>(*scenario);
  renamed->scenario.bodies.front().name = "renamed";
  const command::ExaminePath path{{{scenario->problem.start, Author::Computer}}, {}};
  const std::pair<const char*, std::function<void(SessionBridge&)>> calls[] = {
      {"open", [&](SessionBridge& bridge) { bridge.open(scenario); }},
      {"rearrange", [&](SessionBridge& bridge) { bridge.rearrange(scenario); }},
      {"rename", [&](SessionBridge& bridge) { bridge.rearrange(renamed); }},
      {"givePath", [&](SessionBridge& bridge) { bridge.givePath(path); }},
      {"setDevice", [&](SessionBridge& bridge) { bridge.setDevice(bridge.deviceId() == "hand" ? "expert" : "hand"); }},
      {"startFixed",
       [&](SessionBridge& bridge) {
         bridge.startFixed({scenario->parameters, "birrt", 1, "none"});
       }},
      {"post", [&](SessionBridge& bridge) { bridge.post(command::SetSeed{7}); }},
  };
  std::size_t failed = 0;
  for (const auto& entry : calls) {
    const auto& call = entry.second;
    SessionBridge bridge(GetParam());
    bridge.open(scenario);
    bridge.post(command::SetParameter{ParameterId::Alpha, 0.625});
    for (std::uint64_t first = 1; first < 2000; first += 1 + first / 4) {
      SCOPED_TRACE(std::string(entry.first) + ", allocation " + std::to_string(first));
      {
        const FailingAllocation failing(Where::ThisThread, first);
        (void)guarded(GLISSADE_TEXT("making a session"), [&] { call(bridge); });
      }
      ASSERT_NE(bridge.snapshot(), nullptr);
      if (const auto why = bridge.snapshot()->problem) {
        EXPECT_EQ(why->kind, ErrorKind::LimitReached);
        if (toString(why->reason).find("while preparing the planner") == std::string::npos)
          continue;  // the diagnostic is the session's own
        ++failed;
        EXPECT_EQ(bridge.snapshot()->state, SessionState::Failed);
      }
      const auto& [otherName, other] = calls[first % std::size(calls)];
      SCOPED_TRACE(otherName);
      other(bridge);
      bridge.setDevice("novice");
      ASSERT_NE(bridge.snapshot(), nullptr);
      EXPECT_FALSE(bridge.snapshot()->problem);
    }
    EXPECT_EQ(bridge.snapshot()->parameters.objectRadius(), scenario->parameters.objectRadius());
  }
  EXPECT_GT(failed, 20U);
}

INSTANTIATE_TEST_SUITE_P(Both, SessionExceptions, testing::Values(SessionClock::Lockstep, SessionClock::RealTime),
                         [](const testing::TestParamInfo<SessionClock>& parameter) {
                           return parameter.param == SessionClock::Lockstep ? "lockstep" : "realtime";
                         });

GuardedApplication& application() { return *static_cast<GuardedApplication*>(QCoreApplication::instance()); }

class EventExceptions : public testing::TestWithParam<Thrown> {
 protected:
  void SetUp() override {
    application().setFailureHandler([this](const Diagnostic& why) { said.push_back(why); });
  }
  void TearDown() override { application().setFailureHandler({}); }

  std::vector<Diagnostic> said;
};

TEST_P(EventExceptions, OfASlotAreToldAndTheWindowGoesOn) {
  QObject receiver;
  QTimer::singleShot(0, &receiver, [] { GetParam().raise(); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !said.empty(); }));
  EXPECT_EQ(said.front().kind, GetParam().kind);
  EXPECT_NE(toString(said.front().reason).find("while handling an event"), std::string::npos);
  bool next = false;
  QTimer::singleShot(0, &receiver, [&] { next = true; });
  EXPECT_TRUE(QTest::qWaitFor([&] { return next; }));
}

TEST_P(EventExceptions, OfAQueuedSlotAreTold) {
  QObject receiver;
  QMetaObject::invokeMethod(
      &receiver, [] { GetParam().raise(); }, Qt::QueuedConnection);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !said.empty(); }));
}

INSTANTIATE_TEST_SUITE_P(Each, EventExceptions, testing::ValuesIn(kThrown),
                         [](const testing::TestParamInfo<Thrown>& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace glissade

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  glissade::GuardedApplication application(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
