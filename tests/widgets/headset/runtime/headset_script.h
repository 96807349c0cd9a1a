// Control of the runtime for tests by the program that has loaded it. All functions may be called on any thread.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/geometry/pose.h"
#include "widgets/openxr/eye_sight.h"

namespace glissade::test {

/// A picture that was shown to an eye: rows from the top, 4 bytes a pixel.
struct EyePicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// The sides of an eye's picture, and the place of the eye in the head H, as in a headset whose lenses are turned
/// outwards.
EyeSides scriptedSides(std::size_t eye);
Pose scriptedEye(std::size_t eye);

/// The kind of the scripted controllers.
inline constexpr const char* kScriptedProfile = "/interaction_profiles/oculus/touch_controller";

/// The state of a controller from some moment on.
struct ControllerMoment {
  double after = 0.0;  ///< seconds since the moment before, in which the controller moves steadily to this pose
  Pose X_RG;           ///< grip and aim, in the room
  double squeeze = 0.0;
  double trigger = 0.0;
  std::string pressed{};  ///< the component that is pressed, "/input/menu/click"; empty: none
  Eigen::Vector2d stick = Eigen::Vector2d::Zero();
  bool isTracked = true;
  bool isThere = true;
};

/// Restores the state at the start of the program: nothing is lost, the headset is connected and worn, controllers are
/// not connected.
void resetHeadset();
/// False: the runtime answers nothing, like a runtime whose service does not run.
void setRuntimeThere(bool there);
void setHeadsetThere(bool there);
/// If the headset is taken off, the session ends until it is put on.
void setWorn(bool worn);
/// Sets width and height of the pictures of the next session, in pixels. The size of real headsets shows whether texts
/// are legible.
void setEyePixels(int pixels);
/// X_RH: pose of the head in the room.
void setHead(const Pose& X_RH);
/// Puts a controller into this state at once, and forgets its script; hand 0 is the left one.
void setController(std::size_t hand, const ControllerMoment& moment);
/// Appends moments to the script of a controller, which follow each other.
void playController(std::size_t hand, const std::vector<ControllerMoment>& moments);
/// Whether the controller has finished its script, and the program has seen it.
bool hasPlayed(std::size_t hand);
/// Amplitudes of the pulses that the hand has felt since the last call.
std::vector<double> takePulses(std::size_t hand);
/// Number of times that the program has read the controllers.
int readControllers();
/// The next wait for a picture takes this time.
void stallOnce(std::chrono::milliseconds duration);
/// Refuses so many of the next calls of pictures and controllers, about one of three.
void refuse(int calls);
/// Number of calls that are still to be refused.
int callsToRefuse();
/// Sets the time between the times for which pictures are wanted, independently of the program's speed. By default it
/// is 1/90 s. The clock is the runtime's own, so that nothing depends on the speed of the machine.
void setPictureInterval(double seconds);
/// The following lose the present session, or the present instance: each of its calls fails.
void loseSession();
void loseRuntime();
/// The person leaves the program by a menu of the headset.
void leaveProgram();

/// Number of pictures of both eyes that were shown.
int shownPictures();
/// The next two pictures; empty if none is shown within this time.
std::vector<EyePicture> nextPictures(std::chrono::milliseconds longest);
/// Number of sessions that were made.
int madeSessions();
/// Number of instances, sessions, spaces, action sets and swapchains that are not destroyed.
int heldHandles();
/// Errors in calls by the program.
std::vector<std::string> complaints();

}  // namespace glissade::test
