// What the runtime for tests is told to do, by the program that it is loaded into. All functions may be called on any
// thread.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/geometry/pose.h"
#include "widgets/headset/eye_sight.h"

namespace glissade::test {

/// What was shown to an eye: rows from the top, 4 bytes a pixel.
struct EyePicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// The sides of the picture of an eye, and its place in the head H: those of a headset whose lenses are turned
/// outwards.
EyeSides scriptedSides(std::size_t eye);
Pose scriptedEye(std::size_t eye);

/// The kind of the scripted controllers.
inline constexpr const char* kScriptedProfile = "/interaction_profiles/oculus/touch_controller";

/// A controller from some moment on.
struct ControllerMoment {
  double after = 0.0;  ///< seconds from the moment before, in which it moves steadily to this pose
  Pose X_RG;           ///< grip and aim, in the room
  double squeeze = 0.0;
  double trigger = 0.0;
  std::string pressed{};  ///< the component that is pressed, "/input/menu/click"; empty: none
  Eigen::Vector2d stick = Eigen::Vector2d::Zero();
  bool isTracked = true;
  bool isThere = true;
};

/// As after the start of the program: nothing is lost, the headset is there and is worn, controllers are not.
void resetHeadset();
/// False: the runtime answers nothing, as one whose service does not run.
void setRuntimeThere(bool there);
void setHeadsetThere(bool there);
/// Off: the session ends until it is put on.
void setWorn(bool worn);
/// Width and height of the pictures of the next session, in pixels: those of a real headset show whether texts are
/// legible.
void setEyePixels(int pixels);
/// X_RH: where the head is in the room.
void setHead(const Pose& X_RH);
/// 0 the left one. It is there at once, and does nothing else that it was told before.
void setController(std::size_t hand, const ControllerMoment& moment);
/// It does this next, one moment after the other.
void playController(std::size_t hand, const std::vector<ControllerMoment>& moments);
/// It has done all that it was told, and the program has seen it.
bool hasPlayed(std::size_t hand);
/// What the hand has felt since it was asked last: amplitudes.
std::vector<double> takePulses(std::size_t hand);
/// So often the program has asked for the controllers, ever.
int readControllers();
/// The next wait for a picture takes so long.
void stallOnce(std::chrono::milliseconds duration);
/// The times for which pictures are wanted are so many seconds apart from now on, whatever the program takes for them.
/// 1/90 at first: the runtime's own clock, so that nothing depends on how fast the machine draws.
void setPictureInterval(double seconds);
/// Whatever session there is, or whatever instance, is lost: each of its calls fails.
void loseSession();
void loseRuntime();
/// The person leaves the program by a menu of the headset.
void leaveProgram();

/// Pictures of both eyes that were shown, ever.
int shownPictures();
/// The next two that are shown; empty where none is within so long.
std::vector<EyePicture> nextPictures(std::chrono::milliseconds longest);
/// Sessions that were made, ever.
int madeSessions();
/// Instances, sessions, spaces, action sets and swapchains that are not destroyed.
int heldHandles();
/// What was wrong with calls of the program.
std::vector<std::string> complaints();

}  // namespace glissade::test
