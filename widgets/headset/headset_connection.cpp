#include "widgets/headset/headset_connection.h"

#include <cmath>
#include <utility>

#include "widgets/headset/xr_pose.h"

namespace glissade {
namespace {

EyeSides sidesOf(const XrFovf& angles) {
  return {std::tan(angles.angleLeft), std::tan(angles.angleRight), std::tan(angles.angleDown),
          std::tan(angles.angleUp)};
}

}  // namespace

HeadsetConnection::HeadsetConnection(HeadsetScene& scene, HandInputsPtr hands)
    : scene_(scene),
      session_(runtime_, scene.context().handles()),
      actions_(runtime_, session_),
      controllers_(std::move(hands)) {
  const std::int64_t format = chooseColourFormat(session_.handle());
  const auto sizes = sizesOfEyes(runtime_);
  for (std::size_t eye = 0; eye < swapchains_.size(); ++eye) {
    swapchains_[eye] = std::make_unique<EyeSwapchain>(session_, format, sizes[eye]);
    scene_.setTarget(eye, swapchains_[eye]->width(), swapchains_[eye]->height(), format);
  }
}

void HeadsetConnection::showPicture(const RoomPlacement& room) {
  const XrFrameState frame = session_.waitFrame();
  session_.beginFrame();
  readControllers(frame.predictedDisplayTime, room);
  std::array<XrCompositionLayerProjectionView, 2> shown{};
  const bool isShown = frame.shouldRender == XR_TRUE && draw(frame.predictedDisplayTime, room, shown);
  XrCompositionLayerProjection layer{};
  layer.type = XR_TYPE_COMPOSITION_LAYER_PROJECTION;
  layer.space = session_.room();
  layer.viewCount = static_cast<std::uint32_t>(shown.size());
  layer.views = shown.data();
  session_.endFrame(frame.predictedDisplayTime, isShown ? &layer : nullptr);
}

void HeadsetConnection::readControllers(XrTime time, const RoomPlacement& room) {
  controllers_.take(actions_.read(time), room);
  for (const ControllerSide side : kBothSides) {
    if (const double push = controllers_.push(side); push > 0.0) actions_.pulse(side, push);
  }
}

bool HeadsetConnection::draw(XrTime time, const RoomPlacement& room,
                             std::array<XrCompositionLayerProjectionView, 2>& shown) {
  EyeViews views;
  if (!session_.locate(time, views)) return false;
  std::array<EyeSight, 2> eyes;
  std::array<unsigned, 2> textures{};
  for (std::size_t eye = 0; eye < views.size(); ++eye) {
    eyes[eye] = sightOf(room, poseOf(views[eye].pose), sidesOf(views[eye].fov));
    textures[eye] = swapchains_[eye]->acquire();
    shown[eye].type = XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW;
    shown[eye].pose = views[eye].pose;
    shown[eye].fov = views[eye].fov;
    shown[eye].subImage = swapchains_[eye]->picture();
  }
  scene_.draw(eyes, textures);
  for (auto& swapchain : swapchains_) swapchain->release();
  return true;
}

}  // namespace glissade
