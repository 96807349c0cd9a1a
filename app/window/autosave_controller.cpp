#include "app/window/autosave_controller.h"

#include <chrono>
#include <exception>
#include <utility>

#include "app/window/preferences.h"
#include "engine/scenario/scenario_io.h"

namespace glissade {
namespace {

constexpr int kMillisecondsPerSecond = 1000;

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
  auto edits = source_();
  const std::string text = edits ? edits->file + writeScenario(edits->scenario) : "";
  if (text == written_) return;
  written_ = text;
  writing_ = std::async(std::launch::async, [slot = slot_, edits = std::move(edits)]() -> Outcome {
    try {
      if (edits) return slot->write(*edits);
      slot->clear();
      return Done{};
    } catch (const std::exception& error) {
      return Diagnostic{ErrorKind::Internal, "", "",
                        std::string("edits cannot be saved automatically: ") + error.what(), "Save the scenario."};
    }
  });
  if (wait) takeOutcome();
}

void AutosaveController::takeOutcome() {
  if (!writing_.valid()) return;
  const Outcome outcome = writing_.get();
  if (outcome) return;
  timer_.stop();
  slot_.reset();
  emit failed(outcome.error());
}

}  // namespace glissade
