// Writes the parts of this sample.
//
// usage: generate-bolted-brackets FOLDER
#include "samples/bolted-brackets/shapes.h"
#include "samples/part_files.h"

int main(int argc, char** argv) {
  using namespace glissade::bolted_brackets;
  if (argc != 2) {
    std::cerr << "usage: generate-bolted-brackets FOLDER\n";
    return 2;
  }
  return glissade::samples::writeParts(argv[1], {{"plate.obj", plate()},
                                                 {"bracket.obj", bracket()},
                                                 {"bolt.obj", bolt()},
                                                 {"nut.obj", nut()},
                                                 {"rod.obj", rod()}});
}
