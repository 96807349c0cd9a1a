#pragma once

#include <optional>
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

  bool valid() const { return certificate.status == CertificateStatus::Certified && endsOutside && allowancesAsFits; }
};

/// Judges every step by IndependentCheck, against the bodies that are there at that step; the moving body is taken as
/// thin as its fits allow. Shares with planners the meshes and the definition of fits alone. `required`: clearance,
/// metres; nothing: the usual one for the size of each body. Precondition: the plan is about this product.
/// Errors: as of findObjectFits(); Interrupted.
Result<std::vector<StepJudgement>> judgePlan(const AssemblyPlan& plan, const AssembledProduct& product,
                                             std::optional<double> required, const StopToken& stop = {});

}  // namespace glissade
