// Writes the nut and the bolt of this sample.
//
// usage: generate-nut-and-bolt FOLDER
#include "samples/nut-and-bolt/shapes.h"
#include "samples/part_files.h"

int main(int argc, char** argv) {
  using namespace glissade::nut_and_bolt;
  if (argc != 2) {
    std::cerr << "usage: generate-nut-and-bolt FOLDER\n";
    return 2;
  }
  return glissade::samples::writeParts(argv[1], {{"bolt.obj", bolt()}, {"nut.obj", nut()}});
}
