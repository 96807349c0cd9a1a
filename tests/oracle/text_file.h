#pragma once

#include <fstream>
#include <string>

namespace glissade::oracle {

inline void writeText(const std::string& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace glissade::oracle
