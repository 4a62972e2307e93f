#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace xabsl::server {

/// Splits a stream of bytes into messages of the base protocol of LSP: a header with the length, an
/// empty line, and the message. Stores at most one message and the bytes added last.
class MessageReader {
 public:
  static constexpr std::size_t largestMessage = 16u << 20;

  void add(std::string_view bytes) { buffer_ += bytes; }

  /// The next complete message; nothing if there is none.
  std::optional<std::string> next();

  /// True after an invalid header: the rest of the stream cannot be read.
  bool broken() const { return broken_; }

 private:
  std::string buffer_;
  bool broken_ = false;
};

}  // namespace xabsl::server
