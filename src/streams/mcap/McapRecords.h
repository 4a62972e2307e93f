#pragma once
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// The building blocks of MCAP files (https://mcap.dev/spec): records of an opcode, a length of 64
/// bits and the content, all little endian.
namespace gt::mcap {

using Bytes = std::vector<std::byte>;
using TextMap = std::map<std::string, std::string>;

/// CRC-32 of bytes that follow others of this one.
inline std::uint32_t crcOf(std::span<const std::byte> bytes, std::uint32_t crc = 0) {
  return static_cast<std::uint32_t>(
      crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

constexpr std::size_t magicSize = 8;
constexpr char magic[magicSize + 1] = "\x89MCAP0\r\n";
constexpr std::size_t recordHeaderSize = 9;
constexpr std::size_t footerSize = 20;

enum class Opcode : std::uint8_t {
  header = 1,
  footer,
  schema,
  channel,
  message,
  chunk,
  messageIndex,
  chunkIndex,
  attachment,
  attachmentIndex,
  statistics,
  metadata,
  metadataIndex,
  summaryOffset,
  dataEnd
};

template <typename N>
requires(std::is_arithmetic_v<N> || std::is_enum_v<N>) void append(Bytes& out, N n) {
  const std::size_t at = out.size();
  out.resize(at + sizeof n);
  std::memcpy(out.data() + at, &n, sizeof n);
}
inline void append(Bytes& out, std::span<const std::byte> bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}
inline void append(Bytes& out, std::string_view text) {
  append(out, static_cast<std::uint32_t>(text.size()));
  append(out, std::as_bytes(std::span{text}));
}
inline void append(Bytes& out, const TextMap& map) {
  std::size_t size = 0;
  for (const auto& [key, value] : map) size += 8 + key.size() + value.size();
  append(out, static_cast<std::uint32_t>(size));
  for (const auto& [key, value] : map) {
    append(out, std::string_view{key});
    append(out, std::string_view{value});
  }
}

/// Appends the begin of a record; returns where its length stands, for endRecord().
inline std::size_t beginRecord(Bytes& out, Opcode opcode) {
  append(out, opcode);
  append(out, std::uint64_t{0});
  return out.size() - sizeof(std::uint64_t);
}
inline void endRecord(Bytes& out, std::size_t lengthAt) {
  const std::uint64_t length = out.size() - lengthAt - sizeof(std::uint64_t);
  std::memcpy(out.data() + lengthAt, &length, sizeof length);
}

/// Takes values from bytes that are not trusted; once they do not suffice, ok() is false and all
/// that is taken is empty.
class Taker {
 public:
  explicit Taker(std::span<const std::byte> bytes) : bytes_{bytes} {}

  template <typename N>
  N number() {
    N n{};
    const auto b = bytes(sizeof n);
    if (ok_) std::memcpy(&n, b.data(), sizeof n);
    return n;
  }
  std::span<const std::byte> bytes(std::uint64_t size) {
    ok_ = ok_ && size <= bytes_.size();
    if (!ok_) return {};
    const auto taken = bytes_.first(static_cast<std::size_t>(size));
    bytes_ = bytes_.subspan(static_cast<std::size_t>(size));
    return taken;
  }
  std::string text() {
    const auto b = bytes(number<std::uint32_t>());
    return {reinterpret_cast<const char*>(b.data()), b.size()};
  }
  TextMap map() {
    TextMap m;
    Taker entries{bytes(number<std::uint32_t>())};
    while (entries.ok() && !entries.empty()) {
      std::string key = entries.text();
      m[std::move(key)] = entries.text();
    }
    ok_ = ok_ && entries.ok();
    return m;
  }
  bool ok() const { return ok_; }
  bool empty() const { return bytes_.empty(); }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  bool ok_ = true;
};

}  // namespace gt::mcap
