// The headset with the runtime for tests, on a virtual display: see with_headset.sh.
#include "widgets/openxr/openxr_headset.h"
#include "engine/geometry/least_rotation.h"

#include <gtest/gtest.h>

#include <QImage>

#include <cmath>
#include <filesystem>
#include <future>
#include <random>
#include <thread>

#include "engine/files/scenario_io.h"
#include "engine/geometry/primitives.h"
#include "engine/planning/clearance_profile.h"
#include "tests/app/golden_picture.h"
#include "tests/widgets/headset/runtime/headset_script.h"
#include "tests/widgets/headset/window_target.h"
#include "widgets/openxr/picture_rate.h"
#include "widgets/openxr/private_context.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/merged_bodies.h"
#include "widgets/scene3d/scene_renderer.h"

namespace glissade {
namespace {

using namespace std::chrono_literals;
using test::EyePicture;

/// The head before environment 1 on its table, looking down at it and turned a little to the left.
const Pose kHead{Vector3(0.05, 1.3, -0.1),
                 Quaternion(Eigen::AngleAxisd(0.1, Vector3::UnitY()) * Eigen::AngleAxisd(-0.45, Vector3::UnitX()))};

std::size_t threads() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& task : std::filesystem::directory_iterator("/proc/self/task")) ++count;
  return count;
}

QImage imageOf(const EyePicture& picture) {
  return QImage(picture.rgba.data(), picture.width, picture.height, QImage::Format_RGBX8888).copy();
}

/// Measures the times of a window without a picture.
struct Gaps {
  using Clock = std::chrono::steady_clock;

  void begin() { last = begun = Clock::now(); }
  void addPicture() {
    const auto now = Clock::now();
    longest = std::max(longest, std::chrono::duration<double, std::milli>(now - last));
    last = now;
    ++pictures;
  }
  void end() {
    addPicture();
    all += Clock::now() - begun;
  }

  Clock::time_point last{};
  Clock::time_point begun{};
  std::chrono::duration<double, std::milli> longest{0.0};
  Clock::duration all{};
  int pictures = 0;
};

class OpenXrHeadsetTest : public testing::Test {
 protected:
  OpenXrHeadsetTest() {
    test::resetHeadset();
    auto loaded = loadScenario(test::sourceDirectory() + "/samples/environment-1/scenario.json");
    EXPECT_TRUE(loaded);
    start_ = loaded->problem.start.position;
    scenario_ = std::make_shared<const LoadedScenario>(std::move(*loaded));
    view_.setScenario(scenario_);
    room_ = placeRoom(view_.extent(), ProductSize::OnTable);
    headset_ = makeHeadset(view_);
    headset_->setPlacement(room_);
    headset_->setBackground(view_.background(), view_.backgroundBelow());
    test::setHead(kHead);
  }
  ~OpenXrHeadsetTest() override {
    headset_.reset();
    EXPECT_EQ(test::heldHandles(), 0);
    EXPECT_EQ(test::complaints(), std::vector<std::string>());
  }

  HeadsetState state() const { return headset_->status().state; }
  template <class Condition>
  bool until(Condition condition, std::chrono::milliseconds longest = 20s) {
    const auto end = std::chrono::steady_clock::now() + longest;
    while (!condition() && std::chrono::steady_clock::now() < end) {
      window_.draw(view_);
      if (gaps_ != nullptr) gaps_->addPicture();
      std::this_thread::sleep_for(2ms);
    }
    return condition();
  }
  bool becomes(HeadsetState wanted) {
    return until([&] { return state() == wanted; });
  }
  bool showsMore() {
    return until([before = test::shownPictures()] { return test::shownPictures() > before; });
  }
  std::vector<EyePicture> pictures() {
    showsMore();  // skips a picture of the earlier head and scene
    return test::nextPictures(20s);
  }

  Gaps* gaps_ = nullptr;                 ///< for the window's pictures; null: they are not counted
  test::WindowTarget window_{320, 320};  ///< the window's own context, on this thread
  SceneView view_;
  std::shared_ptr<const LoadedScenario> scenario_;
  Vector3 start_;  ///< position of the object
  RoomPlacement room_;
  std::unique_ptr<Headset> headset_;
};

