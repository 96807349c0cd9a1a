#include "engine/operator/spacenav_reader.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spnav.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include "engine/base/guarded.h"
#include "engine/operator/reader_problem.h"
#include "engine/operator/spacenav_protocol.h"

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Deflection that the daemon reports at the puck's end stop.
constexpr double kFullDeflection = 350.0;
constexpr milliseconds kLongestBackOff{4000};
/// Period of checks for the end while waiting for events.
constexpr milliseconds kPollTimeout{50};
/// Pause after each reading, which limits the number of wake-ups in a flood of events.
constexpr milliseconds kPause{2};
/// Most packets in one reading, so that a flood cannot keep the thread in it.
constexpr int kMostPackets = 1024;
/// Longest wait for the rest of a packet, after which the stream counts as invalid.
constexpr milliseconds kPacketPatience{200};

constexpr const char* kDefaultSocket = "/var/run/spnav.sock";
constexpr const char* kConfiguration = "/etc/spnavrc";
/// Name for daemons that give none.
constexpr const char* kUnnamed = "6D mouse";

/// libspnav's own helper maps the daemon's left-handed z: +x, +y, -z, and the same for rotations.
RawAxes toAxes(const spnav_event_motion& motion) {
  const auto axis = [](int value) { return std::clamp(value / kFullDeflection, -1.0, 1.0); };
  return {axis(motion.x), axis(motion.y), -axis(motion.z), axis(motion.rx), axis(motion.ry), -axis(motion.rz)};
}

