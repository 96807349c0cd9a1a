#pragma once

#include <array>
#include <memory>

#include "widgets/headset/eye_swapchain.h"
#include "widgets/headset/headset_runtime.h"
#include "widgets/headset/headset_scene.h"
#include "widgets/headset/headset_session.h"

namespace glissade {

/// Runtime, session and pictures of both eyes together: all that ends when one of them is lost. Functions throw
/// HeadsetFailure.
class HeadsetConnection {
 public:
  /// `scene` outlives the connection.
  explicit HeadsetConnection(HeadsetScene& scene);

  const std::string& name() const { return runtime_.name(); }
  SessionNews poll() { return session_.poll(); }
  /// Waits until the runtime wants a picture, and shows it.
  void showPicture(const RoomPlacement& room);

 private:
  bool draw(XrTime time, const RoomPlacement& room, std::array<XrCompositionLayerProjectionView, 2>& shown);

  HeadsetScene& scene_;
  HeadsetRuntime runtime_;
  HeadsetSession session_;
  std::array<std::unique_ptr<EyeSwapchain>, 2> swapchains_;
};

}  // namespace glissade
