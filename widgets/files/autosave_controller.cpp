#include "widgets/files/autosave_controller.h"

#include <chrono>
#include <exception>
#include <utility>

#include "engine/files/scenario_io.h"
#include "widgets/workbench/preferences.h"

namespace glissade {
namespace {

constexpr int kMillisecondsPerSecond = 1000;
/// Seconds of pause for each second that writing took: writing uses at most a tenth of a core.
constexpr double kPausePerSecond = 9.0;

}  // namespace

AutosaveController::AutosaveController(Source source, QObject* parent) : QObject(parent), source_(std::move(source)) {
  setInterval(Preferences{}.autosaveSeconds);
  connect(&timer_, &QTimer::timeout, this, [this] { writeChanges(); });
}

AutosaveController::~AutosaveController() = default;

void AutosaveController::setInterval(int seconds) { timer_.setInterval(kMillisecondsPerSecond * seconds); }

void AutosaveController::start(const QString& folder) {
  auto slot = AutosaveSlot::make(folder.toStdString());
  if (!slot) {
    emit failed(slot.error());
    return;
  }
  slot_ = std::move(*slot);
  timer_.start();
}

void AutosaveController::writeChanges(bool wait) {
  using namespace std::chrono_literals;
  if (writing_.valid() && !wait && writing_.wait_for(0s) != std::future_status::ready) return;
  takeOutcome();
  if (!slot_) return;
  if (!wait && sinceWritten_.isValid() && sinceWritten_.elapsed() < pause_ * kMillisecondsPerSecond) return;
  writing_ =
      std::async(std::launch::async, [slot = slot_, edits = source_(), this] { return write(*slot, edits, written_); });
  if (wait) takeOutcome();
}

AutosaveController::Written AutosaveController::write(AutosaveSlot& slot, const std::optional<UnsavedEdits>& edits,
                                                      std::string& last) {
  QElapsedTimer timer;
  timer.start();
  const auto outcome = [&]() -> Outcome {
    try {
      std::string text = edits ? edits->file + writeScenario(edits->scenario) : "";
      if (text == last) return Done{};
      last = std::move(text);
      if (edits) return slot.write(*edits);
      slot.clear();
      return Done{};
    } catch (const std::exception& error) {
      return Diagnostic{ErrorKind::Internal,
                        "",
                        "",
                        {GLISSADE_TEXT("edits cannot be saved automatically: %1"), {error.what()}},
                        GLISSADE_TEXT("Save the scenario.")};
    }
  }();
  return {outcome, static_cast<double>(timer.nsecsElapsed()) / 1e9};
}

void AutosaveController::takeOutcome() {
  if (!writing_.valid()) return;
  const Written written = writing_.get();
  pause_ = kPausePerSecond * written.seconds;
  sinceWritten_.start();
  if (written.outcome) return;
  timer_.stop();
  slot_.reset();
  emit failed(written.outcome.error());
}

}  // namespace glissade
