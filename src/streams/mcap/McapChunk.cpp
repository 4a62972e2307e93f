#include <fcntl.h>
#include <lz4frame.h>
#include <sys/stat.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "streams/mcap/McapContent.h"

namespace gt::mcap {
namespace {

/// The largest chunk that is unpacked: a guard against bytes that claim to be enormous.
constexpr std::uint64_t largestChunk = 1u << 28;
/// How much is read at once of what is read in small parts.
constexpr std::uint64_t windowSize = 4096;

/// Unpacks an lz4 frame; it must fill the bytes.
Result<void> unpackLz4(std::span<const std::byte> packed, Bytes& bytes) {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0)
    return Error{.what = "lz4 has no memory"};
  std::size_t size = bytes.size(), packedSize = packed.size();
  const std::size_t left =
      LZ4F_decompress(context, bytes.data(), &size, packed.data(), &packedSize, nullptr);
  LZ4F_freeDecompressionContext(context);
  if (LZ4F_isError(left) != 0)
    return Error{.what = std::string("the chunk is damaged: ") + LZ4F_getErrorName(left)};
  if (left != 0) return Error{.what = "the chunk is damaged: its end is missing"};
  bytes.resize(size);
  return {};
}

/// Unpacks the records of a chunk.
Result<void> unpack(Taker chunk, Bytes& unpacked) {
  chunk.number<std::uint64_t>();
  chunk.number<std::uint64_t>();
  const auto unpackedSize = chunk.number<std::uint64_t>();
  const auto crc = chunk.number<std::uint32_t>();
  const std::string compression = chunk.text();
  const auto packed = chunk.bytes(chunk.number<std::uint64_t>());
  if (!chunk.ok()) return Error{.what = "the chunk is damaged"};
  if (unpackedSize > largestChunk)
    return Error{.what = "the chunk claims to be larger than 256 MiB"};
  if (compression.empty()) {
    unpacked.assign(packed.begin(), packed.end());
  } else if (compression == "zstd") {
    unpacked.resize(static_cast<std::size_t>(unpackedSize));
    const std::size_t n =
        ZSTD_decompress(unpacked.data(), unpacked.size(), packed.data(), packed.size());
    if (ZSTD_isError(n) != 0)
      return Error{.what = std::string("the chunk is damaged: ") + ZSTD_getErrorName(n)};
    unpacked.resize(n);
  } else if (compression == "lz4") {
    unpacked.resize(static_cast<std::size_t>(unpackedSize));
    if (auto done = unpackLz4(packed, unpacked); !done) return done;
  } else {
    return Error{.what = "the compression " + compression + " is not supported, only zstd and lz4"};
  }
  if (unpacked.size() != unpackedSize || (crc != 0 && crc != crcOf(unpacked)))
    return Error{.what = "the chunk's checksum is wrong"};
  return {};
}

}  // namespace

Result<LogBytes> LogBytes::open(const std::string& path) {
  const auto wrong = [&](std::string what) { return Error{.file = path, .what = std::move(what)}; };
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (status.type() == std::filesystem::file_type::not_found) return wrong("there is no such file");
  if (status.type() == std::filesystem::file_type::directory) return wrong("is a folder");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    return wrong("is not a file");
  LogBytes log;
  log.file_ = FileDescriptor{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  struct stat opened {};
  if (!log.file_ || fstat(log.file_.number(), &opened) != 0)
    return wrong(std::string("cannot be read: ") + strerror(errno));
  log.size_ = static_cast<std::uint64_t>(opened.st_size);
  log.written_ = opened.st_mtim;
  return log;
}

bool LogBytes::read(std::uint64_t offset, std::uint64_t length, Bytes& bytes) {
  if (offset > size_ || length > size_ - offset) return false;
  bytes.resize(static_cast<std::size_t>(length));
  if (length > windowSize) return readInto(offset, bytes) == bytes.size();
  if (offset < windowBegin_ || offset + length > windowBegin_ + window_.size()) {
    window_.resize(static_cast<std::size_t>(std::min(windowSize, size_ - offset)));
    windowBegin_ = offset;
    window_.resize(readInto(offset, window_));
    if (length > window_.size()) return false;
  }
  std::copy_n(window_.begin() + static_cast<std::ptrdiff_t>(offset - windowBegin_), length,
              bytes.begin());
  return true;
}

bool LogBytes::hasChanged(bool mayGrow) const {
  struct stat now {};
  if (fstat(file_.number(), &now) != 0) return true;
  const auto size = static_cast<std::uint64_t>(now.st_size);
  if (mayGrow) return size < size_;
  return size != size_ || now.st_mtim.tv_sec != written_.tv_sec ||
         now.st_mtim.tv_nsec != written_.tv_nsec;
}

std::size_t LogBytes::readInto(std::uint64_t offset, Bytes& bytes) const {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = pread(file_.number(), bytes.data() + done, bytes.size() - done,
                            static_cast<off_t>(offset + done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    done += static_cast<std::size_t>(n);
  }
  return done;
}

Result<std::span<const std::byte>> LogContent::load(const Segment& from, Bytes& record,
                                                    Bytes& unpacked) {
  const std::uint64_t skip = from.isChunk ? recordHeaderSize : 0;
  if (!file.read(from.begin + skip, from.length - skip, record))
    return Error{.what = "the log ends within it"};
  if (!from.isChunk) return std::span<const std::byte>{record};
  if (const auto done = unpack(Taker{record}, unpacked); !done) return done.error();
  return std::span<const std::byte>{unpacked};
}

}  // namespace gt::mcap
