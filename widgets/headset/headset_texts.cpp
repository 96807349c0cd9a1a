#include "widgets/headset/headset_texts.h"

#include <algorithm>

#include "widgets/controls/length_text.h"
#include "widgets/headset/text_picture.h"
#include "widgets/scene3d/label_overlay.h"

namespace glissade {
namespace {

constexpr int kLabelTick = 100;  ///< ms
/// Maximum number of labels; more would hide the scene.
constexpr std::size_t kMostLabels = 40;

bool isSame(const SceneLabel& a, const SceneLabel& b) {
  return a.p_W == b.p_W && a.strong == b.strong && labelText(a) == labelText(b);
}

/// The labels that are shown: strong labels come first; small ones are left out, because only a window has room for
/// them.
std::vector<SceneLabel> shownOf(std::vector<SceneLabel> labels) {
  std::erase_if(labels, [](const SceneLabel& label) { return label.small; });
  std::stable_partition(labels.begin(), labels.end(), [](const SceneLabel& label) { return label.strong; });
  if (labels.size() > kMostLabels) labels.erase(labels.begin() + kMostLabels, labels.end());
  return labels;
}

}  // namespace

HeadsetTexts::HeadsetTexts(const Workbench& bench, HeadsetToolsPtr tools)
    : QObject(&bench.window), bench_(bench), tools_(std::move(tools)) {
  timer_.setInterval(kLabelTick);
  connect(&timer_, &QTimer::timeout, this, &HeadsetTexts::showLabels);
}

void HeadsetTexts::setOn(bool on) {
  if (on) {
    timer_.start();
    connect(&bench_.run, &ShownRun::changed, this, &HeadsetTexts::showNote, Qt::UniqueConnection);
  } else {
    timer_.stop();
    disconnect(&bench_.run, nullptr, this, nullptr);
  }
}

void HeadsetTexts::setHint(const QString& hint) {
  hint_ = hint;
  showNote();
}

void HeadsetTexts::showLabels() {
  std::vector<SceneLabel> labels = shownOf(bench_.scene.view().labels());
  if (std::equal(labels.begin(), labels.end(), labels_.begin(), labels_.end(), isSame)) return;
  labels_ = std::move(labels);
  auto pictures = std::make_shared<std::vector<FlatLabel>>();
  for (const SceneLabel& label : labels_) {
    pictures->push_back({label.p_W, textPicture(labelText(label), bench_.window.palette(), label.strong)});
  }
  tools_->labels.set(pictures);
}

/// Shows the distance to the nearest obstacle in the format of the run's figures.
void HeadsetTexts::showNote() {
  QString note = hint_;
  const SnapshotPtr& snapshot = bench_.run.snapshot();
  if (snapshot && snapshot->device.nearest.body >= 0 && holds()) {
    const NearestObstacle& nearest = snapshot->device.nearest;
    const auto& body = bench_.document.scenario()->obstacles[static_cast<std::size_t>(nearest.body)];
    note = tr("%1 to %2").arg(lengthText(std::max(0.0, nearest.distance)), QString::fromStdString(body.shown()));
  }
  if (note == note_) return;
  note_ = note;
  tools_->note.set(note.isEmpty() ? nullptr : textPicture(note, bench_.window.palette(), true));
}

bool HeadsetTexts::holds() const {
  if (!bench_.session.hand()->controllersMoveObject) return false;
  const auto controllers = bench_.session.hand()->controllers();
  return std::any_of(controllers.begin(), controllers.end(),
                     [](const ControllerInput* controller) { return controller->place.feedback().holds; });
}

}  // namespace glissade