/// Gives the window's camera the sight of this eye.
void lookThrough(CameraController& camera, const EyeSight& sight) {
  const EyeSides& sides = sight.sides;
  const double height = sides.up - sides.down;
  const Vector3 eye(-0.5 * (sides.left + sides.right), -0.5 * (sides.down + sides.up), 0.0);
  const Quaternion R_WV = sight.X_WE.orientation;
  const Vector3 middle = sight.X_WE.position - R_WV * eye;
  camera.setFieldOfView(2.0 * std::atan(0.5 * height));
  const double usualDistance = 0.5 * height / std::tan(0.5 * CameraController::usualFieldOfView());
  camera.setPose({middle - R_WV * Vector3::UnitZ(), R_WV, usualDistance, false});
  camera.setEyePlace({Vector3::Zero(), eye / height, std::nullopt});
}

TEST_F(OpenXrHeadsetTest, EachEyeSeesWhatAnOffAxisPictureOfTheWindowShows) {
  view_.setDepthShading(false);
  SceneColours colours;
  colours.background = Colour{0.5, 0.6, 0.7};
  view_.setColours(colours);
  headset_->setBackground(view_.background(), view_.backgroundBelow());
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  const std::vector<EyePicture> shown = pictures();
  ASSERT_EQ(shown.size(), 2U);
  for (std::size_t eye = 0; eye < 2; ++eye) {
    lookThrough(view_.camera(), sightOf(room_, kHead * test::scriptedEye(eye), test::scriptedSides(eye)));
    const QImage single = window_.picture(view_);
    const test::Difference found = test::difference(imageOf(shown[eye]), single);
    EXPECT_LT(found.mean, 0.5) << eye;
    EXPECT_LT(found.share, 0.002) << eye;
    const test::Difference other = test::difference(imageOf(shown[1 - eye]), single);
    EXPECT_GT(other.mean, 4.0 * found.mean + 2.0) << "the eyes see the same";
  }
}

TEST_F(OpenXrHeadsetTest, PicturesOfBothEyesWithAHorizon) {
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  const std::vector<EyePicture> shown = pictures();
  ASSERT_EQ(shown.size(), 2U);
  test::expectLikeGolden(imageOf(shown[0]), QStringLiteral("headset-left"));
  test::expectLikeGolden(imageOf(shown[1]), QStringLiteral("headset-right"));
}

/// The right hand points at the object, the left one at the ceiling.
TEST_F(OpenXrHeadsetTest, PicturesOfTheHandsWithTheRayThatMeetsTheObject) {
  const auto hands = std::make_shared<HandInputs>();
  headset_->setHands(hands);
  const Vector3 p_RO = room_.scale * (inverse(room_.X_WR) * start_);
  test::ControllerMoment right;
  right.X_RG.position = p_RO + Vector3(0.03, -0.15, 0.12);
  right.X_RG.orientation = leastRotation(-Vector3::UnitZ(), p_RO - right.X_RG.position);
  test::ControllerMoment left;
  left.X_RG = {p_RO + Vector3(-0.15, 0.1, 0.2), Quaternion(Eigen::AngleAxisd(1.2, Vector3::UnitX()))};
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  const QImage without = imageOf(pictures().at(0));
  test::setController(0, left);
  test::setController(1, right);
  const double distance = (right.X_RG.position - p_RO).norm() / room_.scale;
  hands->rightController.place.setFeedback({false, 0.0, distance});
  ASSERT_TRUE(until([&hands] { return hands->rightController.place.reading().X_WG.has_value(); }));
  const QImage open = imageOf(pictures().at(0));
  EXPECT_GT(test::difference(without, open).share, 0.01);
  test::expectLikeGolden(open, QStringLiteral("headset-hands"));
  hands->rightController.place.setFeedback({true, 0.0, distance});
  EXPECT_GT(test::difference(open, imageOf(pictures().at(0))).share, 0.002) << "a hand that holds the object";
}

