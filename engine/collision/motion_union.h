#pragma once

#include <algorithm>

#include "engine/collision/collision_query.h"

namespace glissade {

/// Result for a motion without obstacles.
inline MotionCheck certifiedMotion() { return {CertificateStatus::Certified, 1.0, 1.0, 0}; }

/// Combines the results for two sets of obstacles.
inline void unite(MotionCheck& united, const MotionCheck& check) {
  united.configurations += check.configurations;
  united.certified = std::min(united.certified, check.certified);
  if (check.status == CertificateStatus::Violated) {
    united.at = united.status == CertificateStatus::Violated ? std::min(united.at, check.at) : check.at;
    united.status = CertificateStatus::Violated;
  } else if (check.status == CertificateStatus::Undecided && united.status == CertificateStatus::Certified) {
    united.status = CertificateStatus::Undecided;
  }
}

}  // namespace glissade
