#pragma once

#include <chrono>
#include <string>

namespace glissade {

enum class HeadsetState {
  Off,
  Searching,  ///< there is no connection; it is tried again
  Idle,       ///< connected; nobody wears the headset, or another program has it
  Running,    ///< pictures are shown
  Lost,       ///< the connection has ended and is being taken down; then it is searched for
  Left        ///< the person has left the program in the headset: it waits until it is asked for again
};

/// Why there is no connection.
enum class HeadsetTrouble {
  None,
  NoDisplay,    ///< no X display, or no OpenGL on it
  NoRuntime,    ///< no OpenXR runtime is installed, or it does not answer
  NoOpenGl,     ///< the runtime takes no pictures by OpenGL
  NoHeadset,    ///< the runtime runs, and no headset is connected
  SessionLost,  ///< the runtime has ended the session
  RuntimeLost,  ///< the runtime has ended
  Failed        ///< anything else; the detail names it
};

/// What is known about the headset.
struct HeadsetStatus {
  HeadsetState state = HeadsetState::Off;
  HeadsetTrouble trouble = HeadsetTrouble::None;
  std::string detail;  ///< of a failure: which call of OpenXR returned what
  std::string name;    ///< of the headset, as its runtime calls it; empty where none is connected

  friend bool operator==(const HeadsetStatus&, const HeadsetStatus&) = default;
};

/// The states of the connection with a headset, and when it is tried again. It knows nothing of OpenXR; whoever owns it
/// gives the time.
class HeadsetMachine {
 public:
  using Time = std::chrono::steady_clock::time_point;
  /// The first wait after a search without success; each further one is twice as long, up to the longest.
  static constexpr std::chrono::milliseconds kFirstWait{500};
  static constexpr std::chrono::milliseconds kLongestWait{8000};

  const HeadsetStatus& status() const { return status_; }
  /// While it is searching: when to try next.
  Time nextSearch() const { return nextSearch_; }

  /// The headset is asked for: it is searched at once.
  void ask(Time now);
  void switchOff() { status_ = {}; }
  void failSearch(HeadsetTrouble trouble, const std::string& detail, Time now);
  void connect(const std::string& name);
  /// Pictures are asked for, or no more.
  void begin();
  void end();
  void lose(HeadsetTrouble trouble, const std::string& detail);
  /// What was lost is taken down. One that had shown pictures is searched at once.
  void release(Time now);
  /// The person has left.
  void leave();

 private:
  void waitLonger(Time now);

  HeadsetStatus status_;
  std::chrono::milliseconds wait_ = kFirstWait;
  bool hasRun_ = false;  ///< this connection has shown pictures
  Time nextSearch_{};
};

}  // namespace glissade
