#include "widgets/headset/pointer_mailbox.h"

#include <utility>

namespace glissade {
namespace {

bool isPressed(const PointerMailbox::Moment& moment) { return moment && moment->pressed; }

/// The second one is only a motion since the first one.
bool isMotion(const PointerMailbox::Moment& from, const PointerMailbox::Moment& to) {
  return from && to && isPressed(from) == isPressed(to);
}

}  // namespace

void PointerMailbox::set(const Moment& now) {
  if (!add(now)) return;
  const std::lock_guard lock(listenerMutex_);
  if (listener_) listener_();
}

/// The last moment may go where it was a motion itself.
bool PointerMailbox::add(const Moment& now) {
  const std::lock_guard lock(mutex_);
  if (now == last_) return false;
  const bool replaces =
      moments_.size() > 1 && isMotion(moments_[moments_.size() - 2], moments_.back()) && isMotion(moments_.back(), now);
  if (replaces) moments_.pop_back();
  moments_.push_back(now);
  last_ = now;
  return true;
}

std::vector<PointerMailbox::Moment> PointerMailbox::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(moments_, {});
}

void PointerMailbox::setListener(std::function<void()> listener) {
  const std::lock_guard lock(listenerMutex_);
  listener_ = std::move(listener);
}

}  // namespace glissade