double shareOfRed(const QImage& picture) {
  int red = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb pixel = picture.pixel(x, y);
      if (qRed(pixel) > 200 && qGreen(pixel) < 60 && qBlue(pixel) < 60) ++red;
    }
  }
  return static_cast<double>(red) / (picture.width() * picture.height());
}

TEST_F(OpenXrHeadsetTest, NoBodyHidesThePanel) {
  const auto tools = std::make_shared<HeadsetTools>();
  auto red = std::make_shared<FlatPicture>();
  red->width = red->height = 8;
  for (int pixel = 0; pixel < 64; ++pixel) red->rgba.insert(red->rgba.end(), {255, 0, 0, 255});
  tools->panel.set(red);
  tools->panelInFront = true;
  headset_->setTools(tools);
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  const double before = shareOfRed(imageOf(pictures().at(0)));
  EXPECT_GT(before, 0.02);
  LoadedScenario hidden = *scenario_;
  RigidBody body = hidden.obstacles.front();
  body.id = "before-the-panel";
  body.mesh = std::make_shared<const TriangleMesh>(makeBox(Vector3::Constant(0.1 / room_.scale)));
  body.X_WB = inWorld(room_, kHead * Pose::translation({0.0, 0.0, -0.4}));
  hidden.obstacles.push_back(body);
  view_.setScenario(std::make_shared<const LoadedScenario>(hidden));
  EXPECT_GT(shareOfRed(imageOf(pictures().at(0))), 0.98 * before);
}

/// The path is over the walls, coloured by its clearance; the ball is at its tightest place.
TEST_F(OpenXrHeadsetTest, PictureOfAPathAsATube) {
  test::setEyePixels(640);
  test::setHead({Vector3(0.05, 1.5, -0.35), Quaternion(Eigen::AngleAxisd(-0.95, Vector3::UnitX()))});
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  const QImage before = imageOf(pictures().at(0));
  auto path = std::make_shared<Path>();
  const Problem& problem = scenario_->problem;
  const Pose goal = std::get<Pose>(problem.goal);
  const Pose up = Pose::translation({0.0, 0.0, 4.5});
  for (const Pose& q : {problem.start, up * problem.start, up * goal, goal}) path->points.push_back({q});
  auto snapshot = std::make_shared<SessionSnapshot>();
  snapshot->state = SessionState::Solved;
  snapshot->path = path;
  const auto query = problem.world->makeQuery();
  view_.setSnapshot(snapshot);
  view_.setPathProfile(std::make_shared<const ClearanceProfile>(
      clearanceProfile(*query, path->configurations(), problem.metric(), 200)));
  const QImage shown = imageOf(pictures().at(0));
  EXPECT_GT(test::difference(before, shown).share, 0.001);
  test::expectLikeGolden(shown, QStringLiteral("headset-path"));
}

/// The product has four large balls of 20,480 triangles each. The clock is the runtime's.
TEST_F(OpenXrHeadsetTest, WherePicturesAreLateTheSceneIsSimplerUntilThereIsTime) {
  LoadedScenario many = *scenario_;
  const auto ball = std::make_shared<const TriangleMesh>(makeSphere(2.0, 5));
  for (int i = 0; i < 4; ++i) {
    RigidBody body = many.obstacles.front();
    body.id = BodyId("ball-" + std::to_string(i));
    body.mesh = ball;
    const int row = i / 2;
    body.X_WB = Pose::translation({5.0 * (i % 2), 0.0, 5.0 * row});
    many.obstacles.push_back(body);
  }
  view_.setScenario(std::make_shared<const LoadedScenario>(many));
  headset_->setPlacement(placeRoom(view_.extent(), ProductSize::OnTable));
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  ASSERT_TRUE(until([this] { return headset_->figures().triangles > 0; }));
  const HeadsetFigures full = headset_->figures();
  test::setPictureInterval(1.0 / 45.0);
  ASSERT_TRUE(until([this] { return headset_->figures().detailStep + 1 == PictureRate::kSteps; }, 120s));
  EXPECT_TRUE(until([&] { return 2 * headset_->figures().triangles < full.triangles; }))
      << headset_->figures().triangles << " of " << full.triangles;
  const HeadsetFigures simple = headset_->figures();
  std::printf("for each eye: %d draw calls, %lld triangles; at least %d, %lld\n", full.drawCalls,
              static_cast<long long>(full.triangles), simple.drawCalls, static_cast<long long>(simple.triangles));
  test::setPictureInterval(1.0 / 90.0);
  EXPECT_TRUE(until([&] { return headset_->figures().detailStep + 2 == PictureRate::kSteps; }, 120s))
      << "it comes back";
}

