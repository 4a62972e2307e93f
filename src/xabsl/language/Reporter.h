#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Language.h"

namespace xabsl {

/// Collects the errors and warnings of the compiler's passes. Keeps at most `maximum` errors and as
/// many warnings.
class Reporter {
 public:
  static constexpr std::size_t maximum = 100;

  /// Adds a file and returns its index in `files()`. If the text is given, messages show the line
  /// of their place. The text must outlive the reporter.
  int addFile(const std::string& name, std::string_view text = {});
  const std::vector<std::string>& files() const { return files_; }

  void error(Location location, const std::string& message);
  void warning(Location location, const std::string& message);
  void fileError(const std::string& file, const std::string& message);

  bool failed() const { return failed_; }
  bool full() const { return errors_ >= maximum; }

  /// Everything reported, in the order of files, lines and columns.
  std::vector<Diagnostic> take();

 private:
  struct Entry {
    Location location;
    Diagnostic diagnostic;
  };

  void add(Diagnostic::Severity severity, Location location, const std::string& message);

  std::string line(Location location);

  std::vector<std::string> files_;
  std::vector<std::string_view> texts_;
  std::vector<Entry> entries_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  bool failed_ = false;
};

/// Builds `; did you mean 'x'?` with the candidate whose spelling is most similar to the name;
/// empty if none is similar.
class Suggestion {
 public:
  explicit Suggestion(std::string_view name) : name_(name) {}
  void offer(std::string_view candidate);
  std::string text() const;

 private:
  std::string_view name_;
  std::string_view best_;
  int offers_ = 0;
  std::size_t bestDistance_ = 4;  ///< a larger distance is no typing error
};

}  // namespace xabsl
