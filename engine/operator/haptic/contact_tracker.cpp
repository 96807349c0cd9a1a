#include "engine/operator/haptic/contact_tracker.h"

#include <chrono>

namespace glissade {
namespace {

/// While nothing is asked it looks again after this long.
constexpr std::chrono::microseconds kPause{200};

}  // namespace

ContactTracker::ContactTracker(const CollisionWorld& world) : query_(world.makeQuery()), thread_([this] { run(); }) {}

ContactTracker::~ContactTracker() {
  quit_ = true;
  thread_.join();
}

void ContactTracker::ask(const Pose& q, double reach) { question_.trySet(Question{q, reach}); }

void ContactTracker::rethrowFailure() const {
  if (failed_) std::rethrow_exception(failure_);
}

void ContactTracker::run() {
  try {
    answerQuestions();
  } catch (...) {
    failure_ = std::current_exception();
    failed_ = true;
  }
}

void ContactTracker::answerQuestions() {
  while (!quit_) {
    const auto question = question_.take();
    if (!question) {
      std::this_thread::sleep_for(kPause);
      continue;
    }
    answer_.set(lookAround(*query_, question->q, question->reach));
    ++queries_;
  }
}

}  // namespace glissade
