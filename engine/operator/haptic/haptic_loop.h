#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "engine/operator/haptic/contact_tracker.h"
#include "engine/operator/haptic/haptic_servo.h"

namespace glissade {

/// Requests to the loop, the latest counts. Counters grow with every wish, so that none is carried out twice.
struct HapticOrders {
  Guidance guidance;
  Box3 bounds;
  Pose q;                        ///< where the object is put
  std::uint64_t placements = 0;  ///< counts the wishes to put it
  std::uint64_t restarts = 0;    ///< counts the new runs
};

/// What the loop has to tell.
struct HapticReport {
  HapticCycle cycle;
  std::uint64_t placements = 0;  ///< carried out
  bool connected = true;
  std::uint64_t cycles = 0;   ///< since the beginning, missed ones included
  std::uint64_t late = 0;     ///< of them began more than HapticLoop::kLate after their time
  double longestDelay = 0.0;  ///< s
  std::uint64_t queries = 0;  ///< of the contact tracker
  /// The exception that ended the loop; null while it runs. The device renders nothing any more.
  std::exception_ptr failure;
};

/// The haptic loop: a servo cycle each millisecond on a thread of its own, by absolute deadlines; whole
/// periods that were missed count as late cycles and are not made up for. Collision work is the tracker's; where a
/// query takes longer than a cycle, the object goes on in the ball and along the planes it knows. Neither side ever
/// waits for the other: locks of the loop are tried, not waited for.
///
/// Asks for real-time priority and goes on without where the system refuses it. An exception of the device or of a
/// query ends the loop: it is reported to the thread that asks for the report.
class HapticLoop {
 public:
  static constexpr double kLate = 2e-4;  ///< s

  /// The object is put at orders.q first.
  HapticLoop(CollisionWorldPtr world, std::unique_ptr<HapticDevice> device, const HapticOrders& orders);
  ~HapticLoop();
  HapticLoop(const HapticLoop&) = delete;
  HapticLoop& operator=(const HapticLoop&) = delete;

  void order(const HapticOrders& orders) { orders_.set(orders); }
  HapticReport report() const;

 private:
  void run();
  void runCycles();
  void carryOutOrders();
  void cycle();

  CollisionWorldPtr world_;
  HapticServo servo_;  ///< the loop's, as are the next three
  HapticOrders current_;
  HapticReport now_;
  double reach_ = 0.0;  ///< how far the tracker looks
  Mailbox<std::optional<HapticOrders>> orders_;
  ContactTracker tracker_;
  mutable std::mutex mutex_;
  HapticReport report_;  ///< guarded by mutex_
  std::atomic<bool> quit_{false};
  std::thread thread_;
};

/// How far to look about an object: obstacles that repel, and enough to move on in.
double reachOf(const Guidance& guidance, double objectRadius);

}  // namespace glissade
