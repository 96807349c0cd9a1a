#include "widgets/scene3d/label_overlay.h"

#include <QFontMetrics>
#include <QLocale>
#include <QPainter>

#include <optional>

#include "widgets/controls/length_text.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/label_placement.h"
#include "widgets/scene3d/legend_overlay.h"

namespace glissade {
namespace {

constexpr int kDigits = 3;
constexpr double kSmall = 0.85;  ///< share of the usual size

/// The camera between both eyes. Labels are placed for it, so that both eyes see them at one height.
CameraController betweenTheEyes(const CameraController& camera) {
  CameraController middle = camera;
  EyePlace eyePlace = camera.eyePlace();
  eyePlace.eye.setZero();
  middle.setEyePlace(eyePlace);
  return middle;
}

}  // namespace

QString labelText(const SceneLabel& label) {
  if (label.length) return lengthText(*label.length);
  return label.number ? QLocale().toString(*label.number, 'g', kDigits) : QString::fromStdString(label.text);
}

LabelOverlay::LabelOverlay(const SceneView& view, const LegendOverlay& legend, QWidget* scene)
    : SceneOverlay(view, scene), legend_(legend) {}

void LabelOverlay::paintEvent(QPaintEvent* /*event*/) {
  std::vector<SceneLabel> labels;
  std::vector<QPointF> shifts;
  std::vector<WantedLabel> requested;
  const CameraController middle = betweenTheEyes(view().camera());
  for (const SceneLabel& label : view().labels()) {
    const auto at = onScreen(middle, label.p_W);
    const auto seen = onScreen(label.p_W);
    if (!at || !seen) continue;
    labels.push_back(label);
    shifts.push_back(*seen - *at);
    requested.push_back({boxOf(label, *at), label.strong, label.small});
  }
  const auto places = placeLabels(requested, legend_.box());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (places[i]) paint(painter, labels[i], places[i]->translated(shifts[i]));
  }
}

QFont LabelOverlay::fontOf(const SceneLabel& label) const {
  QFont smaller = font();
  if (label.small) smaller.setPointSizeF(kSmall * smaller.pointSizeF());
  return smaller;
}

QRectF LabelOverlay::boxOf(const SceneLabel& label, const QPointF& at) const {
  QRectF box = QFontMetrics(fontOf(label)).boundingRect(labelText(label));
  box.adjust(-5, -2, 5, 2);
  box.moveCenter(at + QPointF(0, label.below ? box.height() : 0));
  return box;
}

void LabelOverlay::paint(QPainter& painter, const SceneLabel& label, const QRectF& box) const {
  QColor ground = palette().color(label.strong ? QPalette::Highlight : QPalette::Base);
  ground.setAlphaF(label.strong ? 0.95 : 0.75);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(box, 4, 4);
  painter.setPen(palette().color(label.strong ? QPalette::HighlightedText : QPalette::Text));
  painter.setFont(fontOf(label));
  painter.drawText(box, Qt::AlignCenter, labelText(label));
}

}  // namespace glissade
