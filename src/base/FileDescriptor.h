#pragma once
#include <unistd.h>

#include <utility>

namespace gt {

/// Owns a file descriptor (file, socket, ...) and closes it when destroyed.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int number) : number_{number} {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_{std::exchange(other.number_, -1)} {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~FileDescriptor() {
    if (*this) ::close(number_);
  }

  explicit operator bool() const { return number_ >= 0; }
  /// The descriptor's number; negative if there is none.
  int number() const { return number_; }

 private:
  int number_ = -1;
};

}  // namespace gt
