#pragma once

#include <string>
#include <vector>

namespace glissade {

/// A mark on an axis; those between have no label.
struct PlotTick {
  double position = 0.0;  ///< 0 to 1 along the axis
  std::string label;
};

/// An axis: where a value lies on it, from 0 to 1, and its ticks. The report and the window draw from
/// the same scales, so that their plots are the same.
class PlotScale {
 public:
  /// Round bounds around the values, which may be none.
  static PlotScale linear(std::string title, const std::vector<double>& values);
  /// 0 to 100.
  static PlotScale percentages(std::string title);
  /// Bounds at 1, 2 or 5 times a power of ten around the positive values. A zero among them has a place
  /// of its own at the left of them.
  static PlotScale logarithmic(std::string title, const std::vector<double>& values);
  /// logarithmic where the positive values span more than a factor of twenty, else linear from 0.
  static PlotScale fitting(std::string title, const std::vector<double>& values);
  /// Value i is the middle of category i.
  static PlotScale categories(std::string title, const std::vector<std::string>& names);

  double position(double value) const;
  const std::vector<PlotTick>& ticks() const { return ticks_; }
  /// Ticks for a part of the axis that is shown enlarged, where there may be room for more.
  std::vector<PlotTick> ticksWithin(double from, double to) const;
  const std::string& title() const { return title_; }
  bool isLogarithmic() const { return kind_ == Kind::Logarithmic; }
  bool isCategories() const { return kind_ == Kind::Categories; }
  /// Of a logarithmic axis with a zero: where its break is; else 0.
  double breakPosition() const { return zeroWidth_ / 2.0; }

 private:
  enum class Kind { Linear, Logarithmic, Categories };

  void markLinear();
  void markLogarithmic();
  /// The value at a position; that of the axis' end where the position is beyond it.
  double valueAt(double position) const;
  std::vector<PlotTick> roundTicks(double low, double high) const;
  std::vector<PlotTick> powerTicks(double low, double high) const;

  Kind kind_ = Kind::Linear;
  std::string title_;
  double low_ = 0.0;  ///< of a logarithmic axis the logarithm
  double high_ = 1.0;
  double zeroWidth_ = 0.0;  ///< share of the axis that belongs to the zero
  std::vector<PlotTick> ticks_;
};

}  // namespace glissade
