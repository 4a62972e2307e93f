#include "streams/Streams.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "streams/Binary.h"
#include "streams/File.h"

namespace gt {
namespace {

constexpr std::string_view escaped{" \\\"\n\t\r\0", 7};
constexpr std::string_view escapes{" \\\"ntr0", 7};

bool isBlank(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/// The size of a number, enumeration or boolean in a binary stream.
std::size_t binarySize(const Type& type) {
  return type.kind == Kind::number ? numberSize(type.number) : 1;
}

/// The least number of entries that a value takes in any format.
std::size_t leastEntries(const Type& type) {
  if (type.kind == Kind::array) return type.count * leastEntries(type.element());
  if (type.kind != Kind::record) return 1;
  std::size_t n = 0;
  for (const Part& p : type.parts) n += leastEntries(p.type());
  return n;
}

Error wrong(std::string what, int line = 0) {
  return {.line = line, .what = std::move(what)};
}

Error in(Error error, std::string_view name) {
  error.field = std::string(name) + (error.field.empty() ? "" : "." + error.field);
  return error;
}

}  // namespace

void OutFile::writeToStream(std::span<const std::byte> bytes) {
  file_.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
}

Result<void> OutFile::close() {
  const bool good = file_.is_open() && file_.good();
  file_.close();
  if (good && file_) return {};
  return Error{.file = path_, .what = "cannot be written"};
}

void OutMemory::writeToStream(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

InFile::InFile(const std::string& path) {
  auto content = readFile(path);
  if (content)
    content_ = std::move(*content);
  else
    source_ = content.error();
  source_.file = path;
}

void OutBinary::put(std::span<const std::byte> bytes, std::size_t alignment,
                    PhysicalOutStream& medium) {
  constexpr std::byte padding[8]{};
  if (!begun_) medium.writeToStream(cdr::header);
  begun_ = true;
  const std::size_t gap = (~size_ + 1) & (alignment - 1);
  medium.writeToStream(std::span{padding}.first(gap));
  medium.writeToStream(bytes);
  size_ += gap + bytes.size();
}

void OutBinary::writeScalar(ConstValue scalar, PhysicalOutStream& medium) {
  const Type& type = scalar.type();
  if (type.kind == Kind::text) {
    const auto& text = *static_cast<const std::string*>(scalar.data());
    const auto length = static_cast<std::uint32_t>(text.size() + 1);
    put(std::as_bytes(std::span{&length, 1}), sizeof length, medium);
    put(std::as_bytes(std::span{text.c_str(), length}), 1, medium);
  } else if (type.kind == Kind::number) {
    const std::size_t size = binarySize(type);
    put({static_cast<const std::byte*>(scalar.data()), size}, size, medium);
  } else {
    const auto number = static_cast<std::uint8_t>(ordinal(scalar));
    put(std::as_bytes(std::span{&number, 1}), 1, medium);
  }
}

void OutText::writeScalar(ConstValue scalar, PhysicalOutStream& medium) {
  std::string entry = lineBegins_ ? "" : " ";
  lineBegins_ = false;
  const std::string text = scalarText(scalar);
  if (text.empty()) entry += "\"\"";
  for (const char c : text) {
    const auto i = escaped.find(c);
    if (i != escaped.npos) entry += '\\';
    entry += i == escaped.npos ? c : escapes[i];
  }
  medium.writeToStream(std::as_bytes(std::span{entry}));
}

void OutText::writeEndLine(PhysicalOutStream& medium) {
  medium.writeToStream(std::as_bytes(std::span{"\n", 1}));
  lineBegins_ = true;
}

bool InBinary::take(void* data, std::size_t size) {
  if (at_ == 0) at_ = std::min(content_.size(), cdr::headerSize);
  const std::size_t gap =
      (size & (size - 1)) == 0 && size <= 8 ? (~(at_ - cdr::headerSize) + 1) & (size - 1) : 0;
  if (left() < gap || left() - gap < size) return false;
  std::memcpy(data, content_.data() + at_ + gap, size);
  at_ += gap + size;
  return true;
}

Result<void> InBinary::readScalar(Value scalar) {
  if (at_ == 0 && !cdr::isHeaded(content_)) return cdr::headerError(content_);
  const Type& type = *scalar.type;
  std::byte bytes[8]{};
  if (type.kind == Kind::text) {
    std::uint32_t length = 0;
    if (!take(&length, sizeof length) || length > left()) return wrong("the data ends too early");
    const auto* text = reinterpret_cast<const char*>(content_.data() + at_);
    if (length > 0 && text[length - 1] != '\0') return wrong("the text has no end");
    static_cast<std::string*>(scalar.data)->assign(text, length > 0 ? length - 1 : 0);
    at_ += length;
    return {};
  }
  const std::size_t size = binarySize(type);
  if (!take(bytes, size)) return wrong("the data ends too early");
  if (type.kind == Kind::number) {
    std::memcpy(scalar.data, bytes, size);
    return {};
  }
  const auto number = std::to_integer<std::size_t>(bytes[0]);
  if (number >= (type.kind == Kind::boolean ? 2 : type.names.size()))
    return wrong("there is no value " + std::to_string(number));
  setOrdinal(scalar, static_cast<std::int64_t>(number));
  return {};
}

char InText::at(std::size_t ahead) const {
  return at_ + ahead < content_.size() ? std::to_integer<char>(content_[at_ + ahead]) : '\0';
}

void InText::advance() {
  if (at(0) == '\n') ++line_;
  ++at_;
}

void InText::skip() {
  while (!StreamReader::eof() && isBlank(at(0))) advance();
}

bool InText::eof() {
  skip();
  return StreamReader::eof();
}

Result<void> InText::readScalar(Value scalar) {
  if (eof()) return wrong("the text ends too early");
  std::string entry;
  if (at(0) == '"' && at(1) == '"') {
    at_ += 2;
    return setScalar(scalar, entry);
  }
  while (!StreamReader::eof() && !isBlank(at(0))) {
    char c = at(0);
    advance();
    if (c == '\\' && !StreamReader::eof()) {
      const auto i = escapes.find(at(0));
      c = i == escapes.npos ? at(0) : escaped[i];
      advance();
    }
    entry += c;
  }
  const auto done = setScalar(scalar, entry);
  return done ? done : wrong(done.error().what + " instead of " + entry);
}

void InConfig::begin(std::span<const std::byte> content) {
  InText::begin(content);
  if (section_.empty()) return;
  const std::string heading = "[" + section_ + "]";
  while (!StreamReader::eof()) {
    InConfig::skip();
    std::string word;
    const bool found = at(0) == '[';
    while (!StreamReader::eof() && !isBlank(at(0))) {
      word += at(0);
      advance();
    }
    if (found && word == heading) break;
  }
}

bool InConfig::eof() {
  return InText::eof() || (!section_.empty() && at(0) == '[');
}

bool InConfig::skipComment() {
  const bool toLineEnd = at(0) == '#' || (at(0) == '/' && at(1) == '/');
  if (!toLineEnd && !(at(0) == '/' && at(1) == '*')) return false;
  while (!StreamReader::eof() && !(toLineEnd ? at(0) == '\n' : at(0) == '*' && at(1) == '/'))
    advance();
  if (!toLineEnd && !StreamReader::eof()) at_ += 2;
  return true;
}

void InConfig::skip() {
  do InText::skip();
  while (skipComment());
}

void detail::writeValue(ConstValue value, StreamWriter& format, PhysicalOutStream& medium) {
  const Type& type = value.type();
  if (type.kind == Kind::record) {
    for (const Part& p : type.parts) writeValue(value.part(p), format, medium);
  } else if (type.kind == Kind::array || type.kind == Kind::list) {
    const auto length = static_cast<std::uint32_t>(value.size());
    if (type.kind == Kind::list) format.writeScalar(valueOf(length), medium);
    for (std::size_t i = 0; i < value.size(); ++i) writeValue(value.element(i), format, medium);
  } else
    format.writeScalar(value, medium);
}

std::optional<Error> detail::readValue(Value value, StreamReader& format) {
  const Type& type = *value.type;
  if (type.kind == Kind::record) {
    for (const Part& p : type.parts)
      if (auto error = readValue(value.part(p), format)) return in(*error, p.name);
    return std::nullopt;
  }
  if (type.kind != Kind::array && type.kind != Kind::list) {
    const auto done = format.readScalar(value);
    return done ? std::nullopt : std::optional{wrong(done.error().what, format.line())};
  }
  if (type.kind == Kind::list) {
    std::uint32_t length = 0;
    if (const auto done = format.readScalar(valueOf(length)); !done)
      return wrong(done.error().what, format.line());
    if (length > format.left() / std::max<std::size_t>(1, leastEntries(type.element())))
      return wrong("its length exceeds the data", format.line());
    type.resize(value.data, length);
  }
  for (std::size_t i = 0; i < value.size(); ++i)
    if (auto error = readValue(value.element(i), format)) return in(*error, std::to_string(i));
  return std::nullopt;
}

}  // namespace gt
