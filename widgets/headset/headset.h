#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "engine/environment/rigid_body.h"
#include "engine/operator/hand_inputs.h"
#include "widgets/headset/headset_machine.h"
#include "widgets/headset/headset_tools.h"
#include "widgets/headset/room_placement.h"

namespace glissade {

/// What the pictures of the headset cost; some pictures old.
struct HeadsetFigures {
  int detailStep = 0;          ///< how simple the scene is; 0: in full detail (PictureRate)
  int drawCalls = 0;           ///< for each eye
  std::int64_t triangles = 0;  ///< for each eye
  double cullSeconds = 0.0;    ///< for an eye: of the processor's choice of what is drawn
  double drawSeconds = 0.0;    ///< for an eye: of OpenGL's calls
};

/// Shows a scene in a headset, from a thread of its own. All functions are called on one thread, the window's, and
/// return at once, whatever the headset does.
class Headset {
 public:
  /// Waits for the end of the thread, a second at most: a runtime that does not answer is left alone.
  virtual ~Headset() = default;

  /// Searches a headset and shows the scene in it, until stop() is called or the person leaves.
  virtual void start() = 0;
  virtual void stop() = 0;
  virtual HeadsetStatus status() const = 0;
  virtual HeadsetFigures figures() const = 0;
  /// From the next picture on.
  virtual void setPlacement(const RoomPlacement& room) = 0;
  /// sRGB; above and below the horizon.
  virtual void setBackground(const Colour& above, const Colour& below) = 0;
  /// Whose hands have the controllers. Set before start().
  virtual void setHands(HandInputsPtr hands) = 0;
  /// What the panel in the scene shows, and who is told what hands do at it. Set before start().
  virtual void setTools(HeadsetToolsPtr tools) = 0;
  /// Called when the status is another one, on the thread of the headset; must return at once. Set before start().
  virtual void onChanged(std::function<void()> callback) = 0;
};

}  // namespace glissade
