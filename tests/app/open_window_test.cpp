// The window as a person has it: in real time, with work in the background. The scene is not drawn.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest/QTest>

#include <algorithm>
#include <fstream>

#include "app/window/main_window.h"
#include "engine/files/scenario_bodies.h"
#include "engine/import/mesh_import.h"
#include "tests/engine/support/directories.h"
#include "tests/widgets/scene3d/unseen_scene.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/product/parts_dialog.h"
#include "widgets/sequence/sequence_panel.h"
#include "widgets/workbench/scene_target.h"

namespace glissade {
namespace {

/// Measures the longest time between two handled events.
class Heartbeat {
 public:
  Heartbeat() {
    timer_.setInterval(2);
    QObject::connect(&timer_, &QTimer::timeout, [this] {
      longest_ = std::max(longest_, clock_.elapsed());
      clock_.restart();
    });
    clock_.start();
    total_.start();
    timer_.start();
  }
  qint64 longest() const { return std::max(longest_, clock_.elapsed()); }
  qint64 total() const { return total_.elapsed(); }

 private:
  QTimer timer_;
  QElapsedTimer clock_;
  QElapsedTimer total_;
  qint64 longest_ = 0;
};

class OpenWindow : public testing::Test {
 protected:
  OpenWindow() { window.resize(1280, 720); }

  WorkbenchDocument& document() const { return window.workbench().document; }

  /// Waits until neither an edit nor background work has run for a while.
  bool isIdle() {
    int quiet = 0;
    return QTest::qWaitFor(
        [&] {
          const bool busy =
              document().isArranging() || window.workbench().actions[QStringLiteral("work.cancel")]->isEnabled();
          quiet = busy ? 0 : quiet + 1;
          return quiet > 20;
        },
        60'000);
  }

  static QString product() {
    return QString::fromStdString(test::sourceDirectory()) + QStringLiteral("/samples/bolted-brackets/scenario.json");
  }
  static QString sample() {
    return QString::fromStdString(test::sourceDirectory()) + QStringLiteral("/samples/environment-1/scenario.json");
  }

  bool moveSomething() {
    const AssemblyItem item{AssemblyItem::Kind::Body, bodyIdOf(document().scenario()->obstacles.front().id)};
    return document().place(item, Pose::translation({0.1, 0.2, 0.3})).ok() && isIdle();
  }

  /// Answers the next question, and notes its default button.
  void answer(QMessageBox::StandardButton button) {
    auto* look = new QTimer(&window);
    QObject::connect(look, &QTimer::timeout, [this, look, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      ++questions;
      byDefault = box->standardButton(box->defaultButton());
      look->deleteLater();
      box->button(button)->click();
    });
    look->start(5);
  }

  MainWindow window{[](QWidget*) { return std::make_unique<test::UnseenScene>(); }, SessionClock::RealTime};
  int questions = 0;
  QMessageBox::StandardButton byDefault = QMessageBox::NoButton;
};

TEST_F(OpenWindow, ASampleThatIsOnlyOpenedIsNeverModified) {
  window.show();
  answer(QMessageBox::Cancel);
  const QString samples = QString::fromStdString(test::sourceDirectory()) + QStringLiteral("/samples");
  QDirIterator files(samples, {QStringLiteral("*.json")}, QDir::Files, QDirIterator::Subdirectories);
  int opened = 0;
  while (files.hasNext()) {
    const QString file = files.next();
    if (file.contains(QStringLiteral("/studies/"))) continue;
    ASSERT_FALSE(window.openScenario(file, true)) << file.toStdString();
    ++opened;
    EXPECT_TRUE(isIdle()) << file.toStdString();
    EXPECT_FALSE(window.isWindowModified()) << file.toStdString();
    EXPECT_TRUE(window.close()) << file.toStdString();
    EXPECT_EQ(questions, 0) << file.toStdString();
    window.show();
  }
  EXPECT_GT(opened, 8);
}

TEST_F(OpenWindow, AFoundPathIsNoEditAndIsKeptOrDiscarded) {
  ASSERT_FALSE(window.openScenario(sample(), true));
  EXPECT_TRUE(isIdle());
  auto path = std::make_shared<Path>();
  path->points = {{document().scenario()->problem.start}, {Pose::translation({1, 2, 3})}};
  document().setResults({path, nullptr, {"auto", 3}, false});
  EXPECT_FALSE(window.isWindowModified());
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(window.close());
  EXPECT_EQ(questions, 1);
  EXPECT_EQ(byDefault, QMessageBox::Save) << "Enter keeps the path";
  answer(QMessageBox::Discard);
  EXPECT_TRUE(window.close());
}

TEST_F(OpenWindow, ASampleIsSavedAsACopy) {
  window.show();
  ASSERT_FALSE(window.openScenario(sample(), true));
  EXPECT_TRUE(isIdle());
  ASSERT_TRUE(moveSomething());
  EXPECT_TRUE(window.isWindowModified());
  QString proposed;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    look.stop();
    proposed = dialog->selectedFiles().value(0);
    dialog->reject();
  });
  look.start(5);
  window.workbench().actions["file.save"]->trigger();
  EXPECT_TRUE(proposed.endsWith(QStringLiteral("environment-1.json"))) << proposed.toStdString();
  EXPECT_TRUE(window.isWindowModified());
}

TEST_F(OpenWindow, AFilmIsNotEndedWithoutAQuestion) {
  ASSERT_FALSE(window.openScenario(sample(), true));
  const ScenarioPtr before = document().scenario();
  window.workbench().work.beginOther(
      window, QStringLiteral("Making the film"), [] {}, WorkController::Loss::Asked);
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(window.openScenario(sample()));
  EXPECT_EQ(questions, 1);
  EXPECT_EQ(byDefault, QMessageBox::Cancel);
  EXPECT_EQ(document().scenario(), before);
  window.workbench().work.endOther(window);
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(window.openScenario(sample()));
  EXPECT_EQ(questions, 1);
  EXPECT_NE(document().scenario(), before);
}

/// The text of a box with this edge, millimetres, at a place of a grid.
std::string boxAt(int number, double edge) {
  const int column = number % 32;
  const int row = number / 32;
  std::string text;
  for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7}) {
    const double x = 30.0 * column + (corner & 1 ? edge : 0.0);
    const double y = 30.0 * row + (corner & 2 ? edge : 0.0);
    text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(corner & 4 ? edge : 0.0) + "\n";
  }
  return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

