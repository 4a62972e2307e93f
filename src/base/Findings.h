#pragma once
#include <string>
#include <vector>

#include "base/Result.h"

namespace gt {

/// All errors and warnings about data from outside, in the order in which they were found. Errors
/// keep the data from being used. Warnings do not, but they make a program that was started with
/// `--strict` fail.
class Findings {
 public:
  void add(Error finding) { list_.push_back(std::move(finding)); }
  /// Adds the error of a result, if it is one.
  void add(const Result<void>& done) {
    if (!done) add(done.error());
  }
  void add(Findings other);
  void add(const std::vector<Error>& findings) {
    list_.insert(list_.end(), findings.begin(), findings.end());
  }
  void warn(Error finding) {
    finding.severity = Severity::warning;
    add(std::move(finding));
  }

  /// Sorts by file and line, and removes duplicates.
  void sort();

  const std::vector<Error>& list() const { return list_; }
  bool empty() const { return list_.empty(); }
  /// Returns the first error, or success if there are only warnings.
  Result<void> firstError() const;
  std::size_t errors() const { return count(Severity::error); }
  std::size_t warnings() const { return count(Severity::warning); }
  /// Whether a program fails: there are errors, or `strict` is set and there are warnings.
  bool fail(bool strict) const { return errors() > 0 || (strict && warnings() > 0); }
  /// A line for each finding.
  std::string text() const;

 private:
  std::size_t count(Severity severity) const;

  std::vector<Error> list_;
};

}  // namespace gt
