#pragma once

#include <string>
#include <vector>

namespace glissade {

/// A mark on an axis. Minor ticks have no label.
struct PlotTick {
  double position = 0.0;  ///< position along the axis, from 0 to 1
  std::string label;
};

/// An axis: the position of a value on it, from 0 to 1, and its ticks. The report and the window use the same scales,
/// so that their plots are the same.
class PlotScale {
 public:
  /// A linear axis with round bounds around the values, which may be empty.
  static PlotScale linear(std::string title, const std::vector<double>& values);
  /// An axis from 0 to 100.
  static PlotScale percentages(std::string title);
  /// A logarithmic axis with bounds at 1, 2 or 5 times a power of ten around the positive values. A zero among the
  /// values has its own place at the left end.
  static PlotScale logarithmic(std::string title, const std::vector<double>& values);
  /// A logarithmic axis where the positive values span more than a factor of twenty, else a linear one from 0.
  static PlotScale fitting(std::string title, const std::vector<double>& values);
  /// An axis of categories. Value i is the middle of category i.
  static PlotScale categories(std::string title, const std::vector<std::string>& names);

  double position(double value) const;
  const std::vector<PlotTick>& ticks() const { return ticks_; }
  /// Ticks for an enlarged part of the axis, which may have room for more.
  std::vector<PlotTick> ticksWithin(double from, double to) const;
  const std::string& title() const { return title_; }
  bool isLogarithmic() const { return kind_ == Kind::Logarithmic; }
  bool isCategories() const { return kind_ == Kind::Categories; }
  /// Position of the break of a logarithmic axis with a zero; else 0.
  double breakPosition() const { return zeroWidth_ / 2.0; }

 private:
  enum class Kind { Linear, Logarithmic, Categories };

  void markLinear();
  void markLogarithmic();
  /// The value at a position, clamped to the axis.
  double valueAt(double position) const;
  std::vector<PlotTick> roundTicks(double low, double high) const;
  std::vector<PlotTick> powerTicks(double low, double high) const;

  Kind kind_ = Kind::Linear;
  std::string title_;
  double low_ = 0.0;  ///< lower bound; its logarithm for a logarithmic axis
  double high_ = 1.0;
  double zeroWidth_ = 0.0;  ///< share of the axis that is reserved for the zero
  std::vector<PlotTick> ticks_;
};

}  // namespace glissade
