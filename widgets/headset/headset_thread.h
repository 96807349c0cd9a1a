#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "widgets/headset/headset.h"
#include "widgets/headset/headset_connection.h"
#include "widgets/headset/headset_scene.h"

namespace glissade {

/// What the thread of the headset does, and what others ask it for. Shared by both, so that a thread that a runtime
/// does not give back harms nobody. The OpenGL context and the scene's objects in it stay across losses.
class HeadsetThread : public std::enable_shared_from_this<HeadsetThread> {
 public:
  explicit HeadsetThread(SharedGraph graph) : graph_(std::move(graph)) {}

  // On any thread; they return at once.
  void setWanted(bool wanted);
  HeadsetStatus status() const;
  HeadsetFigures figures() const;
  void setPlacement(const RoomPlacement& room);
  void setBackground(const Colour& above, const Colour& below);
  void setHands(HandInputsPtr hands);
  void setTools(HeadsetToolsPtr tools);
  void setListener(std::function<void()> listener);
  /// Whether no thread is left after so long.
  bool waitForEnd(std::chrono::milliseconds longest);
  /// Gives the graph back. After the end of the thread.
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
  void follow(SessionNews news);
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
  bool alive_ = false;  ///< there is a thread
  HeadsetStatus status_;
  HeadsetFigures figures_;
  std::optional<RoomPlacement> placed_;   ///< where the thread has not placed the person yet
  std::optional<Background> background_;  ///< that the thread has not taken yet
  HandInputsPtr hands_ = std::make_shared<HandInputs>();
  HeadsetToolsPtr tools_ = std::make_shared<HeadsetTools>();
  std::function<void()> listener_;

  // Of the thread alone.
  HeadsetMachine machine_;
  bool left_ = false;  ///< the person has ended what was wanted
  RoomWalk walk_;
  int sinceCount_ = 0;  ///< pictures
  std::unique_ptr<HeadsetScene> scene_;
  std::unique_ptr<HeadsetConnection> connection_;
};

}  // namespace glissade
