#include "widgets/openxr/pointer_mailbox.h"

namespace glissade {
namespace {

bool isPressed(const PointerMailbox::Moment& moment) { return moment && moment->pressed; }

/// Whether the second moment differs from the first by a motion only.
bool isMotion(const PointerMailbox::Moment& from, const PointerMailbox::Moment& to) {
  return from && to && isPressed(from) == isPressed(to);
}

}  // namespace

void PointerMailbox::set(const Moment& now) {
  heard_.change([&](Heard& heard) { return add(now, heard); });
}

/// Adds a moment. It replaces the last one if both are motions.
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