class ManyBodiesInHeadsetTest : public OpenXrHeadsetTest {
 protected:
  static constexpr int kSide = 12;  ///< bodies along a side of the wall

  /// Builds a wall of boxes in three colours.
  ManyBodiesInHeadsetTest() {
    LoadedScenario many = *scenario_;
    const auto box = std::make_shared<const TriangleMesh>(makeBox({0.3, 0.3, 0.3}));
    for (int i = 0; i < kSide * kSide; ++i) {
      RigidBody body = many.obstacles.front();
      body.id = BodyId("box-" + std::to_string(i));
      body.mesh = box;
      const int row = i / kSide;
      body.X_WB = Pose::translation({0.5 * (i % kSide) - 2.0, -3.0, 0.4 * row});
      body.colour = {0.3 * (i % 3), 0.9, 1.0 - 0.3 * (i % 3)};
      many.obstacles.push_back(body);
    }
    first_ = scenario_->obstacles.size();
    view_.setDepthShading(false);
    SceneColours colours;
    colours.background = Colour{0.5, 0.6, 0.7};
    view_.setColours(colours);
    view_.setScenario(std::make_shared<const LoadedScenario>(many));
    room_ = placeRoom(view_.extent(), ProductSize::OnTable);
    headset_->setPlacement(room_);
    headset_->setBackground(view_.background(), view_.backgroundBelow());
    headset_->start();
  }

  bool isMerged() {
    return until([this] { return headset_->figures().drawCalls > 0 && headset_->figures().drawCalls < kSide * kSide; });
  }
  void expectLikeWindow(const char* what) {
    const QImage eye = imageOf(pictures().at(0));
    lookThrough(view_.camera(), sightOf(room_, kHead * test::scriptedEye(0), test::scriptedSides(0)));
    const test::Difference found = test::difference(eye, window_.picture(view_));
    // Edges of bodies that are drawn together fade as edges of the middle body: 1.1 and 0.007 were measured.
    EXPECT_LT(found.mean, 1.2) << what;
    EXPECT_LT(found.share, 0.0085) << what;
  }

  std::size_t first_ = 0;  ///< index of the wall's first obstacle
};

TEST_F(ManyBodiesInHeadsetTest, BodiesThatStandStillAreDrawnTogetherAndWhatChangesIsSeen) {
  ASSERT_TRUE(becomes(HeadsetState::Running));
  ASSERT_TRUE(isMerged()) << headset_->figures().drawCalls;
  expectLikeWindow("merged");
  const QImage before = imageOf(pictures().at(0));
  view_.placeObstacle(first_ + kSide + 3, Pose::translation({0.0, -4.0, 5.5}));
  EXPECT_GT(test::difference(before, imageOf(pictures().at(0))).mean, 0.01);
  expectLikeWindow("moved");
  view_.setHiddenBodies({"box-0", "box-1", "box-2", "box-40"});
  expectLikeWindow("hidden");
  view_.restoreObstacles();
  view_.setHiddenBodies({});
  view_.setBodyDisplayModes({{"box-50", DisplayMode::Wireframe}});
  expectLikeWindow("wireframe");
  ASSERT_TRUE(isMerged());
  for (int i = 0; i < 2 * MergedBodies::kStill; ++i) showsMore();
  expectLikeWindow("merged again");
}

