#pragma once

#include <string>
#include <vector>

namespace glissade {

/// A mark on an axis. Minor ticks have no label.
struct PlotTick {
  double position = 0.0;  ///< position along the axis, from 0 to 1
  std::string label;
};

/// An axis: the position of a value on it, from 0 to 1, and its ticks.
class PlotScale {
 public:
  /// A linear axis with round bounds around the values, which may be empty.
  static PlotScale linear(std::string title, const std::vector<double>& values);
  /// An axis from 0 to 100.
  static PlotScale percentages(std::string title);
  /// A logarithmic axis where the positive values span more than a factor of twenty, else a linear one from 0. Bounds
  /// of a logarithmic axis are 1, 2 or 5 times a power of ten. A zero among its values has its own place at the end.
  static PlotScale fitting(std::string title, const std::vector<double>& values);

  double position(double value) const;
  const std::vector<PlotTick>& ticks() const { return ticks_; }
  const std::string& title() const { return title_; }

 private:
  static PlotScale logarithmic(std::string title, const std::vector<double>& values);

  void markLinear();
  void markLogarithmic();

  bool isLogarithmic_ = false;
  std::string title_;
  double low_ = 0.0;  ///< lower bound; its logarithm for a logarithmic axis
  double high_ = 1.0;
  double zeroWidth_ = 0.0;  ///< share of the axis that is reserved for the zero
  std::vector<PlotTick> ticks_;
};

}  // namespace glissade
