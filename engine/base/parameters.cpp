#include "engine/base/parameters.h"

#include <algorithm>
#include <cmath>

#include "engine/base/number_text.h"
#include "engine/base/tolerances.h"

namespace glissade {
namespace {

using Id = ParameterId;
using Scale = ParameterScale;

// The defaults of alpha, N and d are the ones that paper 1 uses when it varies the others (sections III.E and III.F); d
// = 0.1 r is its 0.15 m on the L.
constexpr std::array<ParameterSpec, kParameterCount> kTable{{
    {Id::Alpha, "alpha", "--alpha", "α", GLISSADE_TEXT("Computer share"), "", 0.0, 1.0, 0.2, Scale::Absolute, false,
     true,
     GLISSADE_TEXT("The computer's share of the iterations: 1 is the automatic planner alone, 0 the operator alone. "
                   "While the hand rests the computer goes on, except at 0 in the strategy With my hand.")},
    {Id::ContactSamples, "contact_samples", "--contact-samples", "N", GLISSADE_TEXT("Contact samples"), "", 1, 500, 10,
     Scale::Absolute, true, true,
     GLISSADE_TEXT("Samples drawn on the tangent plane each time contact mode is entered.")},
    {Id::ContactDistance, "contact_distance", "--contact-distance", "d", GLISSADE_TEXT("Contact distance"), "m", 0.0,
     1.0, 0.1, Scale::ObjectRadius, false, true,
     GLISSADE_TEXT("Closer than this to the nearest obstacle, contact mode begins.")},
    {Id::ContactRadius, "contact_radius", "--contact-radius", "", GLISSADE_TEXT("Contact disc"), "m", 0.01, 10.0, 1.3,
     Scale::ObjectRadius, false, true,
     GLISSADE_TEXT("Radius of the disc on the tangent plane in which contact samples are drawn.")},
    {Id::ContactGap, "contact_gap", "--contact-gap", "", GLISSADE_TEXT("Contact gap"), "m", 1e-4, 0.1,
     tolerance::kContactGap, Scale::ObjectRadius, false, false,
     GLISSADE_TEXT("Gap that contact samples keep to the surface, so that they touch without penetrating.")},
    {Id::RequiredClearance, "required_clearance", "--required-clearance", "", GLISSADE_TEXT("Required clearance"), "m",
     1e-7, 0.1, tolerance::kRequiredClearance, Scale::ObjectRadius, false, true,
     GLISSADE_TEXT("Clearance that a delivered path is certified to keep."), true},
    {Id::GrowthStep, "growth_step", "--growth-step", "", GLISSADE_TEXT("Growth step"), "m", 1e-4, 0.1,
     tolerance::kGrowthStep, Scale::ObjectRadius, false, false,
     GLISSADE_TEXT("Sampling step of edges while the trees grow (delivered edges are certified).")},
    {Id::ExtensionStep, "extension_step", "--extension-step", "", GLISSADE_TEXT("Extension step"), "m", 1e-3, 1.0,
     tolerance::kRandomExtensionStep, Scale::ObjectRadius, false, false,
     GLISSADE_TEXT("A blocked extension towards a random configuration ends at a multiple of this, off the obstacle.")},
    {Id::StepsPerSecond, "steps_per_second", "--steps-per-second", "", GLISSADE_TEXT("Steps per second"), "1/s", 1.0,
     1e6, 40.0, Scale::Absolute, false, false,
     GLISSADE_TEXT("Lockstep clock: planner steps in one second of the simulated or recorded operator.")},
    {Id::MaxSteps, "max_steps", "--max-steps", "", GLISSADE_TEXT("Step limit"), "", 0.0, 1e9, 0.0, Scale::Absolute,
     true, false, GLISSADE_TEXT("Stop after this many planner steps; 0 is no limit.")},
    {Id::MaxSamples, "max_samples", "--max-samples", "", GLISSADE_TEXT("Sample limit"), "", 0.0, 1e9, 0.0,
     Scale::Absolute, true, false, GLISSADE_TEXT("Stop after this many random configurations; 0 is no limit.")},
    {Id::TimeLimit, "time_limit", "--time-limit", "", GLISSADE_TEXT("Time limit"), "s", 0.0, 1e7, 0.0, Scale::Absolute,
     false, false, GLISSADE_TEXT("Stop after this many seconds of planning; 0 is no limit.")},
    {Id::GlobalSamples, "global_samples", "--global-samples", "", GLISSADE_TEXT("Samples of strategy G"), "", 1.0, 1e9,
     1e6, Scale::Absolute, true, false, GLISSADE_TEXT("Strategy G gives up after this many random configurations.")},
    {Id::StepSamples, "step_samples", "--step-samples", "", GLISSADE_TEXT("Samples a step"), "", 1.0, 1e9, 1e5,
     Scale::Absolute, true, false, GLISSADE_TEXT("A topological step fails after this many random configurations.")},
    {Id::BorderSamples, "border_samples", "--border-samples", "", GLISSADE_TEXT("Samples a border"), "", 1.0, 1e6,
     2000.0, Scale::Absolute, true, false,
     GLISSADE_TEXT("Random configurations drawn in a border to find its milestone.")},
    {Id::CoarsePaths, "coarse_paths", "--coarse-paths", "", GLISSADE_TEXT("Coarse paths"), "", 1.0, 1000.0, 12.0,
     Scale::Absolute, true, false,
     GLISSADE_TEXT("Coarse paths that a strategy with a loop tries before it searches the whole workspace only.")},
    {Id::Smoothing, "smoothing", "--smoothing", "", GLISSADE_TEXT("Smoothing"), "", 0.0, 1e6, 0.0, Scale::Absolute,
     true, false,
     GLISSADE_TEXT(
         "Shortcuts tried on the path found, each certified before it is taken; 0 leaves the path as planned.")},
    {Id::GuidanceRepulsion, "guidance_repulsion", "--guidance-repulsion", "", GLISSADE_TEXT("Repulsion"), "", 0.0, 1.0,
     0.5, Scale::Absolute, false, true,
     GLISSADE_TEXT("Guidance: how strongly obstacles nearer than the contact distance push the hand away; 0 is off.")},
    {Id::GuidanceAttraction, "guidance_attraction", "--guidance-attraction", "", GLISSADE_TEXT("Attraction"), "", 0.0,
     1.0, 0.3, Scale::Absolute, false, true,
     GLISSADE_TEXT("Guidance: how strongly the path or the next milestone draws the hand; 0 is off.")},
    {Id::OmplRange, "ompl_range", "--ompl-range", "", GLISSADE_TEXT("OMPL's range"), "", 0.0, 1.0, 0.0, Scale::Absolute,
     false, false,
     GLISSADE_TEXT(
         "Longest edge of the planners of unmodified OMPL, as a share of the space's extent; 0 is OMPL's default.")},
    {Id::OmplResolution, "ompl_resolution", "--ompl-resolution", "", GLISSADE_TEXT("OMPL's resolution"), "", 1e-5, 0.5,
     0.01, Scale::Absolute, false, false,
     GLISSADE_TEXT(
         "Distance of the configurations that the planners of unmodified OMPL check on an edge, as a share of "
         "the space's extent.")},
    {Id::Tuning, "tuning", "--tuning", "", GLISSADE_TEXT("Automatic tuning"), "", 0.0, 7.0, 0.0, Scale::Absolute, true,
     true,
     GLISSADE_TEXT("What sets itself while planning, added up: 1 for α, 2 for N, 4 for d. 0 is nothing, 7 all three.")},
    {Id::Slots, "lanes", "--lanes", "", GLISSADE_TEXT("Planners side by side"), "", 1.0, 32.0, 4.0, Scale::Absolute,
     true, false,
     GLISSADE_TEXT(
         "Planners of strategy auto that work at the same time, on as many of the machine's cores. Another number is "
         "another search; the cores do not change it.")},
    {Id::Pace, "pace", "--pace", "", GLISSADE_TEXT("Pace"), "1/s", 0.0, 10000.0, 0.0, Scale::Absolute, false, true,
     GLISSADE_TEXT("In the window: planner steps a second, so that a person can watch and steer. 0 is full speed; the "
                   "first paper's planner made 40.")},
}};

Diagnostic outOfRange(const ParameterSpec& spec, double value, const ParameterRange& range) {
  const CatalogueText number = spec.integer ? GLISSADE_TEXT("a whole number") : GLISSADE_TEXT("a number");
  const std::string most = shortText(range.maximum) + (spec.unit.empty() ? "" : " ") + std::string(spec.unit);
  return {ErrorKind::Usage,
          "",
          std::string(spec.key),
          {GLISSADE_TEXT("%1 is %2, which is not allowed"), {spec.label, shortText(value)}},
          {GLISSADE_TEXT("Give %1 from %2 to %3."), {number, shortText(range.minimum), most}}};
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
