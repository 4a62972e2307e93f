#include "console/Usage.h"

#include <algorithm>
#include <cctype>
#include <functional>

namespace gt {
namespace {

/// Words and brackets. Brackets inside a word, as in TASK[.SOLUTION].PATH, are part of it.
std::vector<std::string> tokensOf(std::string_view text) {
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ') {
      ++at;
    } else if (std::string_view{"([{|"}.find(text[at]) != std::string_view::npos) {
      tokens.emplace_back(1, text[at++]);
    } else {
      const std::size_t end = std::min(text.find(' ', at), text.size());
      std::string word{text.substr(at, end - at)};
      std::vector<std::string> closing;
      const auto closes = [&] {
        const char last = word.empty() ? ' ' : word.back();
        const char opens = last == ')' ? '(' : last == ']' ? '[' : last == '}' ? '{' : ' ';
        return opens != ' ' && std::ranges::count(word, opens) < std::ranges::count(word, last);
      };
      for (; closes(); word.pop_back()) closing.emplace_back(1, word.back());
      if (!word.empty()) tokens.push_back(word);
      tokens.insert(tokens.end(), closing.rbegin(), closing.rend());
      at = end;
    }
  }
  return tokens;
}

}  // namespace

bool isPlaceholder(std::string_view word) {
  return !word.empty() && std::isupper(static_cast<unsigned char>(word.front()));
}

class UsageParser {
 public:
  using Node = Usage::Node;
  using Kind = Usage::Kind;
  explicit UsageParser(std::string_view text) : tokens_{tokensOf(text)} {}

  Node readChoice() {
    Node choice{Kind::choice};
    do choice.parts.push_back(readSequence());
    while (take("|"));
    return choice;
  }

 private:
  Node readSequence() {
    Node sequence{Kind::sequence};
    while (at_ < tokens_.size() && tokens_[at_] != "|" && tokens_[at_] != ")" &&
           tokens_[at_] != "]" && tokens_[at_] != "}")
      sequence.parts.push_back(readItem());
    return sequence;
  }
  Node readItem() {
    for (const auto& [open, close, kind] : {std::tuple{"(", ")", Kind::sequence},
                                            {"[", "]", Kind::optional},
                                            {"{", "}", Kind::repeated}})
      if (take(open)) {
        Node group{kind, {}, {readChoice()}};
        take(close);
        return group;
      }
    return {Kind::word, tokens_[at_++]};
  }
  bool take(std::string_view token) {
    if (at_ >= tokens_.size() || tokens_[at_] != token) return false;
    ++at_;
    return true;
  }

  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
};

/// Follows all paths through a usage that match the words.
class UsageMatcher {
 public:
  using Node = Usage::Node;
  using Kind = Usage::Kind;
  using Goal = std::function<void(std::size_t at)>;
  explicit UsageMatcher(std::span<const std::string> words) : words_{words} {}

  bool matches(const Node& node) {
    match(node, 0, [this](std::size_t at) { whole_ |= at == words_.size(); });
    return whole_;
  }
  void match(const Node& node, std::size_t at, const Goal& then) {
    if (whole_) return;
    switch (node.kind) {
      case Kind::word:
        return matchWord(node.text, at, then);
      case Kind::sequence:
        return matchFrom(node, 0, at, then);
      case Kind::choice:
        for (const Node& part : node.parts) match(part, at, then);
        return;
      case Kind::optional:
        then(at);
        return match(node.parts.front(), at, then);
      case Kind::repeated:
        then(at);
        return match(node.parts.front(), at, [&](std::size_t next) {
          if (next > at) match(node, next, then);
        });
    }
  }
  Usage::Next take() { return std::move(next_); }

 private:
  void matchFrom(const Node& sequence, std::size_t part, std::size_t at, const Goal& then) {
    if (part == sequence.parts.size()) return then(at);
    match(sequence.parts[part], at,
          [&, part](std::size_t next) { matchFrom(sequence, part + 1, next, then); });
  }
  void matchWord(const std::string& word, std::size_t at, const Goal& then) {
    if (word == "COMMAND") next_.command = at;
    const bool text = word == "CONDITION" || word == "TEXT";  // of several words
    for (; at < words_.size(); ++at) {
      if (word == "COMMAND") return then(words_.size());
      if (text || (isPlaceholder(word) ? words_[at] != "?" : words_[at] == word)) then(at + 1);
      if (!text) return;
    }
    auto& found = isPlaceholder(word) ? next_.placeholders : next_.words;
    if (std::ranges::find(found, word) == found.end()) found.push_back(word);
  }

  std::span<const std::string> words_;
  Usage::Next next_;
  bool whole_ = false;
};

Usage::Usage(std::string_view text) : root_{UsageParser{text}.readChoice()} {}

Usage::Next Usage::next(std::span<const std::string> before) const {
  if (before.size() > mostWords) return {};
  UsageMatcher matcher{before};
  matcher.match(root_, 0, [](std::size_t) {});
  return matcher.take();
}

bool Usage::matches(std::span<const std::string> words) const {
  return words.size() <= mostWords && UsageMatcher{words}.matches(root_);
}

}  // namespace gt
