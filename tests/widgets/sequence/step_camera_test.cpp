// The view follows the steps of a sequence, in the whole window.
#include "widgets/sequence/step_camera.h"

#include "engine/sequence/plan_playback.h"
#include "tests/app/whole_window.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/sequence/sequence_panel.h"

namespace glissade {
namespace {

class StepCameraTest : public test::WholeWindowTest {
 protected:
  StepCameraTest() {
    window_ = makeWindow();
    const ScriptCommands& scripts = window_->workbench().scripts;
    EXPECT_TRUE(scripts.carryOut("open", {sample("roller-stand").toStdString()}));
    EXPECT_TRUE(scripts.carryOut("plan-sequence", {"all"}));
    panel_ = window_->findChild<SequencePanel*>();
  }

  CameraController& camera() { return window_->workbench().scene.view().camera(); }

  /// Whether the bodies of the step are in the picture on their whole way.
  bool isInPicture(std::size_t step) {
    const ShownPlan& shown = panel_->shown();
    for (const StepMotion& motion : shown.plan->steps[step].motions) {
      for (const BodyId& id : motion.bodies()) {
        const RigidBody& body = shown.product->body(id);
        for (const PathPoint& point : motion.path) {
          const Pose X_WB = point.q * inverse(motion.path.front().q) * body.X_WB;
          for (const Vector3& vertex : body.mesh->vertices) {
            const auto at = camera().project(X_WB * vertex);
            if (!at || std::abs(at->x()) > 0.5 * camera().aspect() || std::abs(at->y()) > 0.5) return false;
          }
        }
      }
    }
    return true;
  }

  std::unique_ptr<MainWindow> window_;
  SequencePanel* panel_ = nullptr;
};

INSTANTIATE_TEST_SUITE_P(English, StepCameraTest, testing::Values("en"));

TEST_P(StepCameraTest, EachStepThatIsChosenIsInThePictureOnItsWholeWay) {
  for (std::size_t step = 0; step < panel_->shown().plan->steps.size(); ++step) {
    ASSERT_TRUE(panel_->chooseStep(step));
    EXPECT_TRUE(isInPicture(step)) << step;
  }
}

TEST_P(StepCameraTest, AllStepsAreInThePictureWhileTheyArePlayed) {
  window_->workbench().actions["sequence.play"]->setChecked(true);
  for (std::size_t step = 0; step < panel_->shown().plan->steps.size(); ++step) EXPECT_TRUE(isInPicture(step)) << step;
}

TEST_P(StepCameraTest, ACameraThatAPersonHasMovedIsNotZoomed) {
  ASSERT_TRUE(panel_->chooseStep(0));
  camera().zoom(2.0);
  const double distance = camera().distance();
  ASSERT_TRUE(panel_->chooseStep(1));
  EXPECT_EQ(camera().distance(), distance);
}

}  // namespace
}  // namespace glissade
