#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace glissade {

/// A picture that stands in the scene: rows from the top, 4 bytes a pixel, opaque or with its colours multiplied by the
/// opacity.
struct FlatPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};
using FlatPicturePtr = std::shared_ptr<const FlatPicture>;

/// Between the window, which paints a picture, and the thread that draws it into the scene: the latest wins. All
/// functions may be called on any thread and return at once.
class PictureMailbox {
 public:
  /// Null: there is none.
  void set(FlatPicturePtr picture) {
    const std::lock_guard lock(mutex_);
    picture_ = std::move(picture);
  }
  FlatPicturePtr get() const {
    const std::lock_guard lock(mutex_);
    return picture_;
  }

 private:
  mutable std::mutex mutex_;
  FlatPicturePtr picture_;
};

}  // namespace glissade