TEST_F(OpenXrHeadsetTest, AnEditOfTheSceneIsSeenAndTheHeadMoves) {
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  const QImage before = imageOf(pictures().at(0));
  view_.setLayerVisible(SceneLayer::Bodies, false);
  const QImage without = imageOf(pictures().at(0));
  EXPECT_GT(test::difference(before, without).share, 0.05);
  view_.setLayerVisible(SceneLayer::Bodies, true);
  EXPECT_LT(test::difference(before, imageOf(pictures().at(0))).mean, 0.1);
  test::setHead(kHead * Pose::translation(Vector3(0.1, 0.0, 0.0)));
  EXPECT_GT(test::difference(before, imageOf(pictures().at(0))).mean, 1.0);
}

/// Mean row of the pixels that differ from the background in red; nothing where no such pixel is there.
double rowOfRed(const EyePicture& picture) {
  double sum = 0.0;
  double count = 0.0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t* pixel = &picture.rgba[4U * static_cast<std::size_t>(y * picture.width + x)];
      if (pixel[0] < 120 || pixel[1] > 60 || pixel[2] > 60) continue;
      sum += y;
      count += 1.0;
    }
  }
  return sum / count;
}

/// A red ball jumps between two heights while pictures are shown. The eyes are turned outwards, so that their rows
/// differ; each height has its own pair of rows.
TEST_F(OpenXrHeadsetTest, BothEyesShowAMovingBodyAtOneMoment) {
  LoadedScenario scene = *scenario_;
  RigidBody ball = scene.obstacles.front();
  ball.id = "ball";
  ball.mesh = std::make_shared<const TriangleMesh>(makeSphere(0.4, 3));
  ball.colour = {1.0, 0.0, 0.0};
  const std::array<Pose, 2> heights{Pose::translation({2.0, -1.0, 4.0}), Pose::translation({2.0, -1.0, 6.0})};
  ball.X_WB = heights[0];
  scene.obstacles.push_back(ball);
  view_.setDepthShading(false);
  view_.setScenario(std::make_shared<const LoadedScenario>(scene));
  const std::size_t index = scene.obstacles.size() - 1;
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  std::array<std::array<double, 2>, 2> rows{};
  for (std::size_t height = 0; height < 2; ++height) {
    view_.placeObstacle(index, heights[height]);
    const std::vector<EyePicture> shown = pictures();
    ASSERT_EQ(shown.size(), 2U);
    for (std::size_t eye = 0; eye < 2; ++eye) rows[height][eye] = rowOfRed(shown[eye]);
  }
  ASSERT_GT(std::abs(rows[0][0] - rows[1][0]), 5.0) << "the ball is seen at both heights";
  constexpr int kPictures = 60;
  int split = 0;
  for (int i = 0; i < kPictures; ++i) {
    auto taken = std::async(std::launch::async, [] { return test::nextPictures(20s); });
    for (std::size_t jump = 0; taken.wait_for(0s) != std::future_status::ready; ++jump) {
      view_.placeObstacle(index, heights[jump % 2]);
    }
    const std::vector<EyePicture> shown = taken.get();
    ASSERT_EQ(shown.size(), 2U);
    const double left = rowOfRed(shown[0]);
    const std::size_t height = std::abs(left - rows[0][0]) < std::abs(left - rows[1][0]) ? 0 : 1;
    if (std::abs(rowOfRed(shown[1]) - rows[height][1]) > 0.5) ++split;
  }
  EXPECT_EQ(split, 0) << "of " << kPictures;
}

/// Nothing ends, and the window says what was refused first.
TEST_F(OpenXrHeadsetTest, AThousandRefusedCallsLoseNothing) {
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  test::ControllerMoment moment;
  moment.X_RG = Pose::translation({0.2, 1.1, -0.3});
  test::setController(0, moment);
  test::setController(1, moment);
  const int sessions = test::madeSessions();
  test::refuse(1000);
  ASSERT_TRUE(until([] { return test::callsToRefuse() == 0; }, 120s));
  EXPECT_TRUE(showsMore());
  EXPECT_EQ(state(), HeadsetState::Running);
  EXPECT_EQ(test::madeSessions(), sessions);
  EXPECT_NE(headset_->status().refused.find("-22"), std::string::npos) << headset_->status().refused;
}

