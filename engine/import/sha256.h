#pragma once

#include <string>
#include <string_view>

namespace glissade {

/// SHA-256 of the content in 64 lower-case hexadecimal digits (OpenSSL's libcrypto).
std::string sha256(std::string_view content);

}  // namespace glissade
