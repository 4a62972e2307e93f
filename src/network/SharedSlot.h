#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/FileDescriptor.h"

namespace gt {

/// Memory that is mapped into this process; unmapped when destroyed.
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

/// The newest packages of one type for one other process, in shared memory that this process
/// writes. It has room for two packages; a new package replaces the older one. No locks are used: a
/// package that is replaced while it is read is recognized by its number, so each process may end
/// at any moment. Transferred by LocalConnection.
class SlotWriter {
 public:
  /// Makes a slot for packages of up to `size` bytes; empty if there is no memory.
  static std::optional<SlotWriter> make(std::size_t size);

  /// Memory of capacity() bytes, in which the next package must be written before it is published.
  std::byte* begin();
  /// Makes the package readable. Returns its number, by which it is read.
  std::uint64_t publish();

  std::size_t capacity() const;
  /// The memory's descriptor, which the reader needs.
  const FileDescriptor& memory() const { return memory_; }

 private:
  SlotWriter(FileDescriptor memory, MappedMemory mapped)
      : memory_{std::move(memory)}, mapped_{std::move(mapped)} {}

  FileDescriptor memory_;
  MappedMemory mapped_;
  std::uint64_t number_ = 0;
};

/// The reader's end of a SlotWriter. The memory contains data from outside, which may change while
/// it is read.
class SlotReader {
 public:
  /// Opens a slot. Empty if the memory is not a slot, or its capacity exceeds `largest` (bytes).
  static std::optional<SlotReader> open(const FileDescriptor& memory, std::size_t largest);

  /// Copies the package with that number. Returns false if it has been replaced or never existed.
  bool read(std::uint64_t number, std::span<std::byte> package) const;
  /// Size of the memory, in bytes.
  std::size_t size() const { return mapped_.size(); }

 private:
  explicit SlotReader(MappedMemory mapped) : mapped_{std::move(mapped)} {}

  MappedMemory mapped_;
};

}  // namespace gt
