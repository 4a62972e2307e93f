#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gt {

/// How a command's arguments are written: alternatives between |, what may be missing in [ ], what
/// may be repeated in { }, groups in ( ). Words that begin with a capital letter are placeholders
/// for something else; all others are typed as they are.
class Usage {
 public:
  /// More words match nothing: matching takes a stack that grows with them.
  static constexpr std::size_t mostWords = 1000;

  explicit Usage(std::string_view text);

  /// What may stand behind some words.
  struct Next {
    std::vector<std::string> words;         ///< To be typed as they are.
    std::vector<std::string> placeholders;  ///< Names of what may stand there.
    /// Where a command begins that makes up the rest (placeholder COMMAND), as an index.
    std::optional<std::size_t> command{};
  };
  Next next(std::span<const std::string> before) const;
  /// Whether words are what may stand there, as far as placeholders determine it.
  bool matches(std::span<const std::string> words) const;

 private:
  friend class UsageParser;
  friend class UsageMatcher;
  enum class Kind { word, sequence, choice, optional, repeated };
  struct Node {
    Kind kind = Kind::sequence;
    std::string text{};
    std::vector<Node> parts{};
  };
  Node root_;
};

/// Whether a word of a usage is a placeholder.
bool isPlaceholder(std::string_view word);

}  // namespace gt
