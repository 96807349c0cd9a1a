#include "engine/sequence/work_times.h"

#include <algorithm>
#include <cmath>

#include "engine/sequence/solid_mass.h"
#include "engine/sequence/standing.h"

namespace glissade {
namespace {

constexpr double kHour = 3600.0;

/// Computes the times of steps.
class StepTimer {
 public:
  StepTimer(const AssemblyPlan& plan, const AssembledProduct& product, const WorkTimes& times)
      : product_(product),
        times_(times),
        masses_(massesOf(plan.demands, product)),
        densities_(densitiesOf(plan.demands, product)) {}

  StepTime timeOf(const AssemblyStep& step, const AssemblyStep* before) const {
    StepTime time;
    for (const StepMotion& motion : step.motions) {
      time.fetch += fetchOf(motion);
      time.place += placeOf(motion);
      time.turn += turnOf(motion);
    }
    time.hold = times_.hold * static_cast<double>(step.falling().size());
    const ToolKind tool = step.opening().tool.kind;
    if (tool != ToolKind::None && (before == nullptr || before->opening().tool.kind != tool))
      time.tool = times_.toolChange;
    return time;
  }

 private:
  /// Bodies that come as a group are fetched as one part.
  double fetchOf(const StepMotion& motion) const {
    double mass = 0.0;
    Box3 box;
    for (const std::size_t body : product_.indicesOf(motion.bodies())) {
      const RigidBody& rigid = product_.bodies[body];
      mass += masses_[body] > 0.0 ? masses_[body] : densities_[body] * solidMass(*rigid.mesh).volume;
      box.extend(boundingBox(*rigid.mesh, rigid.X_WB));
    }
    const double longest = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
    if (mass > times_.aidAbove) return times_.fetchWithAid;
    if (mass > times_.twoHandsAbove || longest > times_.largeAbove) return times_.fetchLarge;
    return longest < times_.smallBelow ? times_.fetchSmall : times_.fetch;
  }

  /// A body that is turned is placed at its thread without a fit.
  double placeOf(const StepMotion& motion) const {
    if (turnsOf(motion) > 0.0) return times_.place;
    if (comesApart(motion, JointKind::Flexible)) return times_.lay;
    if (comesApart(motion, JointKind::Insert)) return times_.press;
    if (motion.path.size() > 2) return times_.placeLed;
    return motion.allowances.empty() ? times_.place : times_.placeAligned;
  }

  static bool comesApart(const StepMotion& motion, JointKind kind) {
    return std::any_of(motion.joints.begin(), motion.joints.end(),
                       [&](const StepJoint& each) { return each.kind == kind; });
  }

  double turnOf(const StepMotion& motion) const {
    const double turns = turnsOf(motion);
    if (turns == 0.0) return 0.0;
    const bool powered = motion.tool.kind != ToolKind::None && motion.tool.kind != ToolKind::OpenWrench;
    return times_.startThread + turns * (powered ? times_.turn : times_.turnByHand);
  }

  static double turnsOf(const StepMotion& motion) {
    double turns = 0.0;
    for (const Allowance& each : motion.allowances) turns = std::max(turns, std::abs(each.turns));
    for (const StepJoint& each : motion.joints) turns = std::max(turns, each.turns);
    return turns;
  }

  const AssembledProduct& product_;
  const WorkTimes& times_;
  std::vector<double> masses_;
  std::vector<double> densities_;
};

}  // namespace

const std::vector<WorkTimeRow>& workTimeRows() {
  static const std::vector<WorkTimeRow> rows{
      {"small_below_m", &WorkTimes::smallBelow, 1.0, GLISSADE_TEXT("a part is small below this length")},
      {"large_above_m", &WorkTimes::largeAbove, 100.0, GLISSADE_TEXT("a part is large above this length")},
      {"two_hands_above_kg", &WorkTimes::twoHandsAbove, 1000.0,
       GLISSADE_TEXT("a heavier part is handled as a large one")},
      {"aid_above_kg", &WorkTimes::aidAbove, 1000.0, GLISSADE_TEXT("a heavier part needs a lifting aid")},
      {"fetch_s", &WorkTimes::fetch, kHour, GLISSADE_TEXT("fetch a part")},
      {"fetch_small_s", &WorkTimes::fetchSmall, kHour, GLISSADE_TEXT("fetch a small part")},
      {"fetch_large_s", &WorkTimes::fetchLarge, kHour, GLISSADE_TEXT("fetch a large part with both hands")},
      {"fetch_with_aid_s", &WorkTimes::fetchWithAid, kHour, GLISSADE_TEXT("fetch a part with a lifting aid")},
      {"place_s", &WorkTimes::place, kHour, GLISSADE_TEXT("place a part along a straight path")},
      {"place_aligned_s", &WorkTimes::placeAligned, kHour, GLISSADE_TEXT("place a part into a fit")},
      {"place_led_s", &WorkTimes::placeLed, kHour, GLISSADE_TEXT("place a part along a path with turns")},
      {"press_s", &WorkTimes::press, kHour, GLISSADE_TEXT("press a part into its seat")},
      {"lay_s", &WorkTimes::lay, kHour, GLISSADE_TEXT("lay a flexible part on")},
      {"start_thread_s", &WorkTimes::startThread, kHour, GLISSADE_TEXT("start a thread")},
      {"turn_s", &WorkTimes::turn, kHour, GLISSADE_TEXT("one turn with a powered tool")},
      {"turn_by_hand_s", &WorkTimes::turnByHand, kHour, GLISSADE_TEXT("one turn by hand or with an open wrench")},
      {"tool_change_s", &WorkTimes::toolChange, kHour, GLISSADE_TEXT("take another tool")},
      {"hold_s", &WorkTimes::hold, kHour, GLISSADE_TEXT("hold one body meanwhile")},
  };
  return rows;
}

bool isEdited(const WorkTimes& times, const WorkTimeRow& row) { return times.*row.value != WorkTimes().*row.value; }

std::size_t editedCount(const WorkTimes& times) {
  const auto& rows = workTimeRows();
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [&](const WorkTimeRow& row) { return isEdited(times, row); }));
}

std::vector<StepTime> stepTimes(const AssemblyPlan& plan, const AssembledProduct& product, const WorkTimes& times) {
  const StepTimer timer(plan, product, times);
  std::vector<StepTime> all;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const bool isFirst = i + 1 == plan.steps.size();
    all.push_back(timer.timeOf(plan.steps[i], isFirst ? nullptr : &plan.steps[i + 1]));
  }
  return all;
}

}  // namespace glissade
