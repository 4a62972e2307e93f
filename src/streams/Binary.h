#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/Result.h"
#include "streams/BinaryLayout.h"
#include "streams/Shape.h"

/// The binary format: CDR as used by ROS 2 and DDS (OMG DDS-XTypes 1.3, 7.4: plain XCDR1, little
/// endian). A header of four bytes is followed by the values. Each value is aligned to its size,
/// counted from the header's end. Texts and lists begin with a length of 32 bits; enumerations and
/// booleans are one byte.
namespace gt {
namespace cdr {

constexpr std::size_t headerSize = 4;
constexpr std::byte header[headerSize] = {std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};

/// Counts the bytes of a stream.
class Counter {
 public:
  void align(std::size_t n) { size_ = aligned(size_, n); }
  void put(const void*, std::size_t n) { size_ += n; }
  template <typename T>
  bool putWhole(const T&) {
    size_ = fixedEnd<T>(size_);
    return true;
  }
  std::size_t size() const { return size_; }

 private:
  std::size_t size_ = 0;
};

/// Writes a stream to memory, which must have enough room.
class Writer {
 public:
  explicit Writer(std::byte* begin) : begin_{begin} {}
  void align(std::size_t n) {
    while ((size_ & (n - 1)) != 0) begin_[size_++] = std::byte{0};
  }
  void put(const void* data, std::size_t n) {
    std::memcpy(begin_ + size_, data, n);
    size_ += n;
  }
  /// Writes a value of a fixed type at once if it begins at one of the two usual positions:
  /// aligned, or behind another value of its type. Otherwise writes nothing and returns false.
  template <typename T>
  bool putWhole(const T& value) {
    return putWholeAt<0>(value) || putWholeAt<behindAnother<T>()>(value);
  }

 private:
  template <std::size_t phase, typename T>
  bool putWholeAt(const T& value) {
    if (size_ % alignmentOf<T>() != phase) return false;
    putFixed<phase>(begin_ + size_, value);
    size_ += fixedEnd<T>(phase) - phase;
    return true;
  }

  std::byte* begin_;
  std::size_t size_ = 0;
};

template <typename Sink, typename T>
void put(Sink& sink, const T& value);

template <typename Sink, typename T>
void putElements(Sink& sink, const T& sequence, std::size_t count) {
  using Element = typename Shape<T>::Element;
  if (count == 0) return;
  if constexpr (!std::same_as<T, Matrix3d> && isBlock<Element>) {
    sink.align(uniformSize<Element>());
    sink.put(firstElement(sequence), count * sizeof(Element));
  } else if constexpr (isByte<Element>)
    sink.put(firstElement(sequence), count);
  else
    for (std::size_t i = 0; i < count; ++i) put(sink, elementAt(sequence, i));
}

template <typename Sink, typename T>
void putScalar(Sink& sink, T value) {
  sink.align(sizeof value);
  sink.put(&value, sizeof value);
}

template <typename Sink, typename T>
void put(Sink& sink, const T& value) {
  constexpr Kind kind = kindOf<T>;
  if constexpr (isFixedGroup<T>)
    if (sink.putWhole(value)) return;
  if constexpr (kind == Kind::number)
    putScalar(sink, value);
  else if constexpr (kind == Kind::boolean || kind == Kind::enumeration)
    putScalar(sink, static_cast<std::uint8_t>(value));
  else if constexpr (kind == Kind::text) {
    putScalar(sink, static_cast<std::uint32_t>(value.size() + 1));
    sink.put(value.c_str(), value.size() + 1);
  } else if constexpr (kind == Kind::array)
    putElements(sink, value, Shape<T>::count);
  else if constexpr (kind == Kind::list) {
    putScalar(sink, static_cast<std::uint32_t>(value.size()));
    putElements(sink, value, value.size());
  } else
    forEachPart(value, [&](const PartInfo&, const auto& part) {
      put(sink, part);
      return true;
    });
}

/// Reads a stream from memory, never beyond its end. The functions return false if the stream does
/// not contain the requested data; error() then states what is wrong and where.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_{bytes} {}

  bool align(std::size_t n) { return skip((~at_ + 1) & (n - 1)); }
  bool take(void* data, std::size_t n) {
    if (n > left()) return fail("the data ends too early");
    if (n > 0) std::memcpy(data, bytes_.data() + at_, n);
    at_ += n;
    return true;
  }
  bool skip(std::size_t n) {
    if (n > left()) return fail("the data ends too early");
    at_ += n;
    return true;
  }
  /// Reads a value of a fixed type at once if it is complete and begins at one of the two usual
  /// positions, as Writer::putWhole does. Otherwise reads nothing and returns false.
  template <typename T>
  bool takeWhole(T& value) {
    return takeWholeAt<0>(value) || takeWholeAt<behindAnother<T>()>(value);
  }
  /// The next bytes; the caller must check with left() that there are enough.
  const std::byte* next() const { return bytes_.data() + at_; }
  std::size_t left() const { return bytes_.size() - at_; }

