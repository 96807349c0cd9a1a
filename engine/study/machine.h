#pragma once

#include <string>

namespace glissade {

/// This machine and build in words: "2 cores (Intel Xeon ...), 8 GB, Linux; built by GCC 12.2.0".
std::string describeMachine();

}  // namespace glissade
