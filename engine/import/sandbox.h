#pragma once

namespace glissade {

/// Gives up, for good, everything the importing process does not need: address space beyond 500 MB,
/// more than `cpuSeconds` of computing, core dumps, and every system call but those for memory and
/// for reading and writing open files (so it can open no file and reach no network). Ends with its
/// parent. Returns false where the system refuses.
bool enterSandbox(unsigned cpuSeconds);

}  // namespace glissade
