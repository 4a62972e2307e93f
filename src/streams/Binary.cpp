#include "streams/Binary.h"

#include <cstdio>

namespace gt::cdr {

bool Reader::fail(std::string_view what) {
  error_ = Error{.what = std::string{what}};
  return false;
}

bool Reader::noValue(int number) {
  return fail(std::string("there is no value ").append(std::to_string(number)));
}

bool Reader::finish() {
  return left() < 4 || fail(std::to_string(left()).append(" bytes more than the value has"));
}

bool Reader::failedIn(std::string_view name) {
  if (!error_) error_.emplace();
  if (!error_->field.empty()) error_->field.insert(0, ".");
  error_->field.insert(0, name);
  return false;
}

bool Reader::failedIn(std::size_t index) {
  return failedIn(std::to_string(index));
}

bool getText(Reader& reader, std::string& text) {
  std::uint32_t length = 0;
  if (!getScalar(reader, length)) return false;
  if (length > reader.left()) return reader.fail("its length exceeds the data");
  // Some writers leave out the closing zero of an empty text.
  if (length == 0) {
    text.clear();
    return true;
  }
  const std::byte* bytes = reader.next();
  if (bytes[length - 1] != std::byte{0}) return reader.fail("the text has no end");
  text.assign(reinterpret_cast<const char*>(bytes), length - 1);
  return reader.skip(length);
}

Error headerError(std::span<const std::byte> bytes) {
  if (bytes.size() < headerSize) return {.what = "the data ends too early"};
  char begin[3 * headerSize];
  std::snprintf(begin, sizeof begin, "%02x %02x %02x %02x", std::to_integer<unsigned>(bytes[0]),
                std::to_integer<unsigned>(bytes[1]), std::to_integer<unsigned>(bytes[2]),
                std::to_integer<unsigned>(bytes[3]));
  return {.what = "begins with " + std::string{begin} +
                  "; expected little endian CDR, which begins with 00 01 00 00"};
}

}  // namespace gt::cdr
