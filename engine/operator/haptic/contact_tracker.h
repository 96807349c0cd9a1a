#pragma once

#include <atomic>
#include <exception>
#include <optional>
#include <thread>

#include "engine/base/mailbox.h"
#include "engine/operator/haptic/surroundings.h"

namespace glissade {

/// Looks about the object on a thread of its own, as fast as the collision query goes, so that the
/// haptic loop never waits for one: a query takes from microseconds to milliseconds.
class ContactTracker {
 public:
  explicit ContactTracker(const CollisionWorld& world);
  ~ContactTracker();
  ContactTracker(const ContactTracker&) = delete;
  ContactTracker& operator=(const ContactTracker&) = delete;

  /// Called by the loop's thread alone; neither waits.
  void ask(const Pose& q, double reach);
  std::optional<Surroundings> answer() { return answer_.tryTake(); }

  std::uint64_t queries() const { return queries_; }
  /// Throws the exception that ended the tracker's thread, if one did.
  void rethrowFailure() const;

 private:
  struct Question {
    Pose q;
    double reach = 0.0;
  };

  void run();
  void answerQuestions();

  std::unique_ptr<CollisionQuery> query_;
  Mailbox<std::optional<Question>> question_;
  Mailbox<std::optional<Surroundings>> answer_;
  std::atomic<std::uint64_t> queries_{0};
  std::atomic<bool> quit_{false};
  std::exception_ptr failure_;  ///< written before failed_
  std::atomic<bool> failed_{false};
  std::thread thread_;
};

}  // namespace glissade
