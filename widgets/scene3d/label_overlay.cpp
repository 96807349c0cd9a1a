#include "widgets/scene3d/label_overlay.h"

#include <QEvent>
#include <QFontMetrics>
#include <QLocale>
#include <QPainter>

#include <optional>

#include "widgets/commands/length_text.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/label_placement.h"
#include "widgets/scene3d/legend_overlay.h"

namespace glissade {
namespace {

/// Where a point of the scene is in a widget of the given size; nothing behind the eye.
std::optional<QPointF> project(const CameraController& camera, const Vector3& p_W, const QSize& size) {
  const auto at = camera.project(p_W);
  if (!at) return std::nullopt;
  return QPointF(size.width() / 2.0 + at->x() * size.height(), size.height() / 2.0 + at->y() * size.height());
}

constexpr int kDigits = 3;
constexpr double kSmall = 0.85;  ///< of the usual size

QString textOf(const SceneLabel& label) {
  if (label.length) return lengthText(*label.length);
  return label.number ? QLocale().toString(*label.number, 'g', kDigits) : QString::fromStdString(label.text);
}

}  // namespace

LabelOverlay::LabelOverlay(const SceneView& view, const LegendOverlay& legend, QWidget* scene)
    : QWidget(scene), view_(view), legend_(legend) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  scene->installEventFilter(this);
  resize(scene->size());
}

bool LabelOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(static_cast<QWidget*>(watched)->size());
  return QWidget::eventFilter(watched, event);
}

void LabelOverlay::paintEvent(QPaintEvent* /*event*/) {
  std::vector<SceneLabel> labels;
  std::vector<WantedLabel> requested;
  for (const SceneLabel& label : view_.labels()) {
    const auto at = project(view_.camera(), label.p_W, size());
    if (!at) continue;
    labels.push_back(label);
    requested.push_back({boxOf(label, *at), label.strong, label.small});
  }
  const auto places = placeLabels(requested, legend_.box());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (places[i]) paint(painter, labels[i], *places[i]);
  }
}

QFont LabelOverlay::fontOf(const SceneLabel& label) const {
  QFont smaller = font();
  if (label.small) smaller.setPointSizeF(kSmall * smaller.pointSizeF());
  return smaller;
}

QRectF LabelOverlay::boxOf(const SceneLabel& label, const QPointF& at) const {
  QRectF box = QFontMetrics(fontOf(label)).boundingRect(textOf(label));
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
  painter.drawText(box, Qt::AlignCenter, textOf(label));
}

}  // namespace glissade
