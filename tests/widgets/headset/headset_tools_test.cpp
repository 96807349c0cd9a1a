// The tools of a person with a headset besides moving the object, in the whole window, with a headset whose answers the
// test sets.
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include <cmath>

#include "tests/app/whole_window.h"
#include "tests/widgets/headset/said_headset.h"
#include "widgets/controls/plain_message_box.h"
#include "widgets/devices/device_settings.h"
#include "widgets/headset/headset_panel_controller.h"
#include "widgets/sequence/sequence_panel.h"

namespace glissade {
namespace {

class HeadsetToolsTest : public testing::Test {
 protected:
  HeadsetToolsTest()
      : window_([this](QWidget*) { return std::make_unique<test::UnseenScene>(&headset_); }, SessionClock::Lockstep) {
    window_.setBatch(true);
    EXPECT_EQ(window_.openScenario(test::WholeWindowTest::sample("environment-1"), true), std::nullopt);
    action("view.headset").trigger();
    QCoreApplication::processEvents();
  }

  const Workbench& bench() { return window_.workbench(); }
  QAction& action(const char* id) { return *bench().actions[QLatin1String(id)]; }
  SceneView& view() { return bench().scene.view(); }
  ControllerInput& left() { return headset_.hands()->leftController; }
  /// Puts the hand to this pose; it points along its -z.
  void put(ControllerInput& controller, const Pose& X_WA, unsigned held = 0) {
    ControllerReading reading;
    reading.X_WG = reading.X_WA = X_WA;
    reading.held = held;
    controller.place.set(reading);
  }
  /// A pose at this distance in front of the middle of a body.
  Pose before(const RigidBody& body, double distance) {
    const Vector3 middle = boundingBox(*body.mesh, body.X_WB).center();
    return {middle + distance * Vector3::UnitZ(), Quaternion::Identity()};
  }
  const RigidBody& body(std::size_t i) { return bench().document.scenario()->obstacles[i]; }
  bool until(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, 5000); }

  test::SaidHeadset headset_;
  MainWindow window_;
};

TEST_F(HeadsetToolsTest, TheSectionFollowsTheHandWhileItsButtonIsHeld) {
  constexpr auto kButton = static_cast<unsigned>(ControllerButton::Lower);
  const Pose first{Vector3(1.0, 2.0, 3.0), Quaternion(Eigen::AngleAxisd(0.3, Vector3::UnitX()))};
  put(left(), first, 1U << kButton);
  left().buttons.mailbox.press(kButton);
  QCoreApplication::processEvents();
  const auto isAt = [this](const Pose& hand) {
    if (view().sections().size() != 1) return false;
    const Plane& plane = view().sections().front();
    const Vector3 towardsPerson = hand.orientation * Vector3::UnitZ();
    return plane.normal.dot(towardsPerson) > 0.999999 &&
           std::abs(plane.normal.dot(hand.position) - plane.offset) < 1e-9;
  };
  EXPECT_TRUE(isAt(first));
  const Pose second{Vector3(0.5, 1.0, 2.0), Quaternion(Eigen::AngleAxisd(-0.6, Vector3::UnitY()))};
  put(left(), second, 1U << kButton);
  EXPECT_TRUE(until([&] { return isAt(second); })) << "it is the same section";
  put(left(), second);
  QTest::qWait(50);
  put(left(), first);
  QTest::qWait(50);
  EXPECT_TRUE(isAt(second)) << "the button is released";
  action("section.remove-all").trigger();
  action("headset.section").trigger();
  EXPECT_TRUE(isAt(first)) << "by a key";
}

TEST_F(HeadsetToolsTest, TwoPointsOfTheRayAreMeasured) {
  put(left(), before(body(0), 10.0));
  action("headset.measure").trigger();
  EXPECT_TRUE(view().labels().empty());
  put(left(), Pose::translation({0.2, 0.0, 0.0}) * before(body(0), 10.0));
  action("headset.measure").trigger();
  ASSERT_EQ(view().labels().size(), 1U);
  EXPECT_NEAR(*view().labels().front().length, 0.2, 1e-3);
  EXPECT_TRUE(until([this] {
    const FlatLabelsPtr labels = headset_.tools().labels.get();
    return labels && labels->size() == 1;
  })) << "it is read in the headset";
  put(left(), {Vector3(0.0, 0.0, 1e3), Quaternion::Identity() * Quaternion(Eigen::AngleAxisd(3.1, Vector3::UnitX()))});
  action("headset.measure").trigger();
  EXPECT_TRUE(view().labels().empty()) << "the ray meets nothing: what was measured goes";
}

TEST_F(HeadsetToolsTest, TheNearestObstacleIsSaidAtTheHandThatHoldsTheObject) {
  SessionBridge& session = bench().session;
  const auto squeeze = [&](double share) {
    ControllerReading reading;
    reading.X_WG = reading.X_WA = session.snapshot()->device.q_device;
    reading.squeeze = share;
    for (int i = 0; i < 3; ++i) {  // the first steps grip, the next one reports the grip
      headset_.hands()->rightController.place.set(reading);
      session.advance(1);
      QCoreApplication::processEvents();
    }
  };
  session.post(command::Start{});
  squeeze(0.0);
  EXPECT_EQ(headset_.tools().note.get(), nullptr);
  squeeze(1.0);
  EXPECT_NE(headset_.tools().note.get(), nullptr);
  squeeze(0.0);
  EXPECT_EQ(headset_.tools().note.get(), nullptr);
}

/// Opens a product each of whose parts can be led, and starts the instruction.
class InstructionWalkTest : public HeadsetToolsTest {
 protected:
  explicit InstructionWalkTest(const char* sample = "interlocked/turn.json") {
    const QString file =
        QString::fromStdString(test::sourceDirectory()) + QStringLiteral("/samples/") + QLatin1String(sample);
    EXPECT_EQ(window_.openScenario(file, true), std::nullopt);
    EXPECT_TRUE(bench().scripts.carryOut("plan-sequence", {"all"}));
    EXPECT_GT(plan().steps.size(), 0U);
    put(right(), Pose::translation({100.0, 0.0, 0.0}));
    action("headset.instruction").trigger();
  }

