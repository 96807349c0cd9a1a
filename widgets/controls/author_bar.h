#pragma once

#include <QWidget>

#include "engine/planning/roadmap.h"

namespace glissade {

/// The shares of the authors as a thin stacked bar over its legend with the numbers. The colours are those of the
/// scene.
class AuthorBar final : public QWidget {
  Q_OBJECT

 public:
  explicit AuthorBar(QWidget* parent = nullptr);

  /// `numbers` stand in the legend, `shares` make the bar (of any sum).
  void setShares(const PerAuthor<double>& shares, const PerAuthor<QString>& numbers);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  PerAuthor<double> shares_{};
  PerAuthor<QString> names_;
  PerAuthor<QString> numbers_;
};

}  // namespace glissade
