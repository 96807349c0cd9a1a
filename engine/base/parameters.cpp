#include "engine/base/parameters.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/base/tolerances.h"

namespace glissade {
namespace {

using Id = ParameterId;
using Scale = ParameterScale;

// The defaults of alpha, N and d are the ones that paper 1 uses when it varies the others (sections III.E and III.F); d
// = 0.1 r is its 0.15 m on the L.
constexpr std::array<ParameterSpec, kParameterCount> kTable{{
    {Id::Alpha, "alpha", "--alpha", "α", "Authority", "", 0.0, 1.0, 0.2, Scale::Absolute, false, true,
     "The computer's share of the iterations: 1 is the automatic planner alone, 0 the operator alone."},
    {Id::ContactSamples, "contact_samples", "--contact-samples", "N", "Contact samples", "", 1, 500, 10,
     Scale::Absolute, true, true, "Samples shot on the tangent plane each time contact mode is entered."},
    {Id::ContactDistance, "contact_distance", "--contact-distance", "d", "Contact distance", "m", 0.0, 1.0, 0.1,
     Scale::ObjectRadius, false, true, "Closer than this to the nearest obstacle, contact mode begins."},
    {Id::ContactRadius, "contact_radius", "--contact-radius", "", "Contact disc", "m", 0.01, 10.0, 1.3,
     Scale::ObjectRadius, false, true, "Radius of the disc on the tangent plane in which contact samples are shot."},
    {Id::ContactGap, "contact_gap", "--contact-gap", "", "Contact gap", "m", 1e-4, 0.1, tolerance::kContactGap,
     Scale::ObjectRadius, false, false,
     "Gap that contact samples keep to the surface, so that they touch without penetrating."},
    {Id::RequiredClearance, "required_clearance", "--required-clearance", "", "Required clearance", "m", 1e-7, 0.1,
     tolerance::kRequiredClearance, Scale::ObjectRadius, false, true,
     "Clearance that a delivered path is proved to keep.", true},
    {Id::GrowthStep, "growth_step", "--growth-step", "", "Growth step", "m", 1e-4, 0.1, tolerance::kGrowthStep,
     Scale::ObjectRadius, false, false, "Sampling step of edges while the trees grow (delivered edges are certified)."},
    {Id::ExtensionStep, "extension_step", "--extension-step", "", "Extension step", "m", 1e-3, 1.0,
     tolerance::kRandomExtensionStep, Scale::ObjectRadius, false, false,
     "A blocked extension towards a random configuration ends at a multiple of this, off the obstacle."},
    {Id::StepsPerSecond, "steps_per_second", "--steps-per-second", "", "Steps per second", "1/s", 1.0, 1e6, 40.0,
     Scale::Absolute, false, false,
     "Lockstep clock: planner steps in one second of the simulated or recorded operator."},
    {Id::MaxSteps, "max_steps", "--max-steps", "", "Step limit", "", 0.0, 1e9, 0.0, Scale::Absolute, true, false,
     "Stop after this many planner steps; 0 is no limit."},
    {Id::MaxSamples, "max_samples", "--max-samples", "", "Sample limit", "", 0.0, 1e9, 0.0, Scale::Absolute, true,
     false, "Stop after this many random configurations; 0 is no limit."},
    {Id::TimeLimit, "time_limit", "--time-limit", "", "Time limit", "s", 0.0, 1e7, 0.0, Scale::Absolute, false, false,
     "Stop after this many seconds of planning; 0 is no limit."},
    {Id::GlobalSamples, "global_samples", "--global-samples", "", "Samples of strategy G", "", 1.0, 1e9, 1e6,
     Scale::Absolute, true, false, "Strategy G gives up after this many random configurations."},
    {Id::StepSamples, "step_samples", "--step-samples", "", "Samples a step", "", 1.0, 1e9, 1e5, Scale::Absolute, true,
     false, "A topological step fails after this many random configurations."},
    {Id::BorderSamples, "border_samples", "--border-samples", "", "Samples a border", "", 1.0, 1e6, 2000.0,
     Scale::Absolute, true, false, "Random configurations drawn in a border to find its milestone."},
    {Id::CoarsePaths, "coarse_paths", "--coarse-paths", "", "Coarse paths", "", 1.0, 1000.0, 12.0, Scale::Absolute,
     true, false, "Coarse paths that a strategy with a loop tries before it searches the whole workspace only."},
    {Id::Smoothing, "smoothing", "--smoothing", "", "Smoothing", "", 0.0, 1e6, 0.0, Scale::Absolute, true, false,
     "Shortcuts tried on the path found, each certified before it is taken; 0 leaves the path as planned."},
    {Id::GuidanceRepulsion, "guidance_repulsion", "--guidance-repulsion", "", "Repulsion", "", 0.0, 1.0, 0.5,
     Scale::Absolute, false, true,
     "Guidance: how strongly obstacles nearer than the contact distance push the hand away; 0 is off."},
    {Id::GuidanceAttraction, "guidance_attraction", "--guidance-attraction", "", "Attraction", "", 0.0, 1.0, 0.3,
     Scale::Absolute, false, true, "Guidance: how strongly the path or the next milestone draws the hand; 0 is off."},
    {Id::OmplRange, "ompl_range", "--ompl-range", "", "OMPL's range", "", 0.0, 1.0, 0.0, Scale::Absolute, false, false,
     "Longest edge of the planners of unmodified OMPL, as a share of the space's extent; 0 is OMPL's default."},
    {Id::OmplResolution, "ompl_resolution", "--ompl-resolution", "", "OMPL's resolution", "", 1e-5, 0.5, 0.01,
     Scale::Absolute, false, false,
     "Distance of the configurations that the planners of unmodified OMPL check on an edge, as a share of the space's "
     "extent."},
    {Id::Tuning, "tuning", "--tuning", "", "Automatic tuning", "", 0.0, 7.0, 0.0, Scale::Absolute, true, true,
     "What sets itself while planning, added up: 1 for α, 2 for N, 4 for d. 0 is nothing, 7 all three."},
    {Id::Slots, "lanes", "--lanes", "", "Planners side by side", "", 1.0, 32.0, 4.0, Scale::Absolute, true, false,
     "Planners of strategy auto that work at the same time, on as many of the machine's cores. Another number is "
     "another search; the cores do not change it."},
    {Id::Pace, "pace", "--pace", "", "Pace", "1/s", 0.0, 10000.0, 0.0, Scale::Absolute, false, true,
     "In the window: planner steps a second, so that a person can watch and steer. 0 is full speed; the first paper's "
     "planner made 40."},
}};

Diagnostic outOfRange(const ParameterSpec& spec, double value, const ParameterRange& range) {
  std::ostringstream reason;
  reason << spec.label << " is " << value << ", which is not allowed";
  std::ostringstream advice;
  advice << "Give " << (spec.integer ? "a whole number" : "a number") << " from " << range.minimum << " to "
         << range.maximum << (spec.unit.empty() ? "" : " ") << spec.unit << ".";
  return {ErrorKind::Usage, "", std::string(spec.key), reason.str(), advice.str()};
}

/// The largest of 1, 2 and 5 times a power of ten that is not above the value, as a person would write it. A value that
/// is below such a number only by rounding counts as that number. For 0 and values that are not finite: the value
/// itself.
double roundNumberBelow(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return value;
  const double most = value * (1.0 + 1e-9);
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  double best = decade;
  for (const double digit : {2.0, 5.0}) {
    if (digit * decade <= most) best = digit * decade;
  }
  return best;
}

}  // namespace

const std::array<ParameterSpec, kParameterCount>& parameterTable() { return kTable; }

const ParameterSpec& specOf(ParameterId id) { return kTable[static_cast<std::size_t>(id)]; }

std::optional<ParameterId> parameterByKey(std::string_view key) {
  const auto found = std::find_if(kTable.begin(), kTable.end(), [&](const auto& spec) { return spec.key == key; });
  if (found == kTable.end()) return std::nullopt;
  return found->id;
}

ParameterRange rangeOf(ParameterId id, double objectRadius) {
  const ParameterSpec& spec = specOf(id);
  const double unit = spec.scale == Scale::ObjectRadius ? objectRadius : 1.0;
  return {spec.minimum * unit, spec.maximum * unit};
}

ParameterValues::ParameterValues(double objectRadius) : radius_(objectRadius) {
  for (const ParameterSpec& spec : kTable) {
    const double unit = spec.scale == Scale::ObjectRadius ? objectRadius : 1.0;
    const double value = spec.defaultValue * unit;
    values_[static_cast<std::size_t>(spec.id)] = spec.roundDefault ? roundNumberBelow(value) : value;
  }
}

int ParameterValues::integer(ParameterId id) const { return static_cast<int>(std::lround((*this)[id])); }

Outcome ParameterValues::set(ParameterId id, double value) {
  const ParameterSpec& spec = specOf(id);
  const ParameterRange range = rangeOf(id, radius_);
  const bool inRange = std::isfinite(value) && value >= range.minimum && value <= range.maximum;
  const bool whole = !spec.integer || value == std::floor(value);
  if (!inRange || !whole) return outOfRange(spec, value, range);
  values_[static_cast<std::size_t>(id)] = value;
  return Done{};
}

}  // namespace glissade
