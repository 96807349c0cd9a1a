#pragma once

#include <QAbstractSpinBox>
#include <cstdint>

namespace glissade {

/// A number box for seeds: whole numbers of 64 bits, which no box of Qt supports.
class SeedBox final : public QAbstractSpinBox {
  Q_OBJECT

 public:
  explicit SeedBox(QWidget* parent = nullptr);

  std::uint64_t seed() const { return seed_; }
  /// Shows a seed without a signal.
  void setSeed(std::uint64_t seed);

  void stepBy(int steps) override;
  QValidator::State validate(QString& input, int& position) const override;
  void fixup(QString& input) const override;

 signals:
  /// The user has set another seed.
  void seedChosen(quint64 seed);

 protected:
  StepEnabled stepEnabled() const override;

 private:
  void choose(std::uint64_t seed);

  std::uint64_t seed_ = 0;
};

}  // namespace glissade
