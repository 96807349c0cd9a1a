#include "engine/operator/spacenav_device.h"

#include <poll.h>
#include <spnav.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <string>

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Deflection that the daemon reports at the end of the puck's way.
constexpr double kFullDeflection = 350.0;
/// Share of the way that counts as rest.
constexpr double kDeadZone = 0.05;
/// The puck is taken for released when nothing came for so long (daemon silent, focus elsewhere).
constexpr milliseconds kSilence{500};
constexpr milliseconds kFirstBackOff{250};
constexpr milliseconds kLongestBackOff{4000};
/// How often a quit is looked for while waiting for events.
constexpr milliseconds kPatience{50};

double axis(int value) {
  const double share = std::clamp(value / kFullDeflection, -1.0, 1.0);
  return std::abs(share) < kDeadZone ? 0.0 : share;
}

/// libspnav's own helper maps the daemon's left-handed z: +x, +y, -z, and the same for rotations.
Deflection toDeflection(const spnav_event_motion& motion) {
  Deflection deflection;
  deflection.translation = {axis(motion.x), axis(motion.y), -axis(motion.z)};
  deflection.rotation = {axis(motion.rx), axis(motion.ry), -axis(motion.rz)};
  return deflection;
}

/// libspnav falls through to other sockets when the one in SPNAV_SOCKET fails: did we reach it?
bool reachedTheRightSocket() {
  const char* wanted = std::getenv("SPNAV_SOCKET");
  if (wanted == nullptr) return true;
  sockaddr_un peer{};
  socklen_t size = sizeof peer;
  if (getpeername(spnav_fd(), reinterpret_cast<sockaddr*>(&peer), &size) != 0) return false;
  return std::string(peer.sun_path) == wanted;
}

/// poll() says "readable" for ever once the daemon is dead, and spnav_poll_event() then returns 0.
bool daemonIsDead() {
  char byte = 0;
  return recv(spnav_fd(), &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
}

}  // namespace

/// Shared by the device and its reading thread; outlives whichever goes first, because a daemon that
/// accepts no connection may hold the thread inside libspnav for ever.
struct SpacenavDevice::Connection {
  std::atomic<bool> quit{false};
  std::atomic<bool> ended{false};
  std::atomic<bool> connected{false};
  mutable std::mutex mutex;
  Deflection deflection;
  Clock::time_point received;

  void run() {
    milliseconds backOff = kFirstBackOff;
    while (!quit) {
      if (spnav_open() == 0) {
        if (reachedTheRightSocket()) {
          backOff = kFirstBackOff;
          connected = true;
          readUntilItDies();
          connected = false;
        }
        spnav_close();
      }
      wait(backOff);
      backOff = std::min(2 * backOff, kLongestBackOff);
    }
    ended = true;
  }

  Deflection current() const {
    const std::lock_guard lock(mutex);
    return Clock::now() - received > kSilence ? Deflection() : deflection;
  }

 private:
  void readUntilItDies() {
    while (!quit) {
      pollfd descriptor{spnav_fd(), POLLIN, 0};
      if (poll(&descriptor, 1, static_cast<int>(kPatience.count())) <= 0) continue;
      if (daemonIsDead() || (descriptor.revents & (POLLERR | POLLNVAL)) != 0) return;
      drain();
    }
  }

  /// Motion events are absolute deflections: only the last one counts.
  void drain() {
    spnav_event event{};
    spnav_event_motion last{};
    bool moved = false;
    // A bound, so that a daemon that floods cannot hold us here.
    for (int i = 0; i < 1024 && !quit && spnav_poll_event(&event) != 0; ++i) {
      if (event.type != SPNAV_EVENT_MOTION) continue;
      last = event.motion;
      moved = true;
    }
    if (!moved) return;
    const std::lock_guard lock(mutex);
    deflection = toDeflection(last);
    received = Clock::now();
  }

  void wait(milliseconds duration) const {
    const auto end = Clock::now() + duration;
    while (!quit && Clock::now() < end) std::this_thread::sleep_for(std::min(kPatience, duration));
  }
};

SpacenavDevice::SpacenavDevice() : connection_(std::make_shared<Connection>()) {
  std::thread([connection = connection_] { connection->run(); }).detach();
}

SpacenavDevice::~SpacenavDevice() {
  connection_->quit = true;
  // The thread ends within kPatience unless libspnav holds it; then it is left behind.
  for (int i = 0; i < 20 && !connection_->ended; ++i) std::this_thread::sleep_for(kPatience / 2);
}

Pose SpacenavDevice::advance(double dt, const OperatorView& view, const Box3& bounds) {
  return integrate(view.q_device, toTwist(connection_->current(), view.frame), bounds, dt);
}

bool SpacenavDevice::connected() const { return connection_->connected; }

}  // namespace glissade
