#pragma once

#include <openxr/openxr.h>

#include <array>
#include <cstdint>
#include <vector>

#include "widgets/headset/headset_session.h"

namespace glissade {

/// Pictures of one eye, in turn: textures of the runtime. Functions throw HeadsetFailure.
class EyeSwapchain {
 public:
  EyeSwapchain(const HeadsetSession& session, std::int64_t format, const XrViewConfigurationView& size);
  ~EyeSwapchain();
  EyeSwapchain(const EyeSwapchain&) = delete;
  EyeSwapchain& operator=(const EyeSwapchain&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  /// The texture to draw into next, once the runtime does not read it any more. May wait.
  unsigned acquire();
  /// It is drawn.
  void release();
  /// The whole of the picture, as a layer names it.
  XrSwapchainSubImage picture() const;

 private:
  void readTextures();

  XrSwapchain swapchain_ = XR_NULL_HANDLE;
  int width_;
  int height_;
  std::vector<unsigned> textures_;
};

/// A format of colours that the runtime takes and that the scene is drawn in: of OpenGL, sRGB where there is one.
std::int64_t chooseColourFormat(XrSession session);
/// The size that the runtime wants for each eye.
std::array<XrViewConfigurationView, 2> sizesOfEyes(const HeadsetRuntime& runtime);

}  // namespace glissade
