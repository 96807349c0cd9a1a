#include "widgets/headset/pointer_mailbox.h"

namespace glissade {
namespace {

bool isPressed(const PointerMailbox::Moment& moment) { return moment && moment->pressed; }

/// The second one is only a motion since the first one.
bool isMotion(const PointerMailbox::Moment& from, const PointerMailbox::Moment& to) {
  return from && to && isPressed(from) == isPressed(to);
}

}  // namespace

void PointerMailbox::set(const Moment& now) {
  heard_.change([&](Heard& heard) { return add(now, heard); });
}

/// The last moment may go where it was a motion itself.
bool PointerMailbox::add(const Moment& now, Heard& heard) {
  auto& [last, moments] = heard;
  if (now == last) return false;
  const bool replaces =
      moments.size() > 1 && isMotion(moments[moments.size() - 2], moments.back()) && isMotion(moments.back(), now);
  if (replaces) moments.pop_back();
  moments.push_back(now);
  last = now;
  return true;
}

std::vector<PointerMailbox::Moment> PointerMailbox::take() {
  std::vector<Moment> moments;
  heard_.change([&](Heard& heard) {
    moments.swap(heard.moments);
    return false;
  });
  return moments;
}

}  // namespace glissade
