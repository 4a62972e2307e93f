#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "base/Result.h"
#include "streams/Shape.h"

/// The binary format: CDR as ROS 2 and DDS write it (OMG DDS-XTypes 1.3, 7.4: plain XCDR1, little
/// endian). Four bytes of header, then the values, each aligned to its size from the header's end;
/// texts and lists begin with a length of 32 bits, enumerations and booleans are one byte.
namespace gt {
namespace cdr {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t headerSize = 4;
constexpr std::byte header[headerSize] = {std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};

template <typename T, std::size_t i>
using PartType = std::remove_cvref_t<decltype(Shape<T>::template part<i>(std::declval<T&>()))>;

template <typename T, std::size_t... i>
constexpr std::size_t uniformPartSize(std::index_sequence<i...>);

/// The size of the numbers of which a type consists if all have the same one; 0 otherwise.
template <typename T>
constexpr std::size_t uniformSize() {
  using S = Shape<T>;
  if constexpr (S::kind == Kind::number)
    return sizeof(T);
  else if constexpr (S::kind == Kind::array)
    return uniformSize<typename S::Element>();
  else if constexpr (S::kind == Kind::record)
    return uniformPartSize<T>(std::make_index_sequence<S::partCount>{});
  else
    return 0;
}
template <typename T, std::size_t... i>
constexpr std::size_t uniformPartSize(std::index_sequence<i...>) {
  const std::size_t sizes[] = {uniformSize<PartType<T, i>>()..., 0};
  for (std::size_t k = 0; k < sizeof...(i); ++k)
    if (sizes[k] != sizes[0]) return 0;
  return sizes[0];
}

/// The least number of bytes that a value of a type takes.
template <typename T>
constexpr std::size_t leastSize() {
  using S = Shape<T>;
  if constexpr (S::kind == Kind::number)
    return sizeof(T);
  else if constexpr (S::kind == Kind::boolean || S::kind == Kind::enumeration)
    return 1;
  else if constexpr (S::kind == Kind::text || S::kind == Kind::list)
    return 4;
  else if constexpr (S::kind == Kind::array)
    return S::count * leastSize<typename S::Element>();
  else
    return []<std::size_t... i>(std::index_sequence<i...>) {
      return (std::size_t{0} + ... + leastSize<PartType<T, i>>());
    }
  (std::make_index_sequence<S::partCount>{});
}

/// Whether fields() lists the members, all of one type, in the order in which they lie in memory.
template <typename T, std::size_t... i>
constexpr bool listedAsStored(std::index_sequence<i...>) {
  using S = Shape<T>;
  const T record{};
  if constexpr ((std::same_as<PartType<T, i>, PartType<T, 0>> && ...)) {
    const PartType<T, 0>* parts[] = {&S::template part<i>(record)...};
    for (std::size_t k = 1; k < sizeof...(i); ++k)
      if (parts[k - 1] >= parts[k]) return false;
    return true;
  } else
    return false;
}

template <typename T>
constexpr bool isOrdered() {
  using S = Shape<T>;
  if constexpr (std::same_as<T, Matrix3d>)
    return false;
  else if constexpr (S::kind == Kind::array)
    return isOrdered<typename S::Element>();
  else if constexpr (S::kind != Kind::record || std::is_base_of_v<VectorShape<2>, S> ||
                     std::is_base_of_v<VectorShape<3>, S>)
    return true;
  else if constexpr (S::partCount == 0)
    return false;
  else if constexpr (requires {
                       typename std::bool_constant<listedAsStored<T>(
                           std::make_index_sequence<S::partCount>{})>;
                     })
    return listedAsStored<T>(std::make_index_sequence<S::partCount>{});
  else
    return false;
}

/// A type that lies in memory as it does in the stream, so that whole blocks are copied at once.
template <typename T>
constexpr bool isBlock = uniformSize<T>() > 0 && sizeof(T) == leastSize<T>() && isOrdered<T>();

/// A type of one byte of which only the lowest values are valid.
template <typename T>
constexpr bool isByte = (kindOf<T> == Kind::boolean || kindOf<T> == Kind::enumeration) &&
                        sizeof(T) == 1;

/// The number of valid values of a boolean or an enumeration.
template <typename T>
constexpr std::size_t valueCount() {
  if constexpr (kindOf<T> == Kind::boolean)
    return 2;
  else
    return enumCount<T>;
}

/// The first element of an array or list. That of an array lies where the array does; asked in this
/// way because gcc 12 folds these functions of all arrays into one and then warns of its bounds.
template <typename T>
auto* firstElement(T& sequence) {
  using S = Shape<std::remove_const_t<T>>;
  using Element = typename S::Element;
  if constexpr (S::kind == Kind::array) {
    static_assert(sizeof(T) == S::count * sizeof(Element));
    using Pointed = std::conditional_t<std::is_const_v<T>, const Element, Element>;
    return reinterpret_cast<Pointed*>(&sequence);
  } else
    return sequence.data();
}

template <typename T>
auto& elementAt(T& sequence, std::size_t i) {
  if constexpr (kindOf<std::remove_const_t<T>> == Kind::array)
    return Shape<std::remove_const_t<T>>::at(sequence, i);
  else
    return sequence[i];
}

/// Counts the bytes of a stream.
class Counter {
 public:
  void align(std::size_t n) { size_ = (size_ + n - 1) & ~(n - 1); }
  void put(const void*, std::size_t n) { size_ += n; }
  std::size_t size() const { return size_; }

 private:
  std::size_t size_ = 0;
};

/// Writes a stream to memory that has room for it.
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

 private:
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

/// Reads a stream from memory, never beyond its end. Its functions return false if the stream does
/// not hold what was asked for; error() then says what and where.
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
  /// The bytes that follow; there must be that many.
  const std::byte* next() const { return bytes_.data() + at_; }
  std::size_t left() const { return bytes_.size() - at_; }

  bool fail(std::string_view what);
  bool noValue(int number);
  /// Whether nothing is left but what DDS appends to reach a multiple of four bytes.
  bool finish();
  /// Tells in which field the failure was, from the inside to the outside.
  bool failedIn(std::string_view name);
  bool failedIn(std::size_t index);
  const Error& error() const { return error_; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  Error error_;
};

bool getText(Reader& reader, std::string& text);
bool checkHeader(std::span<const std::byte> bytes, Error& error);

template <typename T>
bool get(Reader& reader, T& value);

/// Takes bytes of which each must be less than a limit.
template <typename T>
bool getBytes(Reader& reader, T* data, std::size_t count) {
  if (count > reader.left()) return reader.fail("the data ends too early");
  const std::byte* bytes = reader.next();
  std::byte highest{0};
  for (std::size_t i = 0; i < count; ++i) highest = std::max(highest, bytes[i]);
  if (std::to_integer<std::size_t>(highest) >= valueCount<T>())
    return reader.noValue(std::to_integer<int>(highest));
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

/// Appends a value.
template <Streamable T>
void encode(const T& value, std::vector<std::byte>& out) {
  const std::size_t begin = out.size();
  out.resize(begin + encodedSize(value));
  encodeTo(value, out.data() + begin);
}

/// Reads a value that fills all the bytes. On an error the value may be changed in part; it stays
/// valid. The error's field is the path of what could not be read.
template <Streamable T>
Result<void> decode(std::span<const std::byte> bytes, T& value) {
  Error error;
  if (!cdr::checkHeader(bytes, error)) return error;
  cdr::Reader reader{bytes.subspan(cdr::headerSize)};
  if (!cdr::get(reader, value) || !reader.finish()) return reader.error();
  return {};
}

}  // namespace gt
