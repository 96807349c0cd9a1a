#pragma once

namespace glissade {

/// What this process has in main memory, in megabytes of 2^20 bytes (/proc/self/statm); 0 where it cannot be read.
double residentMegabytes();

/// The same after free memory was given back to the system. The difference is not in use, and no leak.
double residentMegabytesAfterTrim();

/// What the program has allocated and not freed, of all threads. What grows here is a leak or a growing value; what
/// grows in main memory only is the allocator's.
double allocatedMegabytes();

/// Has the allocator give freed memory back to the system soon, in a few pools for all threads. For programs that run
/// for hours: else every thread's pool keeps up to 64 MB that nobody uses. Call it before threads are started.
void giveFreedMemoryBack();

}  // namespace glissade
