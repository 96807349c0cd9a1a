// Joints that a person edits while a part is planned, in the window as a person has it: in real time, with work in the
// background.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QtTest/QTest>

#include "app/window/main_window.h"
#include "engine/files/scenario_io.h"
#include "tests/widgets/scene3d/unseen_scene.h"

namespace glissade {
namespace {

constexpr int kBodies = 100;

BodyDescription boxAt(const BodyId& id, const Vector3& size, const Vector3& at) {
  BodyDescription body{id};
  body.geometry = BoxGeometry{size};
  body.pose = Pose::translation(at);
  return body;
}

/// 100 boxes: the object in a room of six walls that it cannot leave, and a grid of others.
Scenario closedRoom() {
  constexpr double kHalf = 0.2;  // from the middle of the room to the middles of its walls
  Scenario scenario;
  scenario.name = "Closed room";
  scenario.object.first() = boxAt("object", Vector3::Constant(0.05), Vector3::Zero());
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-kHalf, kHalf}) {
      Vector3 size = Vector3::Constant(2.0 * kHalf - 0.011);
      size[axis] = 0.01;
      const BodyId id("wall_" + std::to_string(scenario.bodies.size()));
      scenario.bodies.push_back(boxAt(id, size, side * Vector3::Unit(axis)));
    }
  }
  for (int i = 0; scenario.bodies.size() + 1 < kBodies; ++i) {
    const int row = i / 10;
    const Vector3 at(1.0 + 0.1 * (i % 10), 0.1 * row, 0.0);
    scenario.bodies.push_back(boxAt(BodyId("box_" + std::to_string(i)), Vector3::Constant(0.05), at));
  }
  scenario.goal = Pose::translation({0.5, 0.0, 0.0});
  scenario.workspace = Box3(Vector3(-1.0, -1.0, -1.0), Vector3(3.0, 2.0, 1.0));
  scenario.planner = "birrt";
  return scenario;
}

class JointEdits : public testing::Test {
 protected:
  JointEdits() {
    window.resize(1280, 720);
    const QString file = folder.filePath(QStringLiteral("room.json"));
    EXPECT_TRUE(saveScenario(closedRoom(), file.toStdString()).ok());
    const auto why = window.openScenario(file, true);
    EXPECT_FALSE(why) << toString(*why);
  }

  const WorkbenchDocument& document() const { return window.workbench().document; }
  const SessionSnapshot& run() const { return *window.workbench().session.snapshot(); }
  void trigger(const char* action) { window.workbench().actions[QLatin1String(action)]->trigger(); }
  Outcome script(const std::string& command, const ScriptCommands::Words& words) {
    return window.workbench().scripts.carryOut(command, words);
  }
  /// Waits until the sequence is planned to its end.
  bool isPlanned() {
    return QTest::qWaitFor([this] { return document().plan() && document().plan()->end == PlanEnd::Complete; }, 60'000);
  }

  QTemporaryDir folder;
  MainWindow window{[](QWidget*) { return std::make_unique<test::UnseenScene>(); }, SessionClock::RealTime};
};

TEST_F(JointEdits, LeaveARunAloneAndThePlanFollowsThem) {
  ASSERT_EQ(document().scenario()->obstacles.size() + 1, kBodies);
  trigger("sequence.plan");
  ASSERT_TRUE(isPlanned());
  trigger("joints.find");
  trigger("run.start");
  ASSERT_TRUE(QTest::qWaitFor([this] { return run().run == 1 && run().counts.steps > 0; }, 20'000))
      << (run().problem ? toString(*run().problem) : std::string());

  Changes announced;
  QObject::connect(&document(), &WorkbenchDocument::changed, [&](Changes what) { announced |= what; });
  const auto before = document().plan();
  const auto scenario = document().scenario();
  ASSERT_TRUE(script("select", {"body", "box_7"}).ok());
  const auto isMade = [this] { return script("make-joint", {"flexible"}).ok(); };
  ASSERT_TRUE(QTest::qWaitFor(isMade, 20'000)) << "joints are made once the product's joints are found";
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().plan() != before && isPlanned(); }, 60'000));
  ASSERT_EQ(document().plan()->demands.joints.size(), 1U);
  EXPECT_EQ(document().plan()->demands.joints.front().key.body, "box_7");
  EXPECT_EQ(document().current().joints.size(), 1U);
  EXPECT_FALSE(announced & Change::Arrangement) << "a joint moves no body";
  EXPECT_EQ(document().scenario()->problem.world, scenario->problem.world);

  EXPECT_EQ(run().run, 1U);
  EXPECT_EQ(run().state, SessionState::Planning);
  const auto steps = run().counts.steps;
  EXPECT_TRUE(QTest::qWaitFor([&] { return run().counts.steps > steps; }, 20'000)) << "the run goes on";
}

}  // namespace
}  // namespace glissade
