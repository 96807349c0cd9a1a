// A person renames a body in the list, and selects several bodies with a box in the scene.
#include <gtest/gtest.h>

#include <QLabel>
#include <QMouseEvent>

#include "tests/app/whole_window.h"
#include "widgets/product/scene_panel.h"

namespace glissade {
namespace {

class BodyMenuTest : public test::WholeWindowTest {
 protected:
  BodyMenuTest() {
    EXPECT_EQ(window_->openScenario(sample("bolted-brackets"), true), std::nullopt);
    window_->show();
    QApplication::processEvents();
  }

  WorkbenchDocument& document() { return window_->workbench().document; }
  QAction* action(const char* id) { return window_->workbench().actions[id]; }
  QWidget* scene() { return window_->workbench().scene.widget(); }

  QTreeWidgetItem* rowOf(const BodyId& id) {
    auto* list = window_->findChild<ScenePanel*>();
    for (QTreeWidgetItemIterator item(list); *item != nullptr; ++item) {
      if ((*item)->data(0, Qt::UserRole).toString().toStdString() == id.text()) return *item;
    }
    return nullptr;
  }

  void send(QEvent::Type type, const QPoint& at) {
    const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, button, held, Qt::ControlModifier | Qt::ShiftModifier);
    QCoreApplication::sendEvent(scene(), &event);
  }
  void drawBox(const QPoint& from, const QPoint& to) {
    send(QEvent::MouseButtonPress, from);
    send(QEvent::MouseMove, to);
    send(QEvent::MouseButtonRelease, to);
  }

  std::unique_ptr<MainWindow> window_ = makeWindow();
};

TEST_P(BodyMenuTest, ABodyIsRenamedInTheListAndTheNameCanBeUndone) {
  const BodyId id = document().scenario()->obstacles.front().id;
  ASSERT_NE(rowOf(id), nullptr);
  const QString before = rowOf(id)->text(0);
  rowOf(id)->setText(0, QStringLiteral("Support"));
  EXPECT_EQ(rowOf(id)->text(0), QStringLiteral("Support"));
  EXPECT_TRUE(document().isModified());
  action("edit.undo")->trigger();
  EXPECT_EQ(rowOf(id)->text(0), before);
  rowOf(id)->setText(0, QStringLiteral("a/b"));
  EXPECT_EQ(rowOf(id)->text(0), before) << "the name would be that of an assembly";
}

TEST_P(BodyMenuTest, ARunAndItsResultOutliveANameOfABody) {
  ASSERT_EQ(window_->openScenario(sample("sliding-plane"), true), std::nullopt);
  const auto snapshot = [this] { return window_->workbench().session.snapshot(); };
  const auto certificate = [this] { return window_->findChild<QLabel*>(QStringLiteral("certificate"))->text(); };
  const auto runToTheEnd = [this] {
    action("run.start")->trigger();
    ASSERT_TRUE(window_->workbench().scripts.carryOut("wait", {"ended", "20000"}));
  };
  runToTheEnd();
  ASSERT_EQ(snapshot()->state, SessionState::Solved);
  const SnapshotPtr solved = snapshot();
  const int nearest = solved->path->certificate.nearest.body;
  const QString before = certificate();
  rowOf(document().scenario()->obstacles.at(static_cast<std::size_t>(nearest)).id)->setText(0, QStringLiteral("Rail"));
  EXPECT_EQ(snapshot()->state, SessionState::Solved);
  EXPECT_EQ(snapshot()->path, solved->path);
  EXPECT_EQ(snapshot()->counts.nodes, solved->counts.nodes);
  EXPECT_NE(window_->workbench().run.snapshot(), nullptr);
  EXPECT_TRUE(certificate().contains(QStringLiteral("Rail"))) << certificate().toStdString();
  action("edit.undo")->trigger();
  EXPECT_EQ(certificate(), before);
  EXPECT_EQ(snapshot()->path, solved->path);
  const RigidBody rail = document().scenario()->obstacles.back();
  ASSERT_TRUE(document().place({AssemblyItem::Kind::Start, {}}, rail.X_WB));
  rowOf(rail.id)->setText(0, QStringLiteral("Beam"));
  runToTheEnd();
  ASSERT_TRUE(snapshot()->problem);
  const std::string refused = toString(*snapshot()->problem);
  EXPECT_NE(refused.find("Beam"), std::string::npos) << refused;
}

TEST_P(BodyMenuTest, ABoxSelectsTheBodiesInIt) {
  drawBox({0, 0}, {scene()->width() - 1, scene()->height() - 1});
  const SemanticDocument& semantics = document().semantics();
  EXPECT_GT(semantics.selection().bodies.size(), 2);
  EXPECT_FALSE(action("body.rename")->isEnabled()) << "several bodies";
  drawBox({0, 0}, {3, 3});
  EXPECT_TRUE(semantics.selection().bodies.isEmpty());
}

INSTANTIATE_TEST_SUITE_P(Languages, BodyMenuTest, testing::Values("en"));

}  // namespace
}  // namespace glissade