class PartsInOpenWindow : public OpenWindow {
 protected:
  QStringList writeBoxes(int count) {
    QStringList files;
    for (int i = 0; i < count; ++i) {
      files << folder.filePath(QStringLiteral("part_%1.obj").arg(i, 4, 10, QLatin1Char('0')));
      std::ofstream(files.back().toStdString()) << boxAt(i, i == 0 ? 10.0 : 20.0);
    }
    return files;
  }

  /// Opens the dialog of parts and presses Create as soon as it is enabled.
  void createFrom(const QStringList& files) {
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, [&look] {
      const auto* dialog = qobject_cast<PartsDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || !dialog->isComplete()) return;
      look.stop();
      dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    });
    look.start(5);
    window.importParts(files);
  }

  QTemporaryDir folder;
};

TEST_F(PartsInOpenWindow, WhatIsDiscardedLeavesNoStarBehind) {
  window.show();
  createFrom(writeBoxes(2));
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().scenario() != nullptr; }, 20'000));
  EXPECT_TRUE(isIdle());
  EXPECT_FALSE(window.isWindowModified()) << "to look at parts is no edit";
  ASSERT_TRUE(moveSomething());
  EXPECT_TRUE(window.isWindowModified());
  answer(QMessageBox::Discard);
  EXPECT_FALSE(window.openScenario(sample()));
  EXPECT_EQ(questions, 1);
  EXPECT_EQ(byDefault, QMessageBox::Save);
  EXPECT_TRUE(isIdle());
  EXPECT_FALSE(window.isWindowModified());
  answer(QMessageBox::Cancel);
  EXPECT_TRUE(window.close());
  EXPECT_EQ(questions, 1);
}

