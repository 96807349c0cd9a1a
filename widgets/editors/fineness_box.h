#pragma once

#include <QDoubleSpinBox>

namespace glissade {

/// Asks by how much triangles may be off the surfaces of STEP files; at first by the size of each part.
class FinenessBox final : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit FinenessBox(QWidget* parent = nullptr);

  /// 0: by the size of each part.
  double metres() const { return value() / 1e3; }
};

}  // namespace glissade
