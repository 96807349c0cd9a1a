// Writes the bodies of this sample.
//
// usage: generate-puzzles FOLDER
#include "samples/part_files.h"
#include "samples/puzzles/shapes.h"

int main(int argc, char** argv) {
  using namespace glissade::puzzles;
  if (argc != 2) {
    std::cerr << "usage: generate-puzzles FOLDER\n";
    return 2;
  }
  return glissade::samples::writeParts(
      argv[1], {{"bent-bar.obj", bentBar()}, {"burr-block.obj", burrBlock()}, {"burr-piece.obj", burrPiece()}});
}
