#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace glissade {

/// A stand-in for spacenavd on a socket of its own: answers the handshake of protocol 1 and sends what
/// the test wants.
class FakeSpacenavDaemon {
 public:
  /// `accepts` false: it listens, and never takes a connection.
  explicit FakeSpacenavDaemon(std::string socketPath, bool accepts = true);
  ~FakeSpacenavDaemon();
  FakeSpacenavDaemon(const FakeSpacenavDaemon&) = delete;
  FakeSpacenavDaemon& operator=(const FakeSpacenavDaemon&) = delete;

  bool hasClient() const { return client_ >= 0; }
  void sendMotion(int x, int y, int z, int rx = 0, int ry = 0, int rz = 0);
  void sendBytes(const std::vector<unsigned char>& bytes);

 private:
  void serve(bool accepts);

  std::string path_;
  int listener_ = -1;
  std::atomic<int> client_{-1};
  std::atomic<bool> quit_{false};
  std::thread thread_;
};

}  // namespace glissade
