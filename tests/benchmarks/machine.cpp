#include "tests/benchmarks/machine.h"

#include <fcl/config.h>
#include <ompl/config.h>
#include <sys/sysinfo.h>
#include <sys/utsname.h>

#include <Eigen/Core>
#include <cmath>
#include <fstream>
#include <thread>

namespace glissade {
namespace {

std::string processorName() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "";
}

std::string compilerName() {
#if defined(__clang__)
  return std::string("Clang ") + __clang_version__;
#else
  return std::string("GCC ") + __VERSION__;
#endif
}

}  // namespace

std::string describeMachine() {
  std::string text = std::to_string(std::thread::hardware_concurrency()) + " cores";
  const std::string processor = processorName();
  if (!processor.empty()) text += " (" + processor + ")";
  struct sysinfo memory {};
  if (sysinfo(&memory) == 0) {
    constexpr double kGiga = 1024.0 * 1024.0 * 1024.0;
    const double bytes = static_cast<double>(memory.totalram) * memory.mem_unit;
    text += ", " + std::to_string(std::lround(bytes / kGiga)) + " GB of memory";
  }
  struct utsname system {};
  if (uname(&system) == 0) text += std::string(", ") + system.sysname + " " + system.machine;
  return text + "; built by " + compilerName();
}

std::string describeLibraries() {
  const auto version = [](const char* name, int major, int minor, int patch) {
    return std::string(name) + " " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
  };
  return version("OMPL", OMPL_MAJOR_VERSION, OMPL_MINOR_VERSION, OMPL_PATCH_VERSION) + ", FCL " FCL_VERSION ", " +
         version("Eigen", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
}

}  // namespace glissade
