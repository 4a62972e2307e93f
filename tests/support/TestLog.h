#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

namespace gt {

/// Builds a log by hand, for tests.
class LogBuilder {
 public:
  template <typename T>
  LogBuilder& put(T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    body_.append(bytes, sizeof value);
    return *this;
  }
  LogBuilder& fill(std::size_t size) {
    body_.append(size, '\0');
    return *this;
  }
  void end(std::uint8_t id) {
    const auto head = static_cast<std::uint32_t>(body_.size() << 8 | id);
    std::string body;
    std::swap(body, body_);
    put(head);
    messages_ += body_ + body;
    body_.clear();
    ++count_;
  }
  std::string log() {
    body_.clear();
    put(static_cast<std::uint32_t>(messages_.size())).put(count_);
    std::string header;
    std::swap(header, body_);
    return header + messages_;
  }

 private:
  std::string body_, messages_;
  std::uint32_t count_ = 0;
};

}  // namespace gt
