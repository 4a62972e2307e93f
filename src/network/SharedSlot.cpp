#include "network/SharedSlot.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/vfs.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>

namespace gt {
namespace {

constexpr std::size_t places = 2;
constexpr std::size_t smallest = 65536;

/// Before the packages: the numbers of those that lie in the places, 0 while one is written.
struct Head {
  std::atomic<std::uint64_t> numbers[places];
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
/// So that the packages do not share a line of the cache with the numbers.
constexpr std::size_t slotHeadSize = 64;
static_assert(sizeof(Head) <= slotHeadSize);

std::atomic<std::uint64_t>& numberAt(const MappedMemory& memory, std::uint64_t number) {
  return reinterpret_cast<Head*>(memory.data())->numbers[number % places];
}

std::size_t capacityOf(const MappedMemory& memory) {
  return (memory.size() - slotHeadSize) / places;
}

std::byte* slotAt(const MappedMemory& memory, std::uint64_t number) {
  return memory.data() + slotHeadSize + number % places * capacityOf(memory);
}

}  // namespace

MappedMemory::MappedMemory(const FileDescriptor& memory, std::size_t size, bool writable) {
  void* place = mmap(nullptr, size, writable ? PROT_READ | PROT_WRITE : PROT_READ, MAP_SHARED,
                     memory.number(), 0);
  if (place == MAP_FAILED) return;
  data_ = static_cast<std::byte*>(place);
  size_ = size;
}

MappedMemory::MappedMemory(MappedMemory&& other) noexcept
    : data_{std::exchange(other.data_, nullptr)}, size_{std::exchange(other.size_, 0)} {}

MappedMemory& MappedMemory::operator=(MappedMemory&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  return *this;
}

MappedMemory::~MappedMemory() {
  if (data_) munmap(data_, size_);
}

std::optional<SlotWriter> SlotWriter::make(std::size_t size) {
  const std::size_t whole = slotHeadSize + places * std::bit_ceil(std::max(size, smallest));
  FileDescriptor memory{memfd_create("gt2003-slot", MFD_CLOEXEC | MFD_ALLOW_SEALING)};
  if (!memory || ftruncate(memory.number(), static_cast<off_t>(whole)) != 0) return {};
  // A reader relies on that: beyond the end of a file that shrank it would be killed.
  if (fcntl(memory.number(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0)
    return {};
  MappedMemory mapped{memory, whole, true};
  if (!mapped.data()) return {};
  return SlotWriter{std::move(memory), std::move(mapped)};
}

std::size_t SlotWriter::capacity() const {
  return capacityOf(mapped_);
}

std::byte* SlotWriter::begin() {
  ++number_;
  numberAt(mapped_, number_).store(0, std::memory_order_relaxed);
  std::atomic_thread_fence(std::memory_order_release);  // before any byte of the package
  return slotAt(mapped_, number_);
}

std::uint64_t SlotWriter::publish() {
  numberAt(mapped_, number_).store(number_, std::memory_order_release);
  return number_;
}

std::optional<SlotReader> SlotReader::open(const FileDescriptor& memory, std::size_t largest) {
  const std::size_t most = slotHeadSize + places * std::bit_ceil(std::max(largest, smallest));
  struct stat status {};
  struct statfs system {};
  const int seals = fcntl(memory.number(), F_GET_SEALS);
  if (seals < 0 || !(seals & F_SEAL_SHRINK) || fstat(memory.number(), &status) != 0 ||
      fstatfs(memory.number(), &system) != 0 || system.f_type != TMPFS_MAGIC)
    return {};
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size <= slotHeadSize || size > most) return {};
  MappedMemory mapped{memory, size, false};
  if (!mapped.data()) return {};
  return SlotReader{std::move(mapped)};
}

bool SlotReader::read(std::uint64_t number, std::span<std::byte> package) const {
  if (number == 0 || package.size() > capacityOf(mapped_)) return false;
  const std::atomic<std::uint64_t>& present = numberAt(mapped_, number);
  if (present.load(std::memory_order_acquire) != number) return false;
  std::memcpy(package.data(), slotAt(mapped_, number), package.size());
  std::atomic_thread_fence(std::memory_order_acquire);  // after all bytes of the package
  return present.load(std::memory_order_relaxed) == number;
}

}  // namespace gt
