#pragma once

#include <algorithm>

#include "engine/collision/collision_query.h"

namespace glissade {

/// What is known of a motion past nothing.
inline MotionCheck certifiedMotion() { return {CertificateStatus::Certified, 1.0, 1.0, 0}; }

/// Adds what was found about some of the obstacles to what is known of the others.
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
