#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "engine/operator/hand_inputs.h"
#include "engine/places/rigid_body.h"
#include "widgets/openxr/headset_machine.h"
#include "widgets/openxr/headset_tools.h"
#include "widgets/openxr/room_placement.h"

namespace glissade {

/// Costs of the headset's pictures, a few pictures old.
struct HeadsetFigures {
  int detailStep = 0;          ///< simplification of the scene; 0: full detail (PictureRate)
  int drawCalls = 0;           ///< for each eye
  std::int64_t triangles = 0;  ///< for each eye
  double cullSeconds = 0.0;    ///< for an eye: time in which the processor selects what to draw
  double drawSeconds = 0.0;    ///< for an eye: time of OpenGL's calls
};

/// Shows a scene in a headset, on a thread of its own. All functions are called on the window's thread and return at
/// once, whatever the headset does.
class Headset {
 public:
  /// Waits for the end of the thread, a second at most; a thread whose runtime does not answer is abandoned.
  virtual ~Headset() = default;

  /// Searches for a headset and shows the scene in it, until stop() is called or the person leaves.
  virtual void start() = 0;
  virtual void stop() = 0;
  /// A stall is seen by asking: no change is announced for it.
  virtual HeadsetStatus status() const = 0;
  virtual HeadsetFigures figures() const = 0;
  /// Takes effect with the next picture.
  virtual void setPlacement(const RoomPlacement& room) = 0;
  /// Sets the sRGB colours above and below the horizon.
  virtual void setBackground(const Colour& above, const Colour& below) = 0;
  /// Sets the devices that receive the controllers' states. Called before start().
  virtual void setHands(HandInputsPtr hands) = 0;
  /// Sets the panel and texts in the scene, and the receiver of pointing at the panel. Called before start().
  virtual void setTools(HeadsetToolsPtr tools) = 0;
  /// Sets a function that is called on the thread of the headset when the status has changed; it must return at once.
  /// Called before start().
  virtual void onChanged(std::function<void()> callback) = 0;
};

}  // namespace glissade
