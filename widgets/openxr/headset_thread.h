#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "widgets/openxr/headset.h"
#include "widgets/openxr/headset_connection.h"
#include "widgets/openxr/headset_scene.h"

namespace glissade {

/// The work of the headset's thread, and the requests to it. It is shared, so that a thread that is stuck in a runtime
/// can be abandoned safely. The OpenGL context and the scene's objects in it survive losses of the connection.
class HeadsetThread : public std::enable_shared_from_this<HeadsetThread> {
 public:
  explicit HeadsetThread(SharedGraph graph) : graph_(std::move(graph)) {}

  // The following may be called on any thread, and return at once.
  void setWanted(bool wanted);
  HeadsetStatus status() const;
  HeadsetFigures figures() const;
  void setPlacement(const RoomPlacement& room);
  void setBackground(const Colour& above, const Colour& below);
  void setHands(HandInputsPtr hands);
  void setTools(HeadsetToolsPtr tools);
  void setListener(std::function<void()> listener);
  /// Waits for the end of the thread; false if it still runs after this time.
  bool waitForEnd(std::chrono::milliseconds longest);
  /// Gives the graph back. Precondition: the thread has ended.
  void forgetScene();

 private:
  struct Background {
    Colour above{};
    Colour below{};
  };

  void run();
  void serve();
  void step();
  void search();
  void follow(SessionChange change);
  void leave();
  void show();
  void count();
  void fail(HeadsetTrouble trouble, const std::string& detail);
  void disconnect();
  void publish();
  bool isWanted() const;
  void waitUntil(HeadsetMachine::Time time);

  const SharedGraph graph_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool wanted_ = false;
  bool alive_ = false;  ///< a thread exists
  HeadsetStatus status_;
  std::chrono::steady_clock::time_point lastPicture_{};  ///< begin of the last picture
  HeadsetFigures figures_;
  std::optional<RoomPlacement> placed_;   ///< placement that the thread has not taken yet
  std::optional<Background> background_;  ///< colours that the thread has not taken yet
  HandInputsPtr hands_ = std::make_shared<HandInputs>();
  HeadsetToolsPtr tools_ = std::make_shared<HeadsetTools>();
  std::function<void()> listener_;

  // The following are used by the thread only.
  HeadsetMachine machine_;
  bool left_ = false;  ///< the person has left the program
  RoomWalk walk_;
  int sinceCount_ = 0;  ///< pictures since the last count
  std::unique_ptr<HeadsetScene> scene_;
  std::unique_ptr<HeadsetConnection> connection_;
};

}  // namespace glissade
