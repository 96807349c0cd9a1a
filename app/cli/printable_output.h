#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace glissade::cli {

/// While an object of this class lives, everything that is written to the stream becomes printable text first
/// (printableText()). Names from files then cannot send control characters to the terminal, and a pipe receives valid
/// UTF-8.
class PrintableOutput final : private std::streambuf {
 public:
  explicit PrintableOutput(std::ostream& stream);
  ~PrintableOutput() override;
  /// Writes what is pending. Returns the errno of the first write that failed, or 0.
  int flush();
  PrintableOutput(const PrintableOutput&) = delete;
  PrintableOutput& operator=(const PrintableOutput&) = delete;

 private:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;
  bool writePending();
  bool noteError(bool written);

  std::ostream& stream_;
  std::streambuf* target_;
  std::string pending_;  ///< written to this buffer and not yet to the target
  int error_ = 0;        ///< errno of the first write that failed
};

}  // namespace glissade::cli
