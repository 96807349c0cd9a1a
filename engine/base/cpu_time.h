#pragma once

namespace glissade {

/// What the calling thread has had of the processor, in seconds.
double threadCpuSeconds();

}  // namespace glissade