bool accepts(const char* path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (std::strlen(path) >= sizeof address.sun_path) return false;
  std::strcpy(address.sun_path, path);
  const int trial = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (trial < 0) return false;
  const bool accepted = ::connect(trial, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  ::close(trial);
  return accepted;
}

/// True if a daemon listens. spnav_open() leaks when it fails, and waits for ever where nobody accepts.
bool daemonListens() {
  if (const char* configured = std::getenv("SPNAV_SOCKET")) return accepts(configured);
  return accepts(kDefaultSocket) || ::access(kConfiguration, R_OK) == 0;
}

/// True if the connection is to the socket in SPNAV_SOCKET. libspnav tries other sockets when that one fails.
bool reachedTheRightSocket() {
  const char* configured = std::getenv("SPNAV_SOCKET");
  if (configured == nullptr) return true;
  sockaddr_un peer{};
  socklen_t size = sizeof peer;
  if (getpeername(spnav_fd(), reinterpret_cast<sockaddr*>(&peer), &size) != 0) return false;
  return std::string(peer.sun_path) == configured;
}

/// Blocks signals, because libspnav loops on an interrupted call after the daemon's death.
void blockSignals() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

/// State shared by the reader and its thread. It outlives both, because a daemon that sends half a handshake holds the
/// thread inside libspnav for ever.
struct SpacenavReader::Connection {
  Connection(HandInputsPtr inputs, milliseconds back) : hand(std::move(inputs)), firstBackOff(back) {}

  HandInputsPtr hand;
  const milliseconds firstBackOff;
  std::atomic<bool> quit{false};
  std::atomic<bool> ended{false};
  std::atomic<std::uint64_t> wakeUps{0};
  ReaderProblem problem;

  void run() {
    blockSignals();
    milliseconds backOff = firstBackOff;
    while (!quit) {
      if (daemonListens() && spnav_open() == 0) {
        problem.set(std::nullopt);
        bool talkedSense = false;
        auto why = guarded(GLISSADE_TEXT("reading the 6D mouse"),
                           [&] { talkedSense = reachedTheRightSocket() && readUntilItDies(); });
        if (why) problem.set(std::move(why));
        // A listener that fails is notified again at the next change.
        (void)guarded(GLISSADE_TEXT("disconnecting the 6D mouse"), [this] { mailbox().disconnect(); });
        if (talkedSense) backOff = firstBackOff;
        spnav_close();
      }
      wait(backOff);
      backOff = std::min(2 * backOff, kLongestBackOff);
    }
    ended = true;
  }

 private:
  InputMailbox& mailbox() { return hand->mouse6d.mailbox; }

  /// Reads until the daemon dies. True if it has sent valid data, so that it is searched for again soon.
  bool readUntilItDies() {
    talkedSense_ = false;
    pieceSince_ = {};
    fcntl(spnav_fd(), F_SETFD, FD_CLOEXEC);
    if (spnav_protocol() >= 1) {
      askName();
    } else {
      mailbox().connect(kUnnamed);
    }
    while (!quit) {
      pollfd descriptor{spnav_fd(), POLLIN, 0};
      const int ready = poll(&descriptor, 1, static_cast<int>(kPollTimeout.count()));
      ++wakeUps;
      if (ready <= 0) continue;
      if (!drain()) break;
      std::this_thread::sleep_for(kPause);
    }
    return talkedSense_;
  }

  /// Reads what has arrived. Motion events are absolute deflections, so that only the last one counts. False: the
  /// daemon is dead (the socket is then always readable), or sends invalid packets.
  bool drain() {
    spnav_event_motion last{};
    bool moved = false;
    for (int i = 0; i < kMostPackets && !quit; ++i) {
      spacenav::Packet packet{};
      const ssize_t size = recv(spnav_fd(), packet.data(), sizeof packet, MSG_PEEK | MSG_DONTWAIT);
      if (size < 0 && errno != EAGAIN && errno != EINTR) return false;
      if (size < 0) break;
      if (size < static_cast<ssize_t>(sizeof packet)) {
        if (size == 0 || !restComes(size)) return false;
        break;
      }
      pieceSince_ = {};
      const spacenav::PacketKind kind = spacenav::kindOf(packet);
      if (kind == spacenav::PacketKind::Garbage) return false;
      take(packet, kind, last, moved);
      talkedSense_ = true;
    }
    if (moved) publish(last);
    return true;
  }

  void publish(const spnav_event_motion& motion) {
    if (!mailbox().reading().connected) mailbox().connect(kUnnamed);
    mailbox().setAxes(toAxes(motion));
  }

  void take(const spacenav::Packet& packet, spacenav::PacketKind kind, spnav_event_motion& last, bool& moved) {
    spnav_event event{};
    if (kind == spacenav::PacketKind::Event) {
      spnav_poll_event(&event);
      if (event.type == SPNAV_EVENT_MOTION) {
        last = event.motion;
        moved = true;
      } else if (event.type == SPNAV_EVENT_BUTTON && event.button.press != 0 && event.button.bnum >= 0) {
        mailbox().press(static_cast<std::size_t>(event.button.bnum));
      }
      return;
    }
    spacenav::Packet taken{};
    recv(spnav_fd(), taken.data(), sizeof taken, MSG_DONTWAIT);
    if (kind == spacenav::PacketKind::DeviceList) askName();
    if (kind == spacenav::PacketKind::Name) learnName(packet);
  }

  void askName() {
    const spacenav::Packet request = spacenav::nameRequest();
    send(spnav_fd(), request.data(), sizeof request, MSG_NOSIGNAL | MSG_DONTWAIT);
  }

  void learnName(const spacenav::Packet& packet) {
    const auto name = name_.add(packet);
    if (!name) return;
    if (name->empty()) {
      mailbox().disconnect();
    } else {
      mailbox().connect(*name);
    }
  }

  /// Waits a little for the rest of a partial packet.
  bool restComes(ssize_t size) {
    const auto now = Clock::now();
    if (pieceSince_ == Clock::time_point() || size != pieceSize_) pieceSince_ = now;
    pieceSize_ = size;
    std::this_thread::sleep_for(milliseconds(10));
    return now - pieceSince_ < kPacketPatience;
  }

  void wait(milliseconds duration) {
    const auto end = Clock::now() + duration;
    while (!quit && Clock::now() < end) {
      std::this_thread::sleep_for(std::min(kPollTimeout, duration));
      ++wakeUps;
    }
  }

  spacenav::NameAssembler name_;
  bool talkedSense_ = false;
  ssize_t pieceSize_ = 0;
  Clock::time_point pieceSince_;
};

SpacenavReader::SpacenavReader(HandInputsPtr hand, milliseconds firstBackOff)
    : connection_(std::make_shared<Connection>(std::move(hand), firstBackOff)) {
  std::thread([connection = connection_] { connection->run(); }).detach();
}

SpacenavReader::~SpacenavReader() {
  connection_->quit = true;
  // The thread ends within kPollTimeout unless libspnav holds it; then it is abandoned.
  for (int i = 0; i < 20 && !connection_->ended; ++i) std::this_thread::sleep_for(kPollTimeout / 2);
}

std::optional<Diagnostic> SpacenavReader::problem() const { return connection_->problem.get(); }

std::uint64_t SpacenavReader::wakeUps() const { return connection_->wakeUps; }

}  // namespace glissade
