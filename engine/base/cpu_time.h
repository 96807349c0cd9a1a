#pragma once

namespace glissade {

/// Processor time of the calling thread, seconds.
double threadCpuSeconds();

}  // namespace glissade
