#pragma once

#include <string>

namespace glissade {

/// This machine and build in words: "2 cores (Intel Xeon ...), 8 GB, Linux; built by GCC 12.2.0".
std::string describeMachine();

/// The libraries that we measure ourselves against, and build on: "OMPL 1.5.2, FCL 0.7.0, Eigen 3.4.0".
std::string describeLibraries();

}  // namespace glissade
