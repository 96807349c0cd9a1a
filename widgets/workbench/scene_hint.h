#pragma once

#include <QLabel>

namespace glissade {

/// A text over the scene, in the middle of its lower border: the next action, or a result.
class SceneHint final : public QLabel {
  Q_OBJECT

 public:
  explicit SceneHint(QWidget* scene);

  /// Shows the text; an empty text hides the label.
  void write(const QString& text);
  /// Share of the scene's height that the text covers, at the lower border.
  double coveredShare() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void makeRoom();
};

}  // namespace glissade
