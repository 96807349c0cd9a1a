#include "widgets/openxr/eye_swapchain.h"

#include <osg/GL>

#include <algorithm>

#include "widgets/openxr/headset_failure.h"

// These headers come last, because their macros are common words.
#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <GL/glx.h>
#include <openxr/openxr_platform.h>

namespace glissade {
namespace {

/// The scene's colours are sRGB and are written unchanged, so that both formats have the same bytes. A runtime is
/// certain to read only the first format as sRGB.
constexpr std::int64_t kFormats[] = {GL_SRGB8_ALPHA8, GL_RGBA8};

}  // namespace

std::int64_t chooseColourFormat(XrSession session) {
  std::uint32_t count = 0;
  checkXr(xrEnumerateSwapchainFormats(session, 0, &count, nullptr), "xrEnumerateSwapchainFormats");
  std::vector<std::int64_t> formats(count);
  checkXr(xrEnumerateSwapchainFormats(session, count, &count, formats.data()), "xrEnumerateSwapchainFormats");
  for (const std::int64_t format : kFormats) {
    if (std::count(formats.begin(), formats.end(), format) > 0) return format;
  }
  throw HeadsetFailure(HeadsetTrouble::Failed, "no format of colours");
}

std::array<XrViewConfigurationView, 2> sizesOfEyes(const HeadsetRuntime& runtime) {
  XrViewConfigurationView empty{};
  empty.type = XR_TYPE_VIEW_CONFIGURATION_VIEW;
  std::array<XrViewConfigurationView, 2> eyes{empty, empty};
  std::uint32_t count = 0;
  checkXr(xrEnumerateViewConfigurationViews(runtime.instance(), runtime.system(),
                                            XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, 2, &count, eyes.data()),
          "xrEnumerateViewConfigurationViews");
  return eyes;
}

EyeSwapchain::EyeSwapchain(HeadsetSession& session, std::int64_t format, const XrViewConfigurationView& size)
    : session_(session),
      width_(static_cast<int>(size.recommendedImageRectWidth)),
      height_(static_cast<int>(size.recommendedImageRectHeight)) {
  XrSwapchainCreateInfo info{};
  info.type = XR_TYPE_SWAPCHAIN_CREATE_INFO;
  info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT;
  info.format = format;
  info.sampleCount = 1;
  info.width = size.recommendedImageRectWidth;
  info.height = size.recommendedImageRectHeight;
  info.faceCount = 1;
  info.arraySize = 1;
  info.mipCount = 1;
  checkXr(xrCreateSwapchain(session.handle(), &info, &swapchain_), "xrCreateSwapchain");
  try {
    readTextures();
  } catch (const HeadsetFailure&) {
    xrDestroySwapchain(swapchain_);
    throw;
  }
}

EyeSwapchain::~EyeSwapchain() { xrDestroySwapchain(swapchain_); }

void EyeSwapchain::readTextures() {
  std::uint32_t count = 0;
  checkXr(xrEnumerateSwapchainImages(swapchain_, 0, &count, nullptr), "xrEnumerateSwapchainImages");
  XrSwapchainImageOpenGLKHR empty{};
  empty.type = XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR;
  std::vector<XrSwapchainImageOpenGLKHR> images(count, empty);
  checkXr(xrEnumerateSwapchainImages(swapchain_, count, &count,
                                     reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())),
          "xrEnumerateSwapchainImages");
  for (const XrSwapchainImageOpenGLKHR& image : images) textures_.push_back(image.image);
}

/// After a refusal, a texture that an earlier refusal has left acquired is given back.
std::optional<unsigned> EyeSwapchain::acquire() {
  XrSwapchainImageAcquireInfo acquire{};
  acquire.type = XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO;
  std::uint32_t index = 0;
  RefusedCalls& refused = session_.refused();
  if (!refused.accept(xrAcquireSwapchainImage(swapchain_, &acquire, &index), "xrAcquireSwapchainImage")) {
    release();
    return std::nullopt;
  }
  XrSwapchainImageWaitInfo wait{};
  wait.type = XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO;
  wait.timeout = XR_INFINITE_DURATION;
  if (refused.accept(xrWaitSwapchainImage(swapchain_, &wait), "xrWaitSwapchainImage")) return textures_.at(index);
  release();
  return std::nullopt;
}

void EyeSwapchain::release() {
  XrSwapchainImageReleaseInfo info{};
  info.type = XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO;
  session_.refused().accept(xrReleaseSwapchainImage(swapchain_, &info), "xrReleaseSwapchainImage");
}

XrSwapchainSubImage EyeSwapchain::picture() const {
  XrSwapchainSubImage picture{};
  picture.swapchain = swapchain_;
  picture.imageRect.extent = {width_, height_};
  return picture;
}

}  // namespace glissade
