#include "widgets/devices/head_controller.h"

#include <numbers>

#include "engine/base/number_text.h"

namespace glissade {
namespace {

constexpr int kBackTick = 16;       ///< ms
constexpr int kSilenceMargin = 20;  ///< a timer may be early by so many ms
constexpr double kMilliseconds = 1000.0;
constexpr int kSignMargin = 10;
/// A script's tracker sends at this rate, and repeats each reading for kScriptHold seconds.
constexpr double kScriptRate = 60.0;
constexpr double kScriptHold = 3.0;

using Words = ScriptCommands::Words;

/// Reads centimetres and degrees, as trackers send them.
Result<HeadReading> readingOf(const Words& words) {
  HeadReading reading{};
  for (std::size_t i = 0; i < reading.size(); ++i) {
    const auto number = toNumber(words[i]);
    if (!number) return wrongCommand("'" + words[i] + "' is not a number", "Give numbers.");
    reading[i] = *number * (i < 3 ? 0.01 : std::numbers::pi / 180.0);
  }
  return reading;
}

}  // namespace

HeadController::HeadController(const Workbench& bench, EyePlaceKeeper& eyePlace)
    : QObject(&bench.window),
      bench_(bench),
      eyePlace_(eyePlace),
      preferences_(settings_.preferences()),
      sign_(new QLabel(bench.scene.widget())) {
  tracking_.setShaping(preferences_.shaping);
  clock_.start();
  silence_.setSingleShot(true);
  silence_.setInterval(static_cast<int>(HeadTracking::kSilence * kMilliseconds) + kSilenceMargin);
  back_.setInterval(kBackTick);
  sign_->setObjectName(QStringLiteral("head-sign"));
  sign_->setAutoFillBackground(true);
  sign_->setMargin(6);
  sign_->move(kSignMargin, kSignMargin);
  sign_->hide();
  connect(&silence_, &QTimer::timeout, this, &HeadController::noticeSilence);
  connect(&back_, &QTimer::timeout, this, &HeadController::goBack);
  connect(&receiver_, &HeadReceiver::received, this, &HeadController::take);
  connect(bench.actions["operator.head"], &QAction::toggled, this, &HeadController::setOn);
  bench.onAction("operator.head-page", this, [this] { showDialog(); });
  addCommands();
}

void HeadController::addCommands() {
  bench_.scripts.add("head", 6, [this](const Words& words) -> Outcome {
    const auto reading = readingOf(words);
    if (!reading) return reading.error();
    if (!isOn()) return wrongCommand("the head is not followed", "Carry out: action operator.head");
    for (const double end = scriptTime_ + kScriptHold; scriptTime_ < end; scriptTime_ += 1.0 / kScriptRate) {
      take(*reading);
    }
    if (dialog_ != nullptr) dialog_->refresh();
    return Done{};
  });
  bench_.scripts.add("head-silent", 1, [this](const Words& words) -> Outcome {
    const auto seconds = toNumber(words[0]);
    if (!seconds || *seconds < 0.0) return wrongCommand("'" + words[0] + "' is not a time", "Give seconds.");
    scriptTime_ += *seconds;
    if (isOn() && !tracking_.isTracked(now())) {
      noticeSilence();
      goBack();
    }
    return Done{};
  });
}

bool HeadController::isOn() const { return bench_.actions["operator.head"]->isChecked(); }

double HeadController::now() const {
  const bool isScripted = bench_.session.clock() == SessionClock::Lockstep;
  return isScripted ? scriptTime_ : static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
}

void HeadController::setOn(bool on) {
  silence_.stop();
  back_.stop();
  receiver_.close();
  sign_->hide();
  tracking_ = HeadTracking();
  tracking_.setShaping(preferences_.shaping);
  if (!on) {
    eyePlace_.setHead(std::nullopt);
    return;
  }
  if (!listen()) {
    bench_.actions["operator.head"]->setChecked(false);
    return;
  }
  show();
}

bool HeadController::listen() {
  if (bench_.session.clock() == SessionClock::Lockstep) return true;
  if (!receiver_.open(preferences_.port, preferences_.fromAnywhere)) {
    bench_.messages.showError(tr("The head cannot be tracked"),
                              {ErrorKind::MalformedInput,
                               "",
                               {GLISSADE_TEXT("UDP port %1"), {preferences_.port}},
                               {GLISSADE_TEXT("cannot be used: %1"), {receiver_.trouble().toStdString()}},
                               GLISSADE_TEXT("Choose another port, and set it in the tracker, too.")});
    return false;
  }
  silence_.start();
  return true;
}

void HeadController::change(const HeadPreferences& preferences) {
  const bool otherSocket =
      preferences.port != preferences_.port || preferences.fromAnywhere != preferences_.fromAnywhere;
  preferences_ = preferences;
  settings_.save(preferences_);
  if (dialog_ != nullptr && !settings_.writable()) dialog_->showTrouble(settings_.file());
  tracking_.setShaping(preferences_.shaping);
  if (!otherSocket || !isOn()) return;
  receiver_.close();
  if (!listen()) bench_.actions["operator.head"]->setChecked(false);
}

void HeadController::take(const HeadReading& reading) {
  back_.stop();
  sign_->hide();
  tracking_.take(reading, now());
  if (receiver_.isOpen()) silence_.start();
  show();
}

void HeadController::noticeSilence() {
  if (receiver_.hasMore()) {  // the window was late, not the tracker
    silence_.start();
    return;
  }
  sign_->setText(tr("The head is not tracked: nothing comes to port %1").arg(preferences_.port));
  sign_->adjustSize();
  sign_->show();
  if (receiver_.isOpen() && !tracking_.isAtRest()) back_.start();
  bench_.scene.refresh();
}

void HeadController::goBack() {
  tracking_.passTime(now());
  if (tracking_.isAtRest()) back_.stop();
  show();
}

void HeadController::show() {
  const HeadMotion motion = tracking_.motion();
  HeadPose head = restingHead(eyePlace_.screen());
  head.position += motion.shift;
  head.orientation = motion.turn;
  eyePlace_.setHead(head);
}

HeadState HeadController::state() const {
  return {
      isOn(), tracking_.isTracked(now()), tracking_.last(), tracking_.motion(), tracking_.delay(), receiver_.dropped()};
}

void HeadController::showDialog() {
  if (dialog_ == nullptr) {
    dialog_ = new HeadDialog(
        preferences_, [this] { return state(); }, &bench_.window);
    connect(dialog_, &HeadDialog::changed, this, &HeadController::change);
    connect(dialog_, &HeadDialog::restRequested, this, [this] {
      tracking_.restHere();
      HeadPreferences preferences = preferences_;
      preferences.shaping = tracking_.shaping();
      change(preferences);
      dialog_->setPreferences(preferences_);
    });
  }
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

}  // namespace glissade