  ControllerInput& right() { return headset_.hands()->rightController; }
  const AssemblyPlan& plan() { return *bench().document.plan(); }
  void hold(const Pose& X_WG, double squeeze) {
    ControllerReading reading;
    reading.X_WG = reading.X_WA = X_WG;
    reading.squeeze = squeeze;
    right().place.set(reading);
    QTest::qWait(50);
  }
  bool holds() { return right().place.feedback().holds; }
  /// Grips the part of the step at the start of its motion, and leads it back.
  void assemble(const AssemblyStep& step) {
    const auto& way = step.only().path;
    hold(way.back().q, 0.0);
    hold(way.back().q, 1.0);
    EXPECT_TRUE(until([this] { return holds(); }));
    for (std::size_t i = way.size() - 1; i-- > 0;) {
      for (const double share : {0.25, 0.5, 0.75, 1.0}) hold(interpolate(way[i + 1].q, way[i].q, share), 1.0);
    }
    EXPECT_TRUE(until([this] { return !holds(); })) << "it has snapped";
    hold(way.front().q, 0.0);
  }
};

TEST_F(InstructionWalkTest, EachPartIsLedAlongItsMotionUntilTheProductIsAssembled) {
  for (std::size_t i = plan().steps.size(); i-- > 0;) {
    const FlatPicturePtr before = headset_.tools().note.get();
    ASSERT_NE(before, nullptr) << "what is to be taken";
    ASSERT_TRUE(view().showsSequence());
    assemble(plan().steps[i]);
    EXPECT_NE(headset_.tools().note.get(), before);
  }
  EXPECT_NE(headset_.tools().note.get(), nullptr) << "done";
  action("headset.instruction").trigger();
  EXPECT_EQ(headset_.tools().note.get(), nullptr);
}

TEST_F(InstructionWalkTest, APartThatIsLetGoStaysAndTheObjectOfTheScenarioIsNotTaken) {
  const Pose object = bench().session.snapshot()->device.q_device;
  const AssemblyStep& step = plan().steps.back();
  hold(step.only().path.back().q, 0.0);
  hold(step.only().path.back().q, 1.0);
  ASSERT_TRUE(until([this] { return holds(); }));
  hold(step.only().path.back().q, 0.0);
  EXPECT_FALSE(holds());
  hold(object, 0.0);
  hold(object, 1.0);
  bench().session.advance(5);
  EXPECT_EQ(bench().session.snapshot()->device.q_device, object);
  hold(object, 0.0);
  action("headset.instruction").trigger();
}

class LongInstructionWalkTest : public InstructionWalkTest {
 protected:
  LongInstructionWalkTest() : InstructionWalkTest("roller-stand/scenario.json") {}
};

TEST_F(LongInstructionWalkTest, NextAndPreviousStepGoElsewhere) {
  ASSERT_GT(plan().steps.size(), 1U);
  SequencePanel& panel = *window_.findChild<SequencePanel*>();
  const double first = panel.time();
  const FlatPicturePtr note = headset_.tools().note.get();
  action("sequence.next-step").trigger();
  EXPECT_NEAR(panel.time(), first - 1.0, 1e-3) << "in the order of assembly";
  EXPECT_NE(headset_.tools().note.get(), note);
  action("sequence.previous-step").trigger();
  EXPECT_NEAR(panel.time(), first, 1e-3);
  action("sequence.previous-step").trigger();
  EXPECT_NEAR(panel.time(), first, 1e-3) << "there is none before";
}

TEST_F(InstructionWalkTest, AnotherPlanEndsIt) {
  EXPECT_EQ(window_.openScenario(test::WholeWindowTest::sample("environment-1"), true), std::nullopt);
  EXPECT_FALSE(action("headset.instruction").isChecked());
  EXPECT_FALSE(action("headset.instruction").isEnabled());
}

TEST_F(HeadsetToolsTest, ThereIsAPanelOnceTheHeadsetIsAskedFor) {
  EXPECT_TRUE(until([this] { return headset_.tools().panel.get() != nullptr; }));
  const FlatPicturePtr picture = headset_.tools().panel.get();
  EXPECT_EQ(picture->rgba.size(), 4U * static_cast<std::size_t>(picture->width * picture->height));
  action("headset.panel-in-front").trigger();
  EXPECT_TRUE(headset_.tools().panelInFront);
}

/// A person with a headset on does not see a message in the window.
TEST_F(HeadsetToolsTest, ErrorsAndQuestionsOfTheWindowAreAskedOnThePanelAndAnsweredThere) {
  HeadsetPage& page = *window_.findChild<HeadsetPanelController*>()->page();
  const auto text = [&page](const char* name) { return page.findChild<QLabel*>(QLatin1String(name))->text(); };
  const QWidget& question = *page.findChild<QWidget*>(QStringLiteral("headset-question"));
  const auto answers = [&question] {
    QList<QToolButton*> shown;
    for (QToolButton* button : question.findChildren<QToolButton*>()) {
      if (button->isVisible()) shown << button;
    }
    return shown;
  };
  EXPECT_TRUE(question.isHidden());
  PlainMessageBox box(QMessageBox::Question, QStringLiteral("t"), QStringLiteral("Which one?"),
                      QStringLiteral("There are two."), &window_);
  const QPushButton* first = box.addButton(QStringLiteral("&Keep"), QMessageBox::RejectRole);
  const QPushButton* second = box.addButton(QStringLiteral("&Take"), QMessageBox::AcceptRole);
  QAbstractButton* clicked = nullptr;
  QObject::connect(&box, &QMessageBox::buttonClicked, &box, [&](QAbstractButton* button) { clicked = button; });
  box.open();
  ASSERT_TRUE(until([&] { return !question.isHidden(); }));
  EXPECT_EQ(text("headset-asked"), QStringLiteral("Which one?"));
  EXPECT_EQ(text("headset-details"), QStringLiteral("There are two."));
  ASSERT_EQ(answers().size(), 2);
  EXPECT_EQ(page.childAt(page.rect().center())->window(), &page);
  EXPECT_TRUE(question.geometry().contains(page.rect().center())) << "nothing else is pressed meanwhile";
  for (QToolButton* button : answers()) {
    if (button->text() == QStringLiteral("Take")) button->click();
  }
  EXPECT_EQ(clicked, second);
  EXPECT_NE(clicked, first);
  EXPECT_TRUE(until([&] { return question.isHidden(); }));
  QDialog dialog(&window_);
  dialog.setWindowTitle(QStringLiteral("Film"));
  dialog.open();
  ASSERT_TRUE(until([&] { return !question.isHidden(); }));
  EXPECT_EQ(text("headset-asked"), QStringLiteral("Film"));
  ASSERT_EQ(answers().size(), 1);
  answers().front()->click();
  EXPECT_FALSE(dialog.isVisible());
  EXPECT_TRUE(until([&] { return question.isHidden(); }));
}

TEST_F(HeadsetToolsTest, WhereTheOnlyButtonIsTheGripItMeasuresNothing) {
  constexpr auto kTrigger = static_cast<std::size_t>(ControllerButton::Trigger);
  left().buttons.mailbox.connect("oculus/touch_controller");
  EXPECT_EQ(DeviceSettings().action(left().buttons, kTrigger), QStringLiteral("headset.measure"));
  left().buttons.mailbox.connect("khr/simple_controller");
  EXPECT_EQ(DeviceSettings().action(left().buttons, kTrigger), QString());
}

}  // namespace
}  // namespace glissade
