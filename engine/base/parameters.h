#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace glissade {

/// The list of all parameters that a user may set. The order is that of `parameterTable()`.
enum class ParameterId : std::size_t {
  Alpha,
  ContactSamples,
  ContactDistance,
  ContactRadius,
  ContactGap,
  RequiredClearance,
  GrowthStep,
  ExtensionStep,
  StepsPerSecond,
  MaxSteps,
  MaxSamples,
  TimeLimit,
  GlobalSamples,
  StepSamples,
  BorderSamples,
  CoarsePaths,
  Smoothing,
  GuidanceRepulsion,
  GuidanceAttraction,
  OmplRange,
  OmplResolution,
  Tuning,
  Slots,
  Pace,
  Count
};
inline constexpr std::size_t kParameterCount = static_cast<std::size_t>(ParameterId::Count);

/// Lengths may be given relative to the object's radius r in the table, so that defaults and slider ranges suit objects
/// of any size. The values themselves are always metres.
enum class ParameterScale { Absolute, ObjectRadius };

/// One row of the table that drives sliders, scenario files, the command line and the help.
struct ParameterSpec {
  ParameterId id;
  std::string_view key;     ///< key in scenario files, scripts and run records: "contact_distance"
  std::string_view option;  ///< option of the command line: "--contact-distance"
  std::string_view symbol;  ///< symbol in the paper: "d"; may be empty
  CatalogueText label;      ///< name in the window: "Contact distance"
  std::string_view unit;    ///< unit: "", "m", "s", "1/s"
  double minimum;           ///< inclusive, in units of `scale`
  double maximum;           ///< inclusive, in units of `scale`
  double defaultValue;      ///< in units of `scale`
  ParameterScale scale;
  bool integer;
  bool live;  ///< may change while a planner runs (a slider in the window)
  CatalogueText help;
  bool roundDefault = false;  ///< the default is 1, 2 or 5 times a power of ten, at most defaultValue
};

const std::array<ParameterSpec, kParameterCount>& parameterTable();
const ParameterSpec& specOf(ParameterId id);
std::optional<ParameterId> parameterByKey(std::string_view key);

/// Range of a parameter for an object of the given radius, in the parameter's own unit.
struct ParameterRange {
  double minimum;
  double maximum;
};
ParameterRange rangeOf(ParameterId id, double objectRadius);

/// A value for every parameter; always within range.
class ParameterValues {
 public:
  /// The defaults for an object of the given radius (metres).
  explicit ParameterValues(double objectRadius);

  double operator[](ParameterId id) const { return values_[static_cast<std::size_t>(id)]; }
  int integer(ParameterId id) const;
  double objectRadius() const { return radius_; }

  /// Refuses (ErrorKind::Usage, naming parameter and range) what is not finite, out of range, or
  /// not a whole number where one is asked for.
  Outcome set(ParameterId id, double value);

  friend bool operator==(const ParameterValues&, const ParameterValues&) = default;

 private:
  double radius_;
  std::array<double, kParameterCount> values_{};
};

}  // namespace glissade
