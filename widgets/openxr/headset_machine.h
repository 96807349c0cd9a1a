#pragma once

#include <chrono>
#include <string>

namespace glissade {

enum class HeadsetState {
  Off,
  Searching,  ///< there is no connection; it is tried again
  Idle,       ///< connected; nobody wears the headset, or another program uses it
  Running,    ///< pictures are shown
  Lost,       ///< the connection has ended and is being taken down; a search follows
  Left        ///< the person has left the program in the headset, which waits until it is started again
};

/// The reason why there is no connection.
enum class HeadsetTrouble {
  None,
  NoDisplay,    ///< no X display, or no OpenGL on it
  NoRuntime,    ///< no OpenXR runtime is installed, or it does not answer
  NoOpenGl,     ///< the runtime takes no pictures by OpenGL
  NoHeadset,    ///< the runtime runs, and no headset is connected
  SessionLost,  ///< the runtime has ended the session
  RuntimeLost,  ///< the runtime has ended
  Failed        ///< another failure, which the detail names
};

/// State of the connection, trouble, and the headset's name.
struct HeadsetStatus {
  HeadsetState state = HeadsetState::Off;
  HeadsetTrouble trouble = HeadsetTrouble::None;
  std::string detail;  ///< the call of OpenXR that failed, and its result
  std::string name;    ///< name of the headset by its runtime; empty if none is connected
  /// The first call that the runtime refused although nothing was lost, and its result; empty: none.
  std::string refused{};
  bool stalls = false;  ///< pictures are shown, and the runtime has not asked for one for seconds

  friend bool operator==(const HeadsetStatus&, const HeadsetStatus&) = default;
};

/// The states of the connection with a headset, and the times of its searches. It knows nothing of OpenXR and reads no
/// clock.
class HeadsetMachine {
 public:
  using Time = std::chrono::steady_clock::time_point;
  /// The wait after the first search without success; each further wait is twice as long, up to the longest.
  static constexpr std::chrono::milliseconds kFirstWait{500};
  static constexpr std::chrono::milliseconds kLongestWait{8000};

  const HeadsetStatus& status() const { return status_; }
  /// Time of the next search, while searching.
  Time nextSearch() const { return nextSearch_; }

  /// The headset is requested: a search begins at once.
  void ask(Time now);
  void switchOff() { status_ = {}; }
  void failSearch(HeadsetTrouble trouble, const std::string& detail, Time now);
  void connect(const std::string& name);
  /// The runtime asks for pictures (begin) or stops asking (end).
  void begin();
  void end();
  /// The runtime refuses calls although nothing is lost; empty: none.
  void setRefused(const std::string& call) { status_.refused = call; }
  void lose(HeadsetTrouble trouble, const std::string& detail);
  /// The lost connection was taken down. If it had shown pictures, a search begins at once.
  void release(Time now);
  /// The person has left the program.
  void leave();

 private:
  void waitLonger(Time now);

  HeadsetStatus status_;
  std::chrono::milliseconds wait_ = kFirstWait;
  bool hasRun_ = false;  ///< this connection has shown pictures
  Time nextSearch_{};
};

}  // namespace glissade
