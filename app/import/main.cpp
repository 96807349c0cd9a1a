// glissade-import: reads one mesh from standard input and writes plain arrays to standard output.
// It runs with little memory and time and cannot open a file, so a malformed mesh can do no harm.
// usage: glissade-import ENDING < FILE
//        glissade-import several < FILES (import_protocol.h)
#include <unistd.h>

#include <iostream>

#include "engine/import/confined_import.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: glissade-import ENDING < FILE\n";
    return 2;
  }
  // No return from main(): nothing may run after the process has given up its rights.
  ::_exit(glissade::confinedImport(argv[1]));
}
