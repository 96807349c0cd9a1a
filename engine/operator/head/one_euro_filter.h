#pragma once

namespace glissade {

/// Smooths a value that changes in time (Casiez, Roussel and Vogel: 1 EUR Filter, 2012): much where it rests, so that
/// it does not tremble, and little where it moves fast, so that it does not lag.
class OneEuroFilter {
 public:
  /// How long the smoothed value is behind: seconds at rest, and by how much the frequency of its cut-off rises with
  /// speed, in Hz for each unit of the value a second.
  struct Shape {
    double restDelay = 0.08;
    double speedUp = 0.0;

    friend bool operator==(const Shape&, const Shape&) = default;
  };

  void setShape(const Shape& shape) { shape_ = shape; }
  /// The value that it has from now on, at rest.
  void reset(double value);
  /// The smoothed value; `dt` seconds after the last one, more than 0.
  double smooth(double value, double dt);
  /// Seconds that the last smoothed value was behind a value of this speed.
  double delay() const { return delay_; }

 private:
  Shape shape_;
  double smoothed_ = 0.0;
  double speed_ = 0.0;
  double delay_ = 0.0;
};

}  // namespace glissade