  bool fail(std::string_view what);
  bool noValue(int number);
  /// Returns whether the rest of the data is only the padding that DDS appends to reach a multiple
  /// of four bytes.
  bool finish();
  /// Adds the name of the field to the error's path, from the inside to the outside.
  bool failedIn(std::string_view name);
  bool failedIn(std::size_t index);
  Error error() const { return error_.value_or(Error{}); }

 private:
  template <std::size_t phase, typename T>
  bool takeWholeAt(T& value) {
    constexpr std::size_t size = fixedEnd<T>(phase) - phase;
    if (at_ % alignmentOf<T>() != phase || left() < size || !getFixed<phase>(next(), value))
      return false;
    at_ += size;
    return true;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  std::optional<Error> error_;
};

bool getText(Reader& reader, std::string& text);
inline bool isHeaded(std::span<const std::byte> bytes) {
  return bytes.size() >= headerSize && bytes[0] == header[0] && bytes[1] == header[1];
}
Error headerError(std::span<const std::byte> bytes);

template <typename T>
bool get(Reader& reader, T& value);

/// Reads values of one byte each; fails if one of them is not a value of the type.
template <typename T>
bool getBytes(Reader& reader, T* data, std::size_t count) {
  if (count > reader.left()) return reader.fail("the data ends too early");
  if (!areValues<T>(reader.next(), count)) {
    const auto* end = reader.next() + count;
    return reader.noValue(std::to_integer<int>(*std::max_element(reader.next(), end)));
  }
  return reader.take(data, count);
}

template <typename T>
bool getElements(Reader& reader, T& sequence, std::size_t count) {
  using Element = typename Shape<T>::Element;
  if (count == 0) return true;
  if constexpr (!std::same_as<T, Matrix3d> && isBlock<Element>)
    return reader.align(uniformSize<Element>()) &&
           reader.take(firstElement(sequence), count * sizeof(Element));
  else if constexpr (isByte<Element>)
    return getBytes(reader, firstElement(sequence), count);
  else {
    for (std::size_t i = 0; i < count; ++i)
      if (!get(reader, elementAt(sequence, i))) return reader.failedIn(i);
    return true;
  }
}

template <typename T>
bool getScalar(Reader& reader, T& value) {
  return reader.align(sizeof value) && reader.take(&value, sizeof value);
}

template <typename T>
bool get(Reader& reader, T& value) {
  constexpr Kind kind = kindOf<T>;
  // On a failure the value is read again step by step to find the error.
  if constexpr (isFixedGroup<T>)
    if (reader.takeWhole(value)) return true;
  if constexpr (kind == Kind::number)
    return getScalar(reader, value);
  else if constexpr (kind == Kind::boolean || kind == Kind::enumeration) {
    std::uint8_t number = 0;
    if (!getScalar(reader, number)) return false;
    if (number >= valueCount<T>()) return reader.noValue(number);
    value = static_cast<T>(number);
    return true;
  } else if constexpr (kind == Kind::text)
    return getText(reader, value);
  else if constexpr (kind == Kind::array)
    return getElements(reader, value, Shape<T>::count);
  else if constexpr (kind == Kind::list) {
    using Element = typename Shape<T>::Element;
    static_assert(leastSize<Element>() > 0, "elements of a list need at least one byte");
    std::uint32_t count = 0;
    if (!getScalar(reader, count)) return false;
    if (count > reader.left() / leastSize<Element>())
      return reader.fail("its length exceeds the data");
    value.resize(count);
    return getElements(reader, value, count);
  } else
    return forEachPart(value, [&](const PartInfo& info, auto& part) {
      return get(reader, part) || reader.failedIn(info.name);
    });
}

}  // namespace cdr

/// The number of bytes that encode() appends.
template <Streamable T>
std::size_t encodedSize(const T& value) {
  cdr::Counter counter;
  cdr::put(counter, value);
  return cdr::headerSize + counter.size();
}

/// Writes a value to memory that has room for encodedSize() bytes.
template <Streamable T>
void encodeTo(const T& value, std::byte* out) {
  std::memcpy(out, cdr::header, cdr::headerSize);
  cdr::Writer writer{out + cdr::headerSize};
  cdr::put(writer, value);
}

/// Appends the encoded value to `out`.
template <Streamable T>
void encode(const T& value, std::vector<std::byte>& out) {
  const std::size_t begin = out.size();
  out.resize(begin + encodedSize(value));
  encodeTo(value, out.data() + begin);
}

/// Reads a value that must fill all the bytes. On an error a part of the value may be changed; it
/// stays valid. The error's field is the path of the field that could not be read.
template <Streamable T>
Result<void> decode(std::span<const std::byte> bytes, T& value) {
  if (!cdr::isHeaded(bytes)) return cdr::headerError(bytes);
  cdr::Reader reader{bytes.subspan(cdr::headerSize)};
  if (!cdr::get(reader, value) || !reader.finish()) return reader.error();
  return {};
}

}  // namespace gt
