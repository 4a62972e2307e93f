#include "streams/Streams.h"

#include <algorithm>

namespace gt {
namespace {

constexpr std::string_view escaped{" \\\"\n\t\r\0", 7};
constexpr std::string_view escapes{" \\\"ntr0", 7};

bool isBlank(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/// A medium as cdr::put() writes to it.
struct BinarySink {
  void align(std::size_t n) {
    constexpr std::byte padding[8]{};
    put(padding, cdr::aligned(size, n) - size);
  }
  void put(const void* data, std::size_t n) {
    medium.writeToStream({static_cast<const std::byte*>(data), n});
    size += n;
  }

  PhysicalOutStream& medium;
  std::size_t& size;
};

/// The length of the comment with which a text begins.
std::size_t commentLength(std::string_view text) {
  if (text.starts_with('#') || text.starts_with("//"))
    return std::min(text.find('\n'), text.size());
  if (!text.starts_with("/*")) return 0;
  const auto end = text.find("*/");
  return end == text.npos ? text.size() : end + 2;
}

/// The length of the entry with which a text begins, or of a blank.
std::size_t entryLength(std::string_view text) {
  if (text.starts_with("\"\"")) return 2;
  std::size_t n = 0;
  while (n < text.size() && !isBlank(text[n])) n += text[n] == '\\' ? 2 : 1;
  return std::clamp<std::size_t>(n, 1, text.size());
}

Error textError(std::string what) {
  return {.what = std::move(what)};
}

Error in(Error error, std::string_view name) {
  error.field = std::string(name) + (error.field.empty() ? "" : "." + error.field);
  return error;
}

}  // namespace

void OutFile::writeToStream(std::span<const std::byte> bytes) {
  if (file_) file_->put({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Result<void> OutFile::close() {
  return file_ ? file_->close() : file_.error();
}

void OutMemory::writeToStream(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

InFile::InFile(const std::string& path) {
  auto text = readFile(path);
  if (text)
    text_ = *std::move(text);
  else
    source_ = text.error();
  source_.file = path;
  content_ = std::as_bytes(std::span{text_});
}

void OutBinary::writeScalar(ConstValue scalar, PhysicalOutStream& medium) {
  if (!begun_) medium.writeToStream(cdr::header);
  begun_ = true;
  BinarySink sink{medium, size_};
  const Type& type = scalar.type();
  if (type.kind == Kind::text) {
    cdr::put(sink, *static_cast<const std::string*>(scalar.data()));
  } else if (type.kind == Kind::number) {
    sink.align(numberSize(type.number));
    sink.put(scalar.data(), numberSize(type.number));
  } else {
    cdr::put(sink, static_cast<std::uint8_t>(ordinal(scalar)));
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

void InBinary::begin(std::span<const std::byte> content) {
  StreamReader::begin(content);
  headed_ = cdr::isHeaded(content);
  if (headed_) reader_ = cdr::Reader{content.subspan(cdr::headerSize)};
}

Result<void> InBinary::readScalar(Value scalar) {
  if (!headed_) return cdr::headerError(left_);
  if (!take(scalar)) return reader_.error();
  left_ = left_.last(reader_.left());
  return {};
}

bool InBinary::take(Value scalar) {
  const Type& type = *scalar.type;
  if (type.kind == Kind::text)
    return cdr::getText(reader_, *static_cast<std::string*>(scalar.data));
  if (type.kind == Kind::number)
    return reader_.align(numberSize(type.number)) &&
           reader_.take(scalar.data, numberSize(type.number));
  std::uint8_t number = 0;
  if (!cdr::getScalar(reader_, number)) return false;
  if (number >= (type.kind == Kind::boolean ? 2 : type.names.size()))
    return reader_.noValue(number);
  setOrdinal(scalar, number);
  return true;
}

char InText::take() {
  const char c = next();
  if (c == '\n') ++line_;
  left_ = left_.subspan(1);
  return c;
}

bool InText::eof() {
  while (!left_.empty() && isBlank(next())) take();
  return left_.empty();
}

Result<void> InText::readScalar(Value scalar) {
  if (eof()) return textError("the text ends too early");
  std::string entry;
  if (left() > 1 && next() == '"' && std::to_integer<char>(left_[1]) == '"') {
    left_ = left_.subspan(2);
    return setScalar(scalar, entry);
  }
  while (!left_.empty() && !isBlank(next())) {
    char c = take();
    if (c == '\\' && !left_.empty()) {
      c = take();
      if (const auto i = escapes.find(c); i != escapes.npos) c = escaped[i];
    }
    entry += c;
  }
  const auto done = setScalar(scalar, entry);
  return done ? done : textError(done.error().what + " instead of " + entry);
}

void InConfig::begin(std::span<const std::byte> content) {
  std::string_view rest{reinterpret_cast<const char*>(content.data()), content.size()};
  bool inside = section_.empty();
  while (!rest.empty()) {
    const std::size_t comment = commentLength(rest);
    const std::string_view entry = rest.substr(0, comment > 0 ? comment : entryLength(rest));
    const bool isHeading = !section_.empty() && entry.starts_with('[');
    if (isHeading && inside) break;
    if (isHeading) inside = entry == "[" + section_ + "]";
    const bool counts = inside && !isHeading && comment == 0;
    for (const char c : entry) entries_ += counts || c == '\n' ? c : ' ';
    rest.remove_prefix(entry.size());
  }
  InText::begin(std::as_bytes(std::span{entries_}));
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

Result<void> detail::readValue(Value value, StreamReader& format) {
  const Type& type = *value.type;
  if (type.kind == Kind::record) {
    for (const Part& p : type.parts)
      if (auto done = readValue(value.part(p), format); !done) return in(done.error(), p.name);
    return {};
  }
  if (type.kind != Kind::array && type.kind != Kind::list) return format.readScalar(value);
  if (type.kind == Kind::list) {
    std::uint32_t length = 0;
    if (auto done = format.readScalar(valueOf(length)); !done) return done;
    if (length > format.left() / std::max<std::size_t>(1, width(type.element())))
      return textError("its length exceeds the data");
    type.resize(value.data, length);
  }
  for (std::size_t i = 0; i < value.size(); ++i)
    if (auto done = readValue(value.element(i), format); !done)
      return in(done.error(), std::to_string(i));
  return {};
}

}  // namespace gt
