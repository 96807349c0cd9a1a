#include "widgets/openxr/headset_machine.h"

#include <algorithm>

namespace glissade {

void HeadsetMachine::ask(Time now) {
  status_ = {HeadsetState::Searching, HeadsetTrouble::None, "", ""};
  wait_ = kFirstWait;
  nextSearch_ = now;
}

void HeadsetMachine::failSearch(HeadsetTrouble trouble, const std::string& detail, Time now) {
  status_ = {HeadsetState::Searching, trouble, detail, ""};
  waitLonger(now);
}

void HeadsetMachine::connect(const std::string& name) {
  status_ = {HeadsetState::Idle, HeadsetTrouble::None, "", name};
  hasRun_ = false;
}

void HeadsetMachine::begin() {
  status_.state = HeadsetState::Running;
  hasRun_ = true;
  wait_ = kFirstWait;
}

void HeadsetMachine::end() { status_.state = HeadsetState::Idle; }

void HeadsetMachine::lose(HeadsetTrouble trouble, const std::string& detail) {
  status_ = {HeadsetState::Lost, trouble, detail, ""};
}

void HeadsetMachine::release(Time now) {
  status_.state = HeadsetState::Searching;
  if (hasRun_) {
    nextSearch_ = now;
  } else {
    waitLonger(now);
  }
}

void HeadsetMachine::leave() { status_ = {HeadsetState::Left, HeadsetTrouble::None, "", ""}; }

void HeadsetMachine::waitLonger(Time now) {
  nextSearch_ = now + wait_;
  wait_ = std::min(2 * wait_, kLongestWait);
}

}  // namespace glissade
