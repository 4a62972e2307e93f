#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/File.h"
#include "base/Result.h"
#include "streams/Binary.h"
#include "streams/Type.h"

/// Streams composed of a medium and a format (report, Appendix D): `OutTextFile stream("a.txt");
/// stream << 1 << 3.14 << "Hello Dolly" << endl;`. Functions take the abstract In and Out. A new
/// medium derives from PhysicalOutStream or PhysicalInStream, a new format from StreamWriter or
/// StreamReader. Where the format is known and speed counts, use encode() and decode() instead.
namespace gt {

/// Ends a line in formats that have lines.
struct EndLine {};
constexpr EndLine endl;

// --- Media

/// A medium that takes bytes.
class PhysicalOutStream {
 public:
  virtual ~PhysicalOutStream() = default;
  virtual void writeToStream(std::span<const std::byte> bytes) = 0;
};

/// Writes a file completely or not at all: the file exists once it is closed, see OutputFile.
class OutFile : public PhysicalOutStream {
 public:
  explicit OutFile(const std::string& path) : file_{OutputFile::open(path)} {}
  void writeToStream(std::span<const std::byte> bytes) override;
  /// Returns an error if not everything could be written.
  Result<void> close();

 private:
  Result<OutputFile> file_;
};

/// Writes into memory.
class OutMemory : public PhysicalOutStream {
 public:
  void writeToStream(std::span<const std::byte> bytes) override;
  void reset() { bytes_.clear(); }
  const std::vector<std::byte>& bytes() const { return bytes_; }
  std::string_view text() const {
    return {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()};
  }

 private:
  std::vector<std::byte> bytes_;
};

/// Counts the bytes that a stream would write.
class OutSize : public PhysicalOutStream {
 public:
  void writeToStream(std::span<const std::byte> bytes) override { size_ += bytes.size(); }
  void reset() { size_ = 0; }
  std::size_t size() const { return size_; }

 private:
  std::size_t size_ = 0;
};

/// A medium that bytes are read from.
class PhysicalInStream {
 public:
  /// All data that has not been read.
  std::span<const std::byte> content() const { return content_; }
  /// The error that prevented reading the medium. It contains the name of the source in any case.
  const Error& source() const { return source_; }
  bool opened() const { return source_.what.empty(); }

 protected:
  std::span<const std::byte> content_;
  Error source_;
};

/// Reads from a file.
class InFile : public PhysicalInStream {
 public:
  explicit InFile(const std::string& path);

 private:
  std::string text_;
};

/// Reads from memory, which must outlive it.
class InMemory : public PhysicalInStream {
 public:
  explicit InMemory(std::span<const std::byte> bytes) { content_ = bytes; }
  explicit InMemory(std::string_view text) : InMemory{std::as_bytes(std::span{text})} {}
};

// --- Formats

/// Formats scalars and the lengths of lists.
class StreamWriter {
 public:
  virtual ~StreamWriter() = default;
  virtual void writeScalar(ConstValue scalar, PhysicalOutStream& medium) = 0;
  virtual void writeEndLine(PhysicalOutStream&) {}
};

/// Formats data binary, as encode() does.
class OutBinary : public StreamWriter {
 public:
  void writeScalar(ConstValue scalar, PhysicalOutStream& medium) override;

 private:
  std::size_t size_ = 0;  ///< Behind the header.
  bool begun_ = false;
};

/// Formats data as text: entries separated by spaces; spaces in texts, backslashes, quotes and
/// control characters are escaped by a backslash; an empty text is "".
class OutText : public StreamWriter {
 public:
  void writeScalar(ConstValue scalar, PhysicalOutStream& medium) override;
  void writeEndLine(PhysicalOutStream& medium) override;

 private:
  bool lineBegins_ = true;
};

/// Reads scalars and the lengths of lists.
class StreamReader {
 public:
  virtual ~StreamReader() = default;
  virtual void begin(std::span<const std::byte> content) { left_ = content; }
  virtual Result<void> readScalar(Value scalar) = 0;
  /// In text formats the line of the next entry, from 1.
  virtual int line() const { return 0; }
  /// Whether all data has been read; text formats ignore trailing blanks.
  virtual bool eof() { return left_.empty(); }
  /// The number of bytes left, which limits the number of elements of a list.
  std::size_t left() const { return left_.size(); }

