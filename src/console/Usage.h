#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gt {

/// The notation of a command's arguments: alternatives between |, optional parts in [ ], repeated
/// parts in { }, groups in ( ). Words that begin with a capital letter are placeholders; all others
/// are typed as they are.
class Usage {
 public:
  /// Greatest number of words that can match, since matching takes a stack that grows with them.
  static constexpr std::size_t mostWords = 1000;

  explicit Usage(std::string_view text);

  /// The possible next words behind some words.
  struct Next {
    std::vector<std::string> words;         ///< To be typed as they are.
    std::vector<std::string> placeholders;  ///< Names of the possible placeholders.
    /// Index of the word where a command begins that makes up the rest (placeholder COMMAND).
    std::optional<std::size_t> command{};
  };
  Next next(std::span<const std::string> before) const;
  /// Whether words match the usage. Placeholders match as far as their names restrict the words.
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
