#include <string>

#include "engine/import/import_service.h"

/// glissade-import ENDING: a mesh on standard input to plain arrays on standard output. Started by
/// the other programs, once for each mesh file.
int main(int argc, char** argv) { return glissade::serveImport(argc == 2 ? argv[1] : std::string()); }
