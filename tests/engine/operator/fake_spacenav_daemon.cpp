#include "tests/engine/operator/fake_spacenav_daemon.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace glissade {
namespace {

constexpr std::int32_t kHandshake = 0x7faa5501;
constexpr std::int32_t kNameRequest = 0x7faa2000;
constexpr std::size_t kChunk = 24;
constexpr std::int32_t kContinued = 0x10000;

}  // namespace

FakeSpacenavDaemon::FakeSpacenavDaemon(std::string socketPath, DaemonHabits habits)
    : path_(std::move(socketPath)), habits_(habits) {
  ::unlink(path_.c_str());
  listener_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path_.c_str(), sizeof address.sun_path - 1);
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 || ::listen(listener_, 8) != 0) {
    throw std::runtime_error("the fake daemon cannot listen on " + path_);
  }
  thread_ = std::thread([this] { serve(); });
}

FakeSpacenavDaemon::~FakeSpacenavDaemon() {
  quit_ = true;
  thread_.join();
  if (client_ >= 0) ::close(client_);
  ::close(listener_);
  ::unlink(path_.c_str());
}

void FakeSpacenavDaemon::serve() {
  while (!quit_) {
    pollfd descriptor{client_ >= 0 ? client_.load() : listener_, POLLIN, 0};
    if (poll(&descriptor, 1, 5) <= 0) continue;
    if (client_ >= 0) {
      answer();
    } else if (habits_.accepts) {
      acceptClient();
    } else {
      ::usleep(5000);
    }
  }
}

/// Accepts a client. A client that only tests the connection disconnects at once.
void FakeSpacenavDaemon::acceptClient() {
  const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
  std::int32_t hello = 0;
  if (::recv(client, &hello, sizeof hello, 0) != sizeof hello) {
    ::close(client);
    return;
  }
  if (habits_.shakesHands && hello == kHandshake) ::send(client, &hello, sizeof hello, MSG_NOSIGNAL);
  client_ = client;
}

void FakeSpacenavDaemon::answer() {
  Packet packet{};
  const ssize_t size = ::recv(client_, packet.data(), sizeof packet, MSG_DONTWAIT);
  if (size == 0) {
    ::close(client_);
    client_ = -1;
  } else if (packet[0] == kNameRequest) {
    sendName();
  }
}

void FakeSpacenavDaemon::sendName() {
  const std::lock_guard lock(mutex_);
  if (!mouse_) {
    sendPacket({kNameRequest, 0, 0, 0, 0, 0, 0, -1});
    return;
  }
  for (std::size_t done = 0; done < mouse_->size(); done += kChunk) {
    Packet packet{kNameRequest};
    const std::size_t left = mouse_->size() - done;
    std::memcpy(packet.data() + 1, mouse_->data() + done, std::min(left, kChunk));
    packet[7] = static_cast<std::int32_t>(left) | (done > 0 ? kContinued : 0);
    sendPacket(packet);
  }
}

void FakeSpacenavDaemon::plug(const std::optional<std::string>& mouse) {
  {
    const std::lock_guard lock(mutex_);
    mouse_ = mouse;
  }
  sendPacket({3, mouse ? 0 : 1, 0, 0, 0, 0, 0, 0});
}

void FakeSpacenavDaemon::sendMotion(int x, int y, int z, int rx, int ry, int rz) {
  sendPacket({0, x, y, z, rx, ry, rz, 8});
}

void FakeSpacenavDaemon::sendButton(int button, bool pressed) { sendPacket({pressed ? 1 : 2, button}); }

void FakeSpacenavDaemon::sendPacket(const Packet& packet) {
  std::vector<unsigned char> bytes(sizeof packet);
  std::memcpy(bytes.data(), packet.data(), sizeof packet);
  sendBytes(bytes);
}

void FakeSpacenavDaemon::sendBytes(const std::vector<unsigned char>& bytes) {
  ::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

}  // namespace glissade
