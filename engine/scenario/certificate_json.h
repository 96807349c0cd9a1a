#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/collision/motion_certificate.h"

namespace glissade {

/// What a body is called in a report; its index in the world's obstacles is never -1.
using BodyNames = std::function<std::string(int)>;

const char* statusName(CertificateStatus status);
/// A certificate with its worst edge; lengths in metres, null where there is nothing near.
nlohmann::ordered_json certificateJson(const MotionCertificate& certificate, const BodyNames& names);
/// Every edge: the interval its smallest clearance lies in, where, and between which points of the
/// object and which body.
nlohmann::ordered_json edgesJson(const MotionCertificate& certificate, const BodyNames& names);

}  // namespace glissade
