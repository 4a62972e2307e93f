#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace xabsl::server {

/// Cuts a stream of bytes into messages of the base protocol of LSP: a header with their length,
/// an empty line, and the message. Holds at most one message and what was added last.
class MessageReader {
 public:
  static constexpr std::size_t largestMessage = 16u << 20;

  void add(std::string_view bytes) { buffer_ += bytes; }

  /// The next message that is complete.
  std::optional<std::string> next();

  /// True after a header that is none: what follows cannot be understood.
  bool broken() const { return broken_; }

 private:
  std::string buffer_;
  bool broken_ = false;
};

}  // namespace xabsl::server
