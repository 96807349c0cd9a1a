#pragma once

namespace glissade {

/// Resident memory of this process, in megabytes of 2^20 bytes (/proc/self/statm); 0 where it cannot be read.
double residentMegabytes();

/// Resident memory after free memory was returned to the system. The difference is unused memory, not a leak.
double residentMegabytesAfterTrim();

/// Memory that all threads have allocated and not freed, megabytes. If it grows, there is a leak or a growing value; if
/// only the resident memory grows, the allocator holds it.
double allocatedMegabytes();

/// Makes the allocator return freed memory to the system early, with few pools for all threads. For programs that run
/// for hours: otherwise every thread's pool keeps up to 64 MB unused. Call it before threads are started.
void giveFreedMemoryBack();

}  // namespace glissade
