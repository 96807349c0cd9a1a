#include "widgets/openxr/headset_connection.h"

#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "widgets/openxr/text_in_room.h"
#include "widgets/openxr/xr_pose.h"

namespace glissade {
namespace {

EyeSides sidesOf(const XrFovf& angles) {
  return {std::tan(angles.angleLeft), std::tan(angles.angleRight), std::tan(angles.angleDown),
          std::tan(angles.angleUp)};
}

/// Height of a text over the hand, metres of the room.
constexpr double kOverHand = 0.09;
/// Wait after a picture that the runtime refuses, so that the thread does not take a processor for itself.
constexpr std::chrono::milliseconds kRefusedWait{10};

/// The pose of the head: the middle of the eyes' poses.
Pose headOf(const EyeViews& views) { return interpolate(poseOf(views[0].pose), poseOf(views[1].pose), 0.5); }

}  // namespace

HeadsetConnection::HeadsetConnection(HeadsetScene& scene, HandInputsPtr hands, HeadsetToolsPtr tools)
    : scene_(scene),
      session_(runtime_, scene.context().handles()),
      actions_(runtime_, session_),
      controllers_(std::move(hands)),
      tools_(std::move(tools)) {
  const std::int64_t format = chooseColourFormat(session_.handle());
  const auto sizes = sizesOfEyes(runtime_);
  for (std::size_t eye = 0; eye < swapchains_.size(); ++eye) {
    swapchains_[eye] = std::make_unique<EyeSwapchain>(session_, format, sizes[eye]);
    scene_.setTarget(eye, swapchains_[eye]->width(), swapchains_[eye]->height(), format);
  }
}

/// Clears the pointer at the panel.
HeadsetConnection::~HeadsetConnection() { tools_->pointer.set(std::nullopt); }

void HeadsetConnection::showPicture(RoomWalk& walk) {
  const auto begun = session_.beginPicture();
  if (!begun) {
    std::this_thread::sleep_for(kRefusedWait);
    return;
  }
  const XrFrameState& frame = *begun;
  EyeViews views;
  const bool isTracked = session_.locate(frame.predictedDisplayTime, views);
  readControllers(frame.predictedDisplayTime, views, walk);
  std::array<XrCompositionLayerProjectionView, 2> shown{};
  const bool isShown = isTracked && frame.shouldRender == XR_TRUE && draw(views, walk, shown);
  if (isShown) {
    rate_.advance(PictureRate::Time(frame.predictedDisplayTime), PictureRate::Time(frame.predictedDisplayPeriod));
  } else {
    rate_.interrupt();
  }
  XrCompositionLayerProjection layer{};
  layer.type = XR_TYPE_COMPOSITION_LAYER_PROJECTION;
  layer.space = session_.room();
  layer.viewCount = static_cast<std::uint32_t>(shown.size());
  layer.views = shown.data();
  session_.endFrame(frame.predictedDisplayTime, isShown ? &layer : nullptr);
}

/// Input that the panel takes has no other effect. The walk comes before the hands' poses are converted to the world,
/// so that the hands move with the room.
void HeadsetConnection::readControllers(XrTime time, const EyeViews& views, RoomWalk& walk) {
  BothControllers states = actions_.read(time);
  const Pose X_RH = headOf(views);
  panel_.advance(states, {X_RH, controllers_.mainHand(), controllers_.holds(), tools_->panelInFront});
  tools_->pointer.set(panel_.touch() ? std::optional(panel_.touch()->pointer) : std::nullopt);
  walk.advance({states, X_RH.position, controllers_.mainHand(), controllers_.holds()});
  controllers_.take(states, walk.room());
  for (const ControllerSide side : kBothSides) {
    if (const double push = controllers_.push(side); push > 0.0) actions_.pulse(side, push);
  }
}

/// Takes the next texture of each eye; false if the runtime refuses one.
bool HeadsetConnection::acquire(std::array<unsigned, 2>& textures) {
  const auto left = swapchains_[0]->acquire();
  if (!left) return false;
  const auto right = swapchains_[1]->acquire();
  if (!right) {
    swapchains_[0]->release();
    return false;
  }
  textures = {*left, *right};
  return true;
}

/// False if the runtime refuses the textures.
bool HeadsetConnection::draw(const EyeViews& views, const RoomWalk& walk,
                             std::array<XrCompositionLayerProjectionView, 2>& shown) {
  std::array<EyeSight, 2> eyes;
  std::array<unsigned, 2> textures{};
  if (!acquire(textures)) return false;
  for (std::size_t eye = 0; eye < views.size(); ++eye) {
    eyes[eye] = sightOf(walk.room(), poseOf(views[eye].pose), sidesOf(views[eye].fov));
    shown[eye].type = XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW;
    shown[eye].pose = views[eye].pose;
    shown[eye].fov = views[eye].fov;
    shown[eye].subImage = swapchains_[eye]->picture();
  }
  scene_.draw(eyes, rate_.detail(), shownHands(headOf(views), walk.room(), walk.target()), textures);
  for (auto& swapchain : swapchains_) swapchain->release();
  return true;
}

/// Models, panel and texts to draw. The ray of a hand that points at the panel ends there.
ShownHands HeadsetConnection::shownHands(const Pose& X_RH, const RoomPlacement& room,
                                         const std::optional<Vector3>& p_WT) const {
  ShownHands hands{controllers_.shown(), p_WT, room.scale};
  if (const auto& touch = panel_.touch()) {
    hands.controllers[static_cast<std::size_t>(touch->side)].feedback.pointsAt = touch->distance / room.scale;
  }
  hands.panel = {panel_.X_RP(), PanelInRoom::kWidth, PanelInRoom::kHeight, tools_->panel.get()};
  hands.texts = textsInRoom(X_RH.position, room);
  if (hands.panel.X_WP) hands.panel.X_WP = inWorld(room, *hands.panel.X_WP);
  for (ShownPicture& text : hands.texts) {
    if (text.X_WP) text.X_WP = inWorld(room, *text.X_WP);
  }
  return hands;
}

/// The texts of the scene, and the note at the main hand.
std::vector<ShownPicture> HeadsetConnection::textsInRoom(const Vector3& p_RH, const RoomPlacement& room) const {
  std::vector<ShownPicture> texts;
  if (const FlatLabelsPtr labels = tools_->labels.get()) {
    for (const FlatLabel& label : *labels) texts.push_back(textInRoom(label.picture, inRoom(room, label.p_W), p_RH));
  }
  const auto hand = controllers_.shown()[static_cast<std::size_t>(controllers_.mainHand())];
  if (hand.reading.X_WG) {
    const Vector3 p_RN = inRoom(room, hand.reading.X_WG->position) + kOverHand * Vector3::UnitY();
    texts.push_back(textInRoom(tools_->note.get(), p_RN, p_RH));
  }
  return texts;
}

}  // namespace glissade
