#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace glissade {

/// Behaviour of a replacement for spacenavd.
struct DaemonHabits {
  bool accepts = true;      ///< false: it listens, but accepts no connection
  bool shakesHands = true;  ///< false: it sends no handshake
};

/// A replacement for spacenavd on its own socket. It answers the handshake of protocol 1 and requests for the mouse's
/// name, and sends the test's events. Its destructor ends it.
class FakeSpacenavDaemon {
 public:
  explicit FakeSpacenavDaemon(std::string socketPath, DaemonHabits habits = {});
  ~FakeSpacenavDaemon();
  FakeSpacenavDaemon(const FakeSpacenavDaemon&) = delete;
  FakeSpacenavDaemon& operator=(const FakeSpacenavDaemon&) = delete;

  bool hasClient() const { return client_ >= 0; }
  void sendMotion(int x, int y, int z, int rx = 0, int ry = 0, int rz = 0);
  void sendButton(int button, bool pressed);
  void sendBytes(const std::vector<unsigned char>& bytes);
  /// Connects a mouse (by its name) or disconnects it, and notifies the client.
  void plug(const std::optional<std::string>& mouse);

 private:
  using Packet = std::array<std::int32_t, 8>;

  void serve();
  void acceptClient();
  void answer();
  void sendName();
  void sendPacket(const Packet& packet);

  std::string path_;
  DaemonHabits habits_;
  int listener_ = -1;
  std::atomic<int> client_{-1};
  std::atomic<bool> quit_{false};
  std::mutex mutex_;
  std::optional<std::string> mouse_ = "SpaceNavigator";
  std::thread thread_;
};

}  // namespace glissade
