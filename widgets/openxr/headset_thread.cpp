#include "widgets/openxr/headset_thread.h"

#include <thread>
#include <utility>

#include "widgets/openxr/headset_failure.h"

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;

/// Time between two polls for events while nobody wears the headset.
constexpr std::chrono::milliseconds kIdleWait{20};
/// Number of pictures between two counts.
constexpr int kBetweenCounts = 20;
/// Time without a picture after which the runtime stalls.
constexpr std::chrono::seconds kStall{2};

}  // namespace

void HeadsetThread::setWanted(bool wanted) {
  const std::lock_guard lock(mutex_);
  wanted_ = wanted;
  status_ = {wanted ? HeadsetState::Searching : HeadsetState::Off, HeadsetTrouble::None, "", ""};
  changed_.notify_all();
  if (!wanted || alive_) return;
  alive_ = true;
  std::thread([self = shared_from_this()] { self->run(); }).detach();
}

HeadsetStatus HeadsetThread::status() const {
  const std::lock_guard lock(mutex_);
  HeadsetStatus status = status_;
  status.stalls = status.state == HeadsetState::Running && Clock::now() - lastPicture_ > kStall;
  return status;
}

HeadsetFigures HeadsetThread::figures() const {
  const std::lock_guard lock(mutex_);
  return figures_;
}

void HeadsetThread::setPlacement(const RoomPlacement& room) {
  const std::lock_guard lock(mutex_);
  placed_ = room;
}

void HeadsetThread::setBackground(const Colour& above, const Colour& below) {
  const std::lock_guard lock(mutex_);
  background_ = Background{above, below};
}

void HeadsetThread::setHands(HandInputsPtr hands) {
  const std::lock_guard lock(mutex_);
  hands_ = std::move(hands);
}

void HeadsetThread::setTools(HeadsetToolsPtr tools) {
  const std::lock_guard lock(mutex_);
  tools_ = std::move(tools);
}

void HeadsetThread::setListener(std::function<void()> listener) {
  const std::lock_guard lock(mutex_);
  listener_ = std::move(listener);
}

bool HeadsetThread::waitForEnd(std::chrono::milliseconds longest) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, longest, [this] { return !alive_; });
}

void HeadsetThread::run() {
  for (;;) {
    serve();
    const std::lock_guard lock(mutex_);
    if (wanted_) continue;
    alive_ = false;
    changed_.notify_all();
    return;
  }
}

/// Serves until the headset is not wanted any more, or the person has left.
void HeadsetThread::serve() {
  left_ = false;
  machine_.ask(Clock::now());
  while (!left_ && isWanted()) {
    try {
      step();
    } catch (const HeadsetFailure& why) {
      fail(why.trouble(), why.what());
    } catch (const std::exception& why) {
      fail(HeadsetTrouble::Failed, why.what());
    }
    if (!left_) publish();
  }
  disconnect();
}

void HeadsetThread::step() {
  if (!connection_) {
    waitUntil(machine_.nextSearch());
    if (isWanted()) search();
    return;
  }
  follow(connection_->poll());
  switch (machine_.status().state) {
    case HeadsetState::Running: show(); break;
    case HeadsetState::Idle: waitUntil(Clock::now() + kIdleWait); break;
    default: break;
  }
}

void HeadsetThread::search() {
  if (!scene_) scene_ = std::make_unique<HeadsetScene>(graph_);
  scene_->context().makeCurrent();
  HandInputsPtr hands;
  HeadsetToolsPtr tools;
  {
    const std::lock_guard lock(mutex_);
    hands = hands_;
    tools = tools_;
  }
  connection_ = std::make_unique<HeadsetConnection>(*scene_, hands, tools);
  machine_.connect(connection_->name());
}

void HeadsetThread::follow(SessionChange change) {
  switch (change) {
    case SessionChange::Nothing: break;
    case SessionChange::Began: machine_.begin(); break;
    case SessionChange::Ended: machine_.end(); break;
    case SessionChange::Lost: throw HeadsetFailure(HeadsetTrouble::SessionLost, "the session ends");
    case SessionChange::Left: leave(); break;
  }
}

/// Clears the request before the listener is called, so that a new request by the listener is served.
void HeadsetThread::leave() {
  machine_.leave();
  left_ = true;
  std::function<void()> listener;
  {
    const std::lock_guard lock(mutex_);
    if (!wanted_) return;
    wanted_ = false;
    status_ = machine_.status();
    listener = listener_;
  }
  if (listener) listener();
}

void HeadsetThread::show() {
  std::optional<RoomPlacement> placed;
  std::optional<Background> background;
  {
    const std::lock_guard lock(mutex_);
    lastPicture_ = Clock::now();
    placed = std::exchange(placed_, std::nullopt);
    background = std::exchange(background_, std::nullopt);
  }
  if (background) scene_->setBackground(background->above, background->below);
  if (placed) walk_.place(*placed);
  connection_->showPicture(walk_);
  machine_.setRefused(connection_->refused());
  if (++sinceCount_ >= kBetweenCounts) count();
}

/// Updates the figures, which takes a traversal of the whole scene.
void HeadsetThread::count() {
  sinceCount_ = 0;
  const EyeFigures eye = scene_->figures();
  const std::lock_guard lock(mutex_);
  figures_ = {connection_->detailStep(), eye.drawCalls, eye.triangles, eye.cullSeconds, eye.drawSeconds};
}

void HeadsetThread::fail(HeadsetTrouble trouble, const std::string& detail) {
  if (!connection_) {
    machine_.failSearch(trouble, detail, Clock::now());
    return;
  }
  machine_.lose(trouble, detail);
  publish();
  connection_.reset();
  machine_.release(Clock::now());
}

/// Releases the context for the next thread.
void HeadsetThread::disconnect() {
  connection_.reset();
  if (scene_) scene_->context().release();
}

/// Announces a new status, unless the headset is not wanted any more.
void HeadsetThread::publish() {
  std::function<void()> listener;
  {
    const std::lock_guard lock(mutex_);
    if (!wanted_ || status_ == machine_.status()) return;
    status_ = machine_.status();
    listener = listener_;
  }
  if (listener) listener();
}

bool HeadsetThread::isWanted() const {
  const std::lock_guard lock(mutex_);
  return wanted_;
}

void HeadsetThread::waitUntil(HeadsetMachine::Time time) {
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, time, [this] { return !wanted_; });
}

void HeadsetThread::forgetScene() { scene_.reset(); }

}  // namespace glissade