 protected:
  std::span<const std::byte> left_;
};

/// Reads what OutBinary wrote.
class InBinary : public StreamReader {
 public:
  void begin(std::span<const std::byte> content) override;
  Result<void> readScalar(Value scalar) override;

 private:
  bool take(Value scalar);

  bool headed_ = false;
  cdr::Reader reader_{{}};
};

/// Reads the output of OutText; line ends are treated as blanks.
class InText : public StreamReader {
 public:
  Result<void> readScalar(Value scalar) override;
  int line() const override { return line_; }
  bool eof() override;

 private:
  char next() const { return std::to_integer<char>(left_[0]); }
  char take();

  int line_ = 1;
};

/// Reads the entries of a config file, or of one of its sections, leaving out comments (after `//`
/// or `#`, and between `/*` and `*/`).
class InConfig : public InText {
 public:
  explicit InConfig(std::string section = {}) : section_{std::move(section)} {}
  void begin(std::span<const std::byte> content) override;

 private:
  std::string section_;
  std::string entries_;  ///< The content, with comments and other sections replaced by blanks.
};

// --- Streams

/// A stream that data is written to.
class Out {
 public:
  virtual ~Out() = default;
  template <Streamable T>
  Out& operator<<(const T& value) {
    write(valueOf(value));
    return *this;
  }
  Out& operator<<(const char* text) { return *this << std::string(text); }
  Out& operator<<(EndLine) {
    writeEndLine();
    return *this;
  }

  virtual void write(ConstValue value) = 0;

 protected:
  virtual void writeEndLine() = 0;
};

/// A stream that data is read from. After an error nothing more is read. The value that was being
/// read may be changed in part, but stays valid.
class In {
 public:
  virtual ~In() = default;
  template <Streamable T>
  In& operator>>(T& value) {
    read(valueOf(value));
    return *this;
  }
  In& operator>>(EndLine) { return *this; }

  virtual void read(Value value) = 0;
  virtual bool eof() = 0;
  explicit operator bool() const { return !error_; }
  const std::optional<Error>& error() const { return error_; }

 protected:
  std::optional<Error> error_;
};

namespace detail {
void writeValue(ConstValue value, StreamWriter& format, PhysicalOutStream& medium);
Result<void> readValue(Value value, StreamReader& format);
}  // namespace detail

/// A stream that consists of a medium for writing and a format.
template <std::derived_from<PhysicalOutStream> Medium, std::derived_from<StreamWriter> Format>
class OutStream : public Out, public Medium {
 public:
  using Medium::Medium;
  void write(ConstValue value) override { detail::writeValue(value, format_, *this); }
  /// Discards the written data and starts again.
  void reset() requires requires(Medium& medium) { medium.reset(); }
  {
    Medium::reset();
    format_ = Format{};
  }

 protected:
  void writeEndLine() override { format_.writeEndLine(*this); }

 private:
  Format format_;
};

/// A stream that consists of a medium for reading and a format. The format gets the arguments that
/// follow the medium's.
template <std::derived_from<PhysicalInStream> Medium, std::derived_from<StreamReader> Format>
class InStream : public In, public Medium {
 public:
  template <typename MediumArgument, typename... FormatArguments>
  explicit InStream(MediumArgument&& medium, FormatArguments&&... format)
      : Medium{std::forward<MediumArgument>(medium)},
        format_{std::forward<FormatArguments>(format)...} {
    format_.begin(this->content());
    if (!this->opened()) error_ = this->source();
  }

  void read(Value value) override {
    if (error_) return;
    const auto done = detail::readValue(value, format_);
    if (done) return;
    error_ = done.error();
    error_->file = this->source().file;
    error_->line = format_.line();
  }
  bool eof() override { return error_ || format_.eof(); }

 private:
  Format format_;
};

using OutBinaryFile = OutStream<OutFile, OutBinary>;
using OutTextFile = OutStream<OutFile, OutText>;
using OutBinaryMemory = OutStream<OutMemory, OutBinary>;
using OutTextMemory = OutStream<OutMemory, OutText>;
using OutBinarySize = OutStream<OutSize, OutBinary>;
using OutTextSize = OutStream<OutSize, OutText>;
using InBinaryFile = InStream<InFile, InBinary>;
using InTextFile = InStream<InFile, InText>;
using InConfigFile = InStream<InFile, InConfig>;
using InBinaryMemory = InStream<InMemory, InBinary>;
using InTextMemory = InStream<InMemory, InText>;
using InConfigMemory = InStream<InMemory, InConfig>;

}  // namespace gt