TEST_F(OpenXrHeadsetTest, WithoutAHeadsetThereIsNoThread) {
  window_.draw(view_);
  const std::size_t before = threads();
  const auto another = makeHeadset(view_);
  window_.draw(view_);
  EXPECT_EQ(threads(), before);
  EXPECT_EQ(another->status(), HeadsetStatus());
}

TEST_F(OpenXrHeadsetTest, SaysWhatIsMissingAndGoesOnWhenItComes) {
  test::setRuntimeThere(false);
  test::setHeadsetThere(false);
  headset_->start();
  ASSERT_TRUE(until([this] { return headset_->status().trouble == HeadsetTrouble::NoRuntime; }));
  test::setRuntimeThere(true);
  ASSERT_TRUE(until([this] { return headset_->status().trouble == HeadsetTrouble::NoHeadset; }));
  test::setWorn(false);
  test::setHeadsetThere(true);
  ASSERT_TRUE(becomes(HeadsetState::Idle));
  EXPECT_EQ(headset_->status().name, "Scripted headset");
  test::setWorn(true);
  ASSERT_TRUE(becomes(HeadsetState::Running));
  EXPECT_TRUE(showsMore());
}

TEST_F(OpenXrHeadsetTest, ALostSessionAndALostRuntimeComeBack) {
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  for (const auto lose : {test::loseSession, test::loseRuntime}) {
    const int sessions = test::madeSessions();
    lose();
    ASSERT_TRUE(until([sessions] { return test::madeSessions() > sessions; }));
    ASSERT_TRUE(becomes(HeadsetState::Running));
    EXPECT_TRUE(showsMore());
  }
}

TEST_F(OpenXrHeadsetTest, AfterThePersonHasLeftItWaitsUntilItIsAskedForAgain) {
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  const int sessions = test::madeSessions();
  test::leaveProgram();
  ASSERT_TRUE(becomes(HeadsetState::Left));
  EXPECT_TRUE(until([] { return test::heldHandles() == 0; }));
  std::this_thread::sleep_for(2 * HeadsetMachine::kFirstWait);
  EXPECT_EQ(test::madeSessions(), sessions);
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
}

/// A runtime reports each state once, whatever happens meanwhile.
TEST_F(OpenXrHeadsetTest, WhoLeavesWhileTheHeadsetIsTakenOffHasLeft) {
  for (const bool isPutOnAgain : {false, true}) {
    headset_->start();
    ASSERT_TRUE(becomes(HeadsetState::Running));
    const int sessions = test::madeSessions();
    test::setWorn(false);
    test::setWorn(isPutOnAgain);
    test::leaveProgram();
    EXPECT_TRUE(becomes(HeadsetState::Left));
    EXPECT_EQ(test::madeSessions(), sessions) << "nothing was lost";
    test::setWorn(true);
  }
}

TEST_F(OpenXrHeadsetTest, AStallHoldsNeitherTheWindowNorItsEdits) {
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  const auto stall = 2000ms;
  test::stallOnce(stall);
  ASSERT_TRUE(showsMore());  // a picture before the stall, or after it
  EXPECT_FALSE(headset_->status().stalls);
  const auto begin = std::chrono::steady_clock::now();
  int drawn = 0;
  for (; drawn < 10; ++drawn) {
    view_.setLayerVisible(SceneLayer::Object, drawn % 2 != 0);
    window_.draw(view_);
  }
  headset_->stop();
  EXPECT_EQ(state(), HeadsetState::Off);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, stall);
  EXPECT_TRUE(until([] { return test::heldHandles() == 0; }));
}

TEST_F(OpenXrHeadsetTest, AStallOfSecondsIsSaidUntilItEnds) {
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  test::stallOnce(4000ms);
  EXPECT_TRUE(until([this] { return headset_->status().stalls; }));
  EXPECT_TRUE(until([this] { return !headset_->status().stalls; }));
  EXPECT_EQ(state(), HeadsetState::Running);
}

