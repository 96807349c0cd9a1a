// The mouse in pictures for two eyes.
#include "widgets/scene3d/stereo_screen.h"

#include <QDockWidget>
#include <QMenuBar>
#include <QMouseEvent>

#include "tests/app/whole_window.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/view_cube.h"
#include "widgets/view/stereo_controller.h"
#include "widgets/workbench/scene_target.h"

namespace glissade {
namespace {

class StereoScreenTest : public test::WholeWindowTest {
 protected:
  StereoScreenTest() : window_(makeWindow()) {
    EXPECT_EQ(window_->openScenario(sample("teaching"), true), std::nullopt);
    window_->show();
    QCoreApplication::processEvents();
  }

  void choose(const char* action) { bench().actions[QLatin1String(action)]->trigger(); }
  const Workbench& bench() { return window_->workbench(); }
  QWidget& scene() { return *bench().scene.widget(); }
  StereoScreen& screen() { return *scene().findChild<StereoScreen*>(); }
  EyePlaceKeeper& keeper() { return *window_->findChild<EyePlaceKeeper*>(); }

  /// Sends a mouse event to the stereo screen, or to the scene if the screen is transparent for the mouse.
  void send(QEvent::Type type, const QPointF& at, Qt::MouseButtons buttons) {
    QWidget& target = screen().testAttribute(Qt::WA_TransparentForMouseEvents) ? scene() : screen();
    QMouseEvent event(type, at, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &event);
  }
  void click(const QPointF& at) {
    send(QEvent::MouseMove, at, Qt::NoButton);
    send(QEvent::MouseButtonPress, at, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, at, Qt::NoButton);
  }

  std::optional<QString> bodyAt(Eye eye, const QPointF& at) {
    CameraController& camera = bench().scene.view().camera();
    const EyePlace before = camera.eyePlace();
    camera.setEyePlace(keeper().eyes()[static_cast<std::size_t>(eye)]);
    const auto body = targetAt(bench(), at).body;
    camera.setEyePlace(before);
    return body;
  }

  /// A pixel at which this eye sees a body that the other eye does not see there.
  QPointF telling(Eye eye) {
    for (int y = 5; y < scene().height(); y += 10) {
      for (int x = 4; x < scene().width(); x += 4) {
        const auto body = bodyAt(eye, QPointF(x, y));
        const bool covered = scene().childAt(x, y) != nullptr && scene().childAt(x, y) != &screen();
        if (body && bodyAt(otherEye(eye), QPointF(x, y)) != body && !covered) return {double(x), double(y)};
      }
    }
    ADD_FAILURE() << "both eyes see the same everywhere";
    return {};
  }

  std::unique_ptr<MainWindow> window_;
};

TEST_P(StereoScreenTest, AClickTakesWhatTheEyeSeesThereInWhosePartItIs) {
  // The point of the composed picture that shows this point of an eye's picture.
  const auto part = [this](StereoMode mode, Eye eye, const QPointF& at) {
    const double second = eye == Eye::Right ? 0.5 : 0.0;
    if (mode == StereoMode::SideBySide) return QPointF(at.x() / 2.0 + second * scene().width(), at.y());
    if (mode == StereoMode::TopBottom) return QPointF(at.x(), at.y() / 2.0 + second * scene().height());
    return at;
  };
  for (const StereoModeEntry& entry : kStereoModes) {
    if (!bench().actions[QLatin1String(entry.action)]->isEnabled() || entry.mode == StereoMode::Off) continue;
    choose(entry.action);
    for (const Eye eye : {Eye::Left, Eye::Right}) {
      // If both eyes share the pixels, the pointer belongs to the left eye.
      if (!hasParts(entry.mode) && (eye == Eye::Right) != (entry.mode == StereoMode::RightEye)) continue;
      if (entry.mode == StereoMode::LeftEye && eye == Eye::Right) continue;
      const QPointF at = telling(eye);
      screen().repaint();
      click(part(entry.mode, eye, at));
      const auto selected = bench().document.semantics().selectedBodies();
      ASSERT_EQ(selected.size(), 1U) << entry.name;
      EXPECT_EQ(*selected.begin(), *bodyAt(eye, at)) << entry.name;
    }
  }
}

/// Records the positions of the mouse that a widget receives.
class SeenMouse final : public QObject {
 public:
  explicit SeenMouse(QWidget& widget) { widget.installEventFilter(this); }
  const std::vector<QPointF>& places() const { return places_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::MouseMove) places_.push_back(static_cast<QMouseEvent*>(event)->localPos());
    return QObject::eventFilter(watched, event);
  }

