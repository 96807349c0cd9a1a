#include "app/cli/printable_output.h"

#include <cerrno>

#include "engine/base/printable_text.h"

namespace glissade::cli {

PrintableOutput::PrintableOutput(std::ostream& stream) : stream_(stream), target_(stream.rdbuf(this)) {}

PrintableOutput::~PrintableOutput() {
  writePending();
  target_->pubsync();
  stream_.rdbuf(target_);
}

PrintableOutput::int_type PrintableOutput::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
  const char c = traits_type::to_char_type(character);
  return xsputn(&c, 1) == 1 ? character : traits_type::eof();
}

/// Converts whole lines, so that no character is cut in two.
std::streamsize PrintableOutput::xsputn(const char* text, std::streamsize size) {
  constexpr std::size_t kMostPending = 1U << 16;
  pending_.append(text, static_cast<std::size_t>(size));
  const bool lineEnds = size > 0 && text[size - 1] == '\n';
  if ((lineEnds || pending_.size() > kMostPending) && !writePending()) return 0;
  return size;
}

int PrintableOutput::sync() { return writePending() && noteError(target_->pubsync() == 0) ? 0 : -1; }

int PrintableOutput::flush() {
  (void)sync();
  return error_;
}

bool PrintableOutput::noteError(bool written) {
  if (!written && error_ == 0) error_ = errno;
  return written;
}

bool PrintableOutput::writePending() {
  const std::string shown = printableText(pending_);
  pending_.clear();
  const auto size = static_cast<std::streamsize>(shown.size());
  return noteError(target_->sputn(shown.data(), size) == size);
}

}  // namespace glissade::cli
