#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "engine/operator/haptic/contact_tracker.h"
#include "engine/operator/haptic/haptic_servo.h"

namespace glissade {

/// Requests to the loop. The latest counts. A counter grows with every request, so that none is carried out twice.
struct HapticOrders {
  Guidance guidance;
  Box3 bounds;
  Pose q;                        ///< pose at which the object is put
  std::uint64_t placements = 0;  ///< number of placements requested
  std::uint64_t restarts = 0;    ///< number of new runs
};

/// State of the loop.
struct HapticReport {
  HapticCycle cycle;
  std::uint64_t placements = 0;  ///< number of placements carried out
  bool connected = true;
  std::uint64_t cycles = 0;   ///< number of cycles since the beginning, including missed ones
  std::uint64_t late = 0;     ///< number of cycles that began more than HapticLoop::kLate after their time
  double longestDelay = 0.0;  ///< longest delay, seconds
  std::uint64_t queries = 0;  ///< queries of the contact tracker
  /// The exception that ended the loop; null while it runs. The device renders no force any more.
  std::exception_ptr failure;
};

/// The haptic loop: a servo cycle each millisecond on its own thread, by absolute deadlines. Whole periods that were
/// missed count as late cycles and are not repeated. The tracker does the collision queries; where a query takes longer
/// than a cycle, the object goes on in the known ball and along the known planes. Neither thread waits for the other:
/// the loop only tries locks.
///
/// It requests real-time priority and goes on without where the system refuses it. An exception of the device or of a
/// query ends the loop and is reported to the thread that asks for the report.
class HapticLoop {
 public:
  static constexpr double kLate = 2e-4;  ///< seconds

  /// The object is first put at orders.q.
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
  HapticServo servo_;  ///< used by the loop's thread, as are the next three members
  HapticOrders current_;
  HapticReport now_;
  double reach_ = 0.0;  ///< distance within which the tracker searches for obstacles
  Mailbox<std::optional<HapticOrders>> orders_;
  ContactTracker tracker_;
  mutable std::mutex mutex_;
  HapticReport report_;  ///< guarded by mutex_
  std::atomic<bool> quit_{false};
  std::thread thread_;
};

/// Distance within which obstacles about an object are searched for: those that repel, and enough for further motion.
double reachOf(const Guidance& guidance, double objectRadius);

}  // namespace glissade