 private:
  std::vector<QPointF> places_;
};

TEST_P(StereoScreenTest, ADragThatLeavesItsPartGoesOn) {
  choose("stereo.side-by-side");
  const SeenMouse seen(scene());
  const double y = scene().height() / 2.0;
  const double middle = scene().width() / 2.0;
  send(QEvent::MouseButtonPress, {middle - 20, y}, Qt::LeftButton);
  send(QEvent::MouseMove, {middle + 20, y}, Qt::LeftButton);
  send(QEvent::MouseButtonRelease, {middle + 20, y}, Qt::NoButton);
  send(QEvent::MouseMove, {middle + 20, y}, Qt::NoButton);
  EXPECT_EQ(seen.places(), (std::vector<QPointF>{{2.0 * middle + 40, y}, {40, y}}));
}

/// Widgets over the scene receive the mouse in both parts.
TEST_P(StereoScreenTest, TheViewCubeIsClickedInBothParts) {
  choose("stereo.side-by-side");
  const auto* cube = scene().findChild<ViewCube*>();
  const QPointF middle = QPointF(cube->geometry().center());
  for (const double second : {0.0, 0.5}) {
    bench().scene.view().camera().setStandardView(StandardView::Isometric);
    const Quaternion before = bench().scene.view().camera().R_WV();
    click({middle.x() / 2.0 + second * scene().width(), middle.y() + 8.0});
    EXPECT_GT(before.angularDistance(bench().scene.view().camera().R_WV()), 0.1);
  }
}

TEST_P(StereoScreenTest, ItStaysOverWhatIsRaisedAndAdded) {
  choose("stereo.anaglyph");
  scene().findChild<ViewCube*>()->raise();
  auto* added = new QWidget(&scene());
  added->show();
  EXPECT_EQ(scene().children().last(), &screen());
  EXPECT_EQ(screen().size(), scene().size());
  choose("stereo.off");
  EXPECT_FALSE(screen().isVisible());
}

TEST_P(StereoScreenTest, TrueSizeIsThatOfTheScreen) {
  choose("stereo.anaglyph");
  choose("view.true-size");
  const CameraController& camera = bench().scene.view().camera();
  EXPECT_NEAR(camera.viewHeight(), keeper().pictureSize().height(), 1e-9);
  EXPECT_NEAR(camera.distance(), keeper().screen().distance, 1e-9);
}

TEST_P(StereoScreenTest, AFullScreenShowsTheSceneAloneAndCommandsKeepTheirKeys) {
  const auto* panel = window_->findChild<QDockWidget*>(QStringLiteral("interaction"));
  QCoreApplication::processEvents();
  const QRect place = panel->geometry();
  choose("view.full-screen");
  EXPECT_TRUE(window_->isFullScreen());
  EXPECT_TRUE(window_->menuBar()->isHidden());
  EXPECT_FALSE(panel->isVisible());
  EXPECT_TRUE(window_->actions().contains(bench().actions["run.start"]));
  choose("view.full-screen");
  EXPECT_FALSE(window_->isFullScreen());
  EXPECT_FALSE(window_->menuBar()->isHidden());
  QCoreApplication::processEvents();
  EXPECT_TRUE(panel->isVisible());
  EXPECT_EQ(panel->geometry(), place);
}

INSTANTIATE_TEST_SUITE_P(Languages, StereoScreenTest, testing::Values("en"));

}  // namespace
}  // namespace glissade
