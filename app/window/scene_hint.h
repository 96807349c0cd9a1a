#pragma once

#include <QLabel>

namespace glissade {

/// One line over the scene, in the middle of its lower border: what to do next, or what was found.
class SceneHint final : public QLabel {
  Q_OBJECT

 public:
  explicit SceneHint(QWidget* scene);

  /// Empty: it is hidden.
  void write(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void makeRoom();
};

}  // namespace glissade
