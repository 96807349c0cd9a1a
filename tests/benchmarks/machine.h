#pragma once

#include <string>

namespace glissade {

/// Describes this machine and build: "2 cores (Intel Xeon ...), 8 GB, Linux; built by GCC 12.2.0".
std::string describeMachine();

/// Describes the libraries for comparison and for the implementation: "OMPL 1.5.2, FCL 0.7.0, Eigen 3.4.0".
std::string describeLibraries();

}  // namespace glissade
