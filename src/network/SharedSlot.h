#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/FileDescriptor.h"

namespace gt {

/// A piece of memory that is mapped into this process; unmaps it at the end.
class MappedMemory {
 public:
  MappedMemory(const FileDescriptor& memory, std::size_t size, bool writable);
  MappedMemory(MappedMemory&& other) noexcept;
  MappedMemory& operator=(MappedMemory&& other) noexcept;
  ~MappedMemory();

  std::byte* data() const { return data_; }
  std::size_t size() const { return size_; }

 private:
  std::byte* data_ = nullptr;
  std::size_t size_ = 0;
};

/// The newest packages of one type, for one other process: memory that both see and this one
/// writes. It has room for two packages; the next one replaces the older of them. Nobody locks
/// anything: what is replaced while it is read is known by its number, so each end may die at any
/// moment. Handed over by LocalConnection.
class SlotWriter {
 public:
  /// Has room for packages of up to a number of bytes; empty if there is no memory.
  static std::optional<SlotWriter> make(std::size_t size);

  /// Room for capacity() bytes, which hold the next package as soon as it is published.
  std::byte* begin();
  /// Returns the package's number, by which it is read.
  std::uint64_t publish();

  std::size_t capacity() const;
  /// What the reader needs.
  const FileDescriptor& memory() const { return memory_; }

 private:
  SlotWriter(FileDescriptor memory, MappedMemory mapped)
      : memory_{std::move(memory)}, mapped_{std::move(mapped)} {}

  FileDescriptor memory_;
  MappedMemory mapped_;
  std::uint64_t number_ = 0;
};

/// The other end of a SlotWriter. What lies there is data from outside, and may change while it is
/// read.
class SlotReader {
 public:
  /// Empty if this is no slot, or if it has room for larger packages than wanted.
  static std::optional<SlotReader> open(const FileDescriptor& memory, std::size_t largest);

  /// Copies the package with that number; false if it has been replaced meanwhile or never was.
  bool read(std::uint64_t number, std::span<std::byte> package) const;
  /// Bytes in the memory.
  std::size_t size() const { return mapped_.size(); }

 private:
  explicit SlotReader(MappedMemory mapped) : mapped_{std::move(mapped)} {}

  MappedMemory mapped_;
};

}  // namespace gt
