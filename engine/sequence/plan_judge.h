#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/collision/motion_certificate.h"
#include "engine/sequence/assembled_product.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// What the independent check says about a step.
struct StepJudgement {
  std::string body;
  MotionCertificate certificate;  ///< names bodies by their index in the product
  bool endsOutside = false;       ///< the body ends clear of the bounding box of the others
  bool allowancesAsFits = false;  ///< the step allows for no more than the fits of the product do
  /// What of the plan's demands the step does not keep, and does not say so; empty: nothing. For people, with names.
  std::string againstDemand{};

  bool valid() const {
    return certificate.status == CertificateStatus::Certified && endsOutside && allowancesAsFits &&
           againstDemand.empty();
  }
};

/// Judges every step by IndependentCheck, each of its bodies along the common motion: against all bodies but those of
/// steps that have to be carried out before, so that every order that keeps AssemblyStep::after is judged. Bodies are
/// taken as thin as their fits allow. Steps are judged by all cores. Shares with planners the meshes and the definition
/// of fits alone. `required`: clearance, metres; nothing: the usual one for the size of each body. Precondition: the
/// plan is about this product. Errors: as of findObjectFits(); demands of the plan as of resolved(); Interrupted.
Result<std::vector<StepJudgement>> judgePlan(const AssemblyPlan& plan, const AssembledProduct& product,
                                             std::optional<double> required, const StopToken& stop = {});

}  // namespace glissade
