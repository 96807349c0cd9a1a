#include "tests/engine/operator/fake_spacenav_daemon.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>

namespace glissade {
namespace {

constexpr std::int32_t kHandshake = 0x7faa5501;

}  // namespace

FakeSpacenavDaemon::FakeSpacenavDaemon(std::string socketPath, bool accepts) : path_(std::move(socketPath)) {
  ::unlink(path_.c_str());
  listener_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path_.c_str(), sizeof address.sun_path - 1);
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 || ::listen(listener_, 1) != 0) {
    throw std::runtime_error("the fake daemon cannot listen on " + path_);
  }
  thread_ = std::thread([this, accepts] { serve(accepts); });
}

FakeSpacenavDaemon::~FakeSpacenavDaemon() {
  quit_ = true;
  thread_.join();
  if (client_ >= 0) ::close(client_);
  ::close(listener_);
  ::unlink(path_.c_str());
}

void FakeSpacenavDaemon::serve(bool accepts) {
  while (!quit_) {
    pollfd descriptor{client_ >= 0 ? client_.load() : listener_, POLLIN, 0};
    if (poll(&descriptor, 1, 10) <= 0) continue;
    if (client_ < 0) {
      if (!accepts) continue;
      const int client = ::accept(listener_, nullptr, nullptr);
      std::int32_t hello = 0;
      if (::recv(client, &hello, sizeof hello, 0) == sizeof hello && hello == kHandshake) {
        ::send(client, &hello, sizeof hello, MSG_NOSIGNAL);
      }
      client_ = client;
      continue;
    }
    // Requests (name, event mask) get no answer; only the end matters.
    std::array<char, 256> ignored{};
    if (::recv(client_, ignored.data(), ignored.size(), MSG_DONTWAIT) == 0) {
      ::close(client_);
      client_ = -1;
    }
  }
}

void FakeSpacenavDaemon::sendMotion(int x, int y, int z, int rx, int ry, int rz) {
  const std::array<std::int32_t, 8> event{0, x, y, z, rx, ry, rz, 8};
  std::vector<unsigned char> bytes(sizeof event);
  std::memcpy(bytes.data(), event.data(), sizeof event);
  sendBytes(bytes);
}

void FakeSpacenavDaemon::sendBytes(const std::vector<unsigned char>& bytes) {
  ::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

}  // namespace glissade
