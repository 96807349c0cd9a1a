#pragma once

// Includes OMPL: for the sources of this folder only.

#include <ompl/geometric/planners/prm/PRM.h>

#include "engine/planning/ompl/ompl_space.h"

namespace glissade {

/// OMPL's PRM without its clock and its second thread, which make each run different: growing and
/// expanding alternate by draws (2:1, as there by time), and the solution is looked for after each
/// piece. Lists isolated nodes, too.
class OmplPrm final : public ompl::geometric::PRM {
 public:
  OmplPrm(const ompl::base::SpaceInformationPtr& information, const OmplWorld& world)
      : PRM(information), world_(world) {}

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void clear() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

 private:
  void addRoots();
  void growPiece(const ompl::base::PlannerTerminationCondition& ptc);

  const OmplWorld& world_;
  std::uint64_t growDraws_ = 0;
  std::uint64_t expandDraws_ = 0;
};

}  // namespace glissade
