#include "tests/oracle/campaign_row.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace glissade::oracle {

void printRow(const std::string& name, std::uint64_t tried, std::uint64_t defects, std::uint64_t seed) {
  double seconds = 0.0;
  long kilobytes = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
    kilobytes = std::max(kilobytes, usage.ru_maxrss);
  }
  std::cout << name << " | " << tried << " | " << tried - defects << " | " << defects << " | " << std::lround(seconds)
            << " | " << kilobytes / 1024 << " | " << seed << std::endl;
}

}  // namespace glissade::oracle
