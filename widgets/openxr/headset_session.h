#pragma once

#include <openxr/openxr.h>

#include <array>
#include <optional>
#include <vector>

#include "widgets/openxr/headset_failure.h"
#include "widgets/openxr/headset_runtime.h"
#include "widgets/openxr/private_context.h"

namespace glissade {

/// Change of a session since the last poll().
enum class SessionChange { Nothing, Began, Ended, Left, Lost };

/// Both eyes at one time, in the room.
using EyeViews = std::array<XrView, 2>;

/// A session with the runtime: its states, its times, and the space of the room. Used on one thread, on which the
/// context is current. Functions throw HeadsetFailure.
class HeadsetSession {
 public:
  HeadsetSession(const HeadsetRuntime& runtime, const GlxHandles& handles);
  ~HeadsetSession();
  HeadsetSession(const HeadsetSession&) = delete;
  HeadsetSession& operator=(const HeadsetSession&) = delete;

  XrSession handle() const { return session_; }
  /// The space of the room: y up, the origin on the floor.
  XrSpace room() const { return room_; }
  /// Takes events until one of them changes the session.
  SessionChange poll();

  /// Waits for the time of the next picture, which the runtime decides, and begins the picture. Nothing where the
  /// runtime refuses it.
  std::optional<XrFrameState> beginPicture();
  /// Fills `views`; false if the head is not tracked.
  bool locate(XrTime time, EyeViews& views);
  /// Ends the picture; null: nothing is shown.
  void endFrame(XrTime time, const XrCompositionLayerProjection* layer);

  /// The calls of pictures and controllers that the runtime refused.
  RefusedCalls& refused() { return refused_; }

 private:
  void create(const GlxHandles& handles);
  void makeRoom();
  SessionChange take(const XrEventDataBuffer& event);
  SessionChange change(XrSessionState state);

  const HeadsetRuntime& runtime_;
  XrSession session_ = XR_NULL_HANDLE;
  XrSpace room_ = XR_NULL_HANDLE;
  RefusedCalls refused_;
};

}  // namespace glissade
