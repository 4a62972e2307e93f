#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"
#include "xabsl/language/References.h"
#include "xabsl/language/Syntax.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl::server {

/// A place as editors count it: lines and units of UTF-16 from 0.
struct Position {
  int line = 0;
  int character = 0;
};

/// Finds lines in a text, and converts columns of characters to those of editors and back.
class Lines {
 public:
  explicit Lines(std::string_view text);

  std::string_view line(int line) const;
  /// The position of a character, or of a byte of the text. Fast, also in a text that is one long
  /// line.
  Position position(Location location) const;
  Position position(std::size_t offset) const;
  Location location(Position position, int file) const;
  /// The byte of the text at a position.
  std::size_t offset(Position position) const;
  Position end() const;

 private:
  /// Numbers of letters and units before a byte of the text.
  struct Count {
    int letters = 0, units = 0;
    void add(char c);
  };

  Count countBefore(std::size_t offset) const;
  std::size_t offsetOfLetter(int letter) const;

  std::string_view text_;
  std::vector<std::size_t> begins_;
  std::vector<Count> counts_;  ///< at regular intervals of bytes
};

/// A behavior, analyzed as far as it has no errors, with all information that editors request.
class Project {
 public:
  /// Reads the file with the agents and all that it includes.
  Project(const std::string& root, const FileReader& read);

  const std::string& root() const { return root_; }
  const syntax::Program& program() const { return program_; }
  const Model& model() const { return model_; }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  bool failed() const { return failed_; }
  const std::vector<Reference>& references() const { return references_.all(); }
  const Lines& lines(int file) const { return lines_[xabsl::at(file)]; }

  /// The index of a file, or -1.
  int file(const std::string& path) const;

  /// The name at a place; null if there is none.
  const Reference* at(Location location) const;

  /// Whether a name has the mark of a parameter, `@`, before it. The mark is a part of the name's
  /// place.
  bool isMarked(const Reference& reference) const;

  /// The declaration of an entity, or null.
  const Reference* declaration(const Entity& entity) const;

 private:
  std::string root_;
  syntax::Program program_;
  Model model_;
  References references_;
  std::vector<Diagnostic> diagnostics_;
  std::vector<Lines> lines_;
  bool failed_ = false;
};

/// The text for hovering over an entity, as Markdown.
std::string describeEntity(const Project& project, const Entity& entity);

/// The declaration of an entity on one line, as in `float input ball.x [0..1] "mm"`.
std::string signatureOf(const Project& project, const Entity& entity);

/// One proposal for completion.
struct Completion {
  enum class Kind {
    keyword,
    option,
    behavior,
    symbol,
    constant,
    element,
    enumeration,
    state,
    parameter
  };

  Kind kind;
  std::string name;
  std::string insert;
  std::string detail;
  std::string doc;
};

/// The proposals for completion at a byte of a text, which may have errors there. The project
/// provides the declarations of other files.
std::vector<Completion> complete(const Project& project, std::string_view text, std::size_t offset);

/// The signature of a call, with the parameter that is being set.
struct Signature {
  struct Parameter {
    std::string label;  ///< a part of the whole label: `float speed`
    std::string doc;
  };

  std::string label;  ///< walk(float speed, bool careful)
  std::string doc;
  std::vector<Parameter> parameters;
  int active = 0;
};

/// The signature of the call around a byte of a text; nothing outside of the parentheses of calls.
std::optional<Signature> signatureAt(const Project& project, std::string_view text,
                                     std::size_t offset);

}  // namespace xabsl::server
