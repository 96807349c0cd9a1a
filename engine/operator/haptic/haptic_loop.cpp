#include "engine/operator/haptic/haptic_loop.h"

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>

#include <algorithm>
#include <chrono>

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::microseconds kPeriod{1000};

/// Sets the most exact timers of the system, and the lowest real-time priority where that is allowed.
void becomePunctual() {
  prctl(PR_SET_TIMERSLACK, 1UL);
  sched_param priority{};
  priority.sched_priority = sched_get_priority_min(SCHED_FIFO);
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
}

}  // namespace

double reachOf(const Guidance& guidance, double objectRadius) {
  constexpr double kRoomToMove = 0.2;
  return std::max(guidance.distance, kRoomToMove * objectRadius);
}

HapticLoop::HapticLoop(CollisionWorldPtr world, std::unique_ptr<HapticDevice> device, const HapticOrders& orders)
    : world_(std::move(world)),
      servo_(std::move(device), world_->objectRadius()),
      current_(orders),
      reach_(reachOf(orders.guidance, world_->objectRadius())),
      tracker_(*world_) {
  servo_.place(orders.q);
  now_.cycle.q = orders.q;
  now_.placements = orders.placements;
  report_ = now_;
  thread_ = std::thread([this] { run(); });
}

HapticLoop::~HapticLoop() {
  quit_ = true;
  thread_.join();
}

HapticReport HapticLoop::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

void HapticLoop::carryOutOrders() {
  const auto orders = orders_.tryTake();
  if (!orders) return;
  if (orders->placements != current_.placements) servo_.place(orders->q);
  if (orders->restarts != current_.restarts) servo_.restart();
  current_ = *orders;
  now_.placements = current_.placements;
  reach_ = reachOf(current_.guidance, world_->objectRadius());
}

void HapticLoop::cycle() {
  tracker_.rethrowFailure();
  carryOutOrders();
  if (const auto answer = tracker_.answer()) servo_.learn(*answer);
  now_.cycle = servo_.cycle(HapticServo::kPeriod, current_.guidance, current_.bounds);
  if (servo_.object().needsSurroundings()) tracker_.ask(servo_.object().pose(), reach_);
  now_.connected = servo_.connected();
  now_.queries = tracker_.queries();
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock) report_ = now_;
}

void HapticLoop::run() {
  try {
    runCycles();
  } catch (...) {
    servo_.stop();
    const std::lock_guard lock(mutex_);
    report_ = now_;
    report_.connected = false;
    report_.failure = std::current_exception();
  }
}

void HapticLoop::runCycles() {
  becomePunctual();
  auto deadline = Clock::now();
  while (!quit_) {
    deadline += kPeriod;
    std::this_thread::sleep_until(deadline);
    const auto delay = Clock::now() - deadline;
    const auto missed = delay / kPeriod;
    const double seconds = std::chrono::duration<double>(delay).count();
    deadline += missed * kPeriod;
    now_.cycles += 1U + static_cast<std::uint64_t>(missed);
    now_.late += static_cast<std::uint64_t>(missed) + (seconds > kLate ? 1U : 0U);
    now_.longestDelay = std::max(now_.longestDelay, seconds);
    cycle();
  }
}

}  // namespace glissade