/// The measure is the time of one process for each file, one after the other. Reading takes less time than this, and no
/// event waits for more than a quarter of it.
TEST_F(PartsInOpenWindow, AnswersWhileManyFilesAreRead) {
  const QStringList files = writeBoxes(200);
  QElapsedTimer alone;
  alone.start();
  for (const QString& file : files) ASSERT_TRUE(importMesh(file.toStdString()));
  const qint64 oneByOne = alone.elapsed();
  window.show();
  const Heartbeat heartbeat;
  createFrom(files);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().scenario() != nullptr; }, 60'000));
  EXPECT_LT(heartbeat.total(), oneByOne);
  EXPECT_LT(heartbeat.longest(), oneByOne / 4);
  EXPECT_EQ(document().scenario()->obstacles.size(), 199U);
}

/// The Stop of the tool bar stops what runs, whatever it is.
TEST_F(OpenWindow, StopEndsThePlanningOfASequence) {
  ASSERT_EQ(window.openScenario(product(), true), std::nullopt);
  ASSERT_TRUE(isIdle());
  const QAction& stop = *window.workbench().actions[QStringLiteral("run.stop")];
  EXPECT_FALSE(stop.isEnabled());
  window.workbench().actions[QStringLiteral("sequence.plan")]->trigger();
  EXPECT_TRUE(stop.isEnabled());
  window.workbench().actions[QStringLiteral("run.stop")]->trigger();
  ASSERT_TRUE(isIdle());
  EXPECT_FALSE(stop.isEnabled());
  EXPECT_EQ(window.findChild<SequencePanel*>()->shown().plan->end, PlanEnd::Interrupted);
}

TEST_F(OpenWindow, DecisionsInARowMarkThePlanAndBeginNoPlanning) {
  ASSERT_EQ(window.openScenario(product(), true), std::nullopt);
  ASSERT_TRUE(isIdle());
  QAction* plan = window.workbench().actions[QStringLiteral("sequence.plan")];
  plan->trigger();
  ASSERT_TRUE(isIdle());
  const auto& panel = *window.findChild<SequencePanel*>();
  const PlanPtr earlier = panel.shown().plan;
  for (const RigidBody& body : {document().scenario()->obstacles[0], document().scenario()->obstacles[1]}) {
    SemanticSelection bodies;
    bodies.bodies = {toQString(body.id)};
    ASSERT_TRUE(document().semantics().setAttribute(bodies, "stays", AttributeValue(true)));
    EXPECT_TRUE(panel.shown().isWaiting);
    EXPECT_EQ(panel.shown().before, earlier) << "its rows are grey";
    EXPECT_FALSE(window.workbench().actions[QStringLiteral("run.stop")]->isEnabled()) << "nothing is planned yet";
  }
  plan->trigger();
  EXPECT_FALSE(panel.shown().isWaiting);
  ASSERT_TRUE(isIdle());
  EXPECT_FALSE(panel.shown().growing);
}

/// A click on the moving part is not one on the body behind it, which Ctrl+click would then take out of the selection.
TEST_F(OpenWindow, TheMovingPartIsInFrontOfWhatIsBehindIt) {
  ASSERT_EQ(window.openScenario(sample(), true), std::nullopt);
  ASSERT_TRUE(isIdle());
  const Workbench& bench = window.workbench();
  const QSize size = bench.scene.widget()->size();
  int onObject = 0;
  for (int x = 0; x < size.width(); x += 4) {
    for (int y = 0; y < size.height(); y += 4) {
      const SceneTarget target = targetAt(bench, QPointF(x, y));
      if (!target.isObject) continue;
      ++onObject;
      EXPECT_EQ(target.body, toQString(document().scenario()->objectBodies.front().id));
    }
  }
  EXPECT_GT(onObject, 0);
}

}  // namespace
}  // namespace glissade
