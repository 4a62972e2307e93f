// All that the stream classes read: text, config files and their sections, binary by the fields.
#include "streams/Streams.h"

#include "Fuzz.h"
#include "debug/Drawing.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/perception/LandmarksPercept.h"

namespace {

template <typename T>
void readAll(std::string_view text) {
  T value;
  gt::InTextMemory asText{text};
  gt::InConfigMemory asConfig{text};
  gt::InConfigMemory section{text, "section"};
  gt::InBinaryMemory binary{text};
  for (gt::In* in : std::initializer_list<gt::In*>{&asText, &asConfig, &section, &binary})
    while (*in && !in->eof()) *in >> value;
  // What was read can be written, and is the same when it is read again.
  gt::OutTextMemory out;
  out << value;
  gt::InTextMemory in{out.text()};
  T again;
  in >> again;
  gt::OutTextMemory outAgain;
  outAgain << again;
  if (!in || outAgain.text() != out.text()) __builtin_trap();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = gt::textOf(data, size);
  readAll<gt::Drawing>(text);
  readAll<gt::LandmarksPercept>(text);
  readAll<gt::TeamMessages>(text);
  return 0;
}
