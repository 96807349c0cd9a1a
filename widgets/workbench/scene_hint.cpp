#include "widgets/workbench/scene_hint.h"

#include <QEvent>

#include <algorithm>

#include "widgets/scene3d/scale_bar.h"

namespace glissade {
namespace {

constexpr int kSceneHintMargin = 10;

}  // namespace

SceneHint::SceneHint(QWidget* scene) : QLabel(scene) {
  setObjectName(QStringLiteral("scene-hint"));
  setTextFormat(Qt::PlainText);
  setAutoFillBackground(true);
  setMargin(6);
  setAlignment(Qt::AlignCenter);
  hide();
  scene->installEventFilter(this);
}

void SceneHint::write(const QString& text) {
  const bool wasThere = !isHidden();
  setText(text);
  setVisible(!text.isEmpty());
  place();
  if (wasThere || !isHidden()) makeRoom();
}

double SceneHint::coveredShare() const {
  if (isHidden() || parentWidget()->height() == 0) return 0.0;
  return std::min(0.5, static_cast<double>(height() + kSceneHintMargin) / parentWidget()->height());
}

/// Keeps the scale of the scene above the text.
void SceneHint::makeRoom() {
  auto* scale = parentWidget()->findChild<ScaleBar*>();
  if (scale != nullptr) scale->setRoomBelow(isHidden() ? 0 : height() + kSceneHintMargin);
}

/// Places the text and wraps it if it is wider than the scene.
void SceneHint::place() {
  const QSize scene = parentWidget()->size();
  setWordWrap(false);
  const int widest = scene.width() - 2 * kSceneHintMargin;
  if (sizeHint().width() > widest) {
    setWordWrap(true);
    resize(widest, heightForWidth(widest));
  } else {
    adjustSize();
  }
  move((scene.width() - width()) / 2, scene.height() - height() - kSceneHintMargin);
  raise();
}

bool SceneHint::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QLabel::eventFilter(watched, event);
}

}  // namespace glissade