TEST_F(OpenXrHeadsetTest, SomeHundredLossesStallsAndExitsAtRandomPoints) {
  std::mt19937 random(34);
  const auto number = [&random](int least, int most) { return std::uniform_int_distribution(least, most)(random); };
  headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  constexpr int kEvents = 300;
  for (int i = 0; i < kEvents; ++i) {
    switch (number(0, 9)) {
      case 0:
      case 1:
      case 2: test::loseRuntime(); break;
      case 3:
      case 4:
      case 5: test::loseSession(); break;
      case 6: test::stallOnce(std::chrono::milliseconds(number(1, 60))); break;
      case 7: test::setWorn(number(0, 3) > 0); break;
      case 8: test::leaveProgram(); break;
      default: headset_->stop(); break;
    }
    view_.setLayerVisible(SceneLayer::Bodies, number(0, 1) == 1);
    if (number(0, 1) == 1) window_.draw(view_);
    std::this_thread::sleep_for(std::chrono::milliseconds(number(0, 40)));
    if (state() == HeadsetState::Left || state() == HeadsetState::Off) headset_->start();
  }
  EXPECT_GT(test::madeSessions(), kEvents / 20);
  test::setWorn(true);
  if (state() != HeadsetState::Running) headset_->start();
  ASSERT_TRUE(becomes(HeadsetState::Running));
  EXPECT_TRUE(showsMore());
}

class HeadsetLossesTest : public OpenXrHeadsetTest {
 protected:
  /// Number of losses; GLISSADE_HEADSET_LOSSES=1000 takes minutes.
  const int losses_ = qEnvironmentVariableIsSet("GLISSADE_HEADSET_LOSSES")
                          ? qEnvironmentVariableIntValue("GLISSADE_HEADSET_LOSSES")
                          : 60;
  int number(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
  void drawFor(std::chrono::nanoseconds time) {
    until([] { return false; }, std::chrono::duration_cast<std::chrono::milliseconds>(time));
  }

  void lose() {
    ASSERT_TRUE(becomes(HeadsetState::Running));
    const int sessions = test::madeSessions();
    switch (number(0, 9)) {
      case 0: test::stallOnce(std::chrono::milliseconds(number(1, 60))); return;
      case 1:
        test::leaveProgram();
        ASSERT_TRUE(becomes(HeadsetState::Left));
        headset_->start();
        return;
      case 2:
        test::setWorn(false);
        drawFor(std::chrono::milliseconds(number(0, 20)));
        test::setWorn(true);
        return;
      case 3:
      case 4:
      case 5: test::loseSession(); break;
      default: test::loseRuntime(); break;
    }
    EXPECT_TRUE(until([&] { return test::madeSessions() > sessions; }));
  }

 private:
  std::mt19937 random_{7};
};

/// Losses alternate with times of equal length without a headset. The gaps are printed, not judged, because the machine
/// may be busy.
TEST_F(HeadsetLossesTest, TheWindowDrawsOnWhileTheHeadsetIsLostAgainAndAgain) {
  constexpr int kTogether = 20;
  Gaps alone;
  Gaps beside;
  const auto count = [this](Gaps& gaps, const auto& work) {
    gaps_ = &gaps;
    gaps.begin();
    work();
    gaps.end();
    gaps_ = nullptr;
  };
  for (int done = 0; done < losses_ && !HasFailure(); done += kTogether) {
    const auto before = beside.all;
    headset_->start();
    count(beside, [&] {
      for (int i = 0; i < kTogether && !HasFailure(); ++i) {
        lose();
        drawFor(std::chrono::milliseconds(number(0, 30)));
      }
    });
    headset_->stop();
    ASSERT_TRUE(until([] { return test::heldHandles() == 0; }));
    count(alone, [&] { drawFor(beside.all - before); });
  }
  std::printf("%d losses in %.1f s; longest gap of the window %.0f ms (%d pictures), %.0f ms (%d) without a headset\n",
              losses_, std::chrono::duration<double>(beside.all).count(), beside.longest.count(), beside.pictures,
              alone.longest.count(), alone.pictures);
  EXPECT_GT(beside.pictures, losses_ / 10) << "the window goes on";
}

}  // namespace
}  // namespace glissade
