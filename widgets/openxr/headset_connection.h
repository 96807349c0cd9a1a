#pragma once

#include <array>
#include <memory>

#include "widgets/openxr/controller_actions.h"
#include "widgets/openxr/controller_link.h"
#include "widgets/openxr/eye_swapchain.h"
#include "widgets/openxr/headset_runtime.h"
#include "widgets/openxr/headset_scene.h"
#include "widgets/openxr/headset_session.h"
#include "widgets/openxr/headset_tools.h"
#include "widgets/openxr/panel_in_room.h"
#include "widgets/openxr/picture_rate.h"
#include "widgets/openxr/room_walk.h"

namespace glissade {

/// Runtime, session, controllers and pictures of both eyes, which end together when one of them is lost. Functions
/// throw HeadsetFailure.
class HeadsetConnection {
 public:
  /// Precondition: `scene` outlives the connection.
  HeadsetConnection(HeadsetScene& scene, HandInputsPtr hands, HeadsetToolsPtr tools);
  ~HeadsetConnection();
  HeadsetConnection(const HeadsetConnection&) = delete;
  HeadsetConnection& operator=(const HeadsetConnection&) = delete;

  const std::string& name() const { return runtime_.name(); }
  SessionChange poll() { return session_.poll(); }
  /// Waits until the runtime wants a picture, reads the controllers, moves the person, and shows the picture.
  void showPicture(RoomWalk& walk);
  /// Simplification of the scene, as PictureRate counts it.
  int detailStep() const { return rate_.step(); }
  /// The first call of pictures and controllers that the runtime refused, and its result; empty: none.
  const std::string& refused() { return session_.refused().first(); }

 private:
  void readControllers(XrTime time, const EyeViews& views, RoomWalk& walk);
  bool draw(const EyeViews& views, const RoomWalk& walk, std::array<XrCompositionLayerProjectionView, 2>& shown);
  bool acquire(std::array<unsigned, 2>& textures);
  ShownHands shownHands(const Pose& X_RH, const RoomPlacement& room, const std::optional<Vector3>& p_WT) const;
  std::vector<ShownPicture> textsInRoom(const Vector3& p_RH, const RoomPlacement& room) const;

  HeadsetScene& scene_;
  HeadsetRuntime runtime_;
  HeadsetSession session_;
  ControllerActions actions_;
  ControllerLink controllers_;
  HeadsetToolsPtr tools_;
  PanelInRoom panel_;
  PictureRate rate_;
  std::array<std::unique_ptr<EyeSwapchain>, 2> swapchains_;
};

}  // namespace glissade
