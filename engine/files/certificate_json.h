#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/base/enum_names.h"
#include "engine/collision/motion_certificate.h"

namespace glissade {

/// Names of bodies in a report, by the index in the world's obstacles, which is never -1.
using BodyNames = std::function<std::string(int)>;

inline constexpr EnumNames<CertificateStatus, 3> kCertificateStatusNames{{"certified", "violated", "undecided"}};

/// A certificate with its worst edge; lengths in metres, null where no obstacle is near.
nlohmann::ordered_json certificateJson(const MotionCertificate& certificate, const BodyNames& names);
/// Every edge: the interval of its smallest clearance, its place, the nearest points, and the obstacle.
nlohmann::ordered_json edgesJson(const MotionCertificate& certificate, const BodyNames& names);

}  // namespace glissade
