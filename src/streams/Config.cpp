#include "streams/Config.h"

#include <charconv>
#include <set>

namespace gt::detail {
namespace {

constexpr std::string_view blanks = " \t\r";

/// A word of a line; quoted ones may hold anything.
struct Token {
  std::string text;
  bool quoted = false;
};

/// What a line of a config file says.
struct Line {
  std::string section;  ///< Set if the line begins a section.
  std::string name;     ///< Empty for sections and for lines without content.
  std::vector<Token> tokens;
  std::string rest;  ///< The tokens as they were written.
};

std::string_view trimmed(std::string_view s) {
  const auto begin = s.find_first_not_of(blanks);
  if (begin == s.npos) return {};
  return s.substr(begin, s.find_last_not_of(blanks) - begin + 1);
}

std::string joined(std::string_view prefix, std::string_view name) {
  std::string path{prefix};
  if (!path.empty() && !name.empty()) path += '.';
  return path += name;
}

/// Where a comment begins: at `//` or `#` after a blank or at the line's begin, outside quotes.
std::size_t commentBegin(std::string_view s) {
  bool quoted = false;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (quoted && s[i] == '\\')
      ++i;
    else if (s[i] == '"')
      quoted = !quoted;
    else if (!quoted && (i == 0 || blanks.find(s[i - 1]) != blanks.npos) &&
             (s[i] == '#' || s.substr(i, 2) == "//"))
      return i;
  }
  return s.size();
}

/// Takes a quoted word from the begin of s; false if it has no end.
bool takeQuoted(std::string_view& s, Token& token) {
  token.quoted = true;
  for (std::size_t i = 1; i < s.size(); ++i) {
    if (s[i] == '"') {
      s.remove_prefix(i + 1);
      return true;
    }
    if (s[i] == '\\' && i + 1 < s.size()) {
      const char c = s[++i];
      token.text += c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c == '0' ? '\0' : c;
    } else
      token.text += s[i];
  }
  return false;
}

std::optional<std::string> takeTokens(std::string_view s, std::vector<Token>& tokens) {
  for (s = trimmed(s); !s.empty(); s = trimmed(s)) {
    Token token;
    if (s.front() == '"') {
      if (!takeQuoted(s, token)) return "the closing quote is missing";
    } else {
      const auto end = std::min(s.find_first_of(blanks), s.size());
      token.text = s.substr(0, end);
      s.remove_prefix(end);
    }
    tokens.push_back(std::move(token));
  }
  return std::nullopt;
}

std::optional<std::string> parseLine(std::string_view s, Line& line) {
  s = trimmed(s.substr(0, commentBegin(s)));
  if (s.empty()) return std::nullopt;
  if (s.front() == '[') {
    line.section = s.back() == ']' ? trimmed(s.substr(1, s.size() - 2)) : "";
    return line.section.empty() ? std::optional<std::string>("expected [section]") : std::nullopt;
  }
  const auto end = std::min(s.find_first_of(" \t="), s.size());
  line.name = s.substr(0, end);
  s = trimmed(s.substr(end));
  if (s.starts_with('=')) s = trimmed(s.substr(1));
  if (line.name.empty()) return "expected a name";
  line.rest = s;
  return takeTokens(s, line.tokens);
}

std::string quoted(const std::string& text) {
  const bool plain = !text.empty() && text.find_first_of(" \t\r\n\"\\#/=[") == text.npos &&
                     text.find('\0') == text.npos;
  if (plain) return text;
  std::string s = "\"";
  for (const char c : text) {
    const auto i = std::string_view("\"\\\n\t\r\0", 6).find(c);
    if (i == std::string_view::npos)
      s += c;
    else
      (s += '\\') += "\"\\ntr0"[i];
  }
  return s + '"';
}

/// A field that was found by its path.
struct Place {
  Value value;
  PartInfo info;
};

std::string knownNames(const Type& type) {
  std::string s;
  for (const Part& p : type.parts) s += (s.empty() ? "" : ", ") + std::string(p.name);
  return s;
}

/// The element of an array or list that a step of a path names, by number or by the index's name.
/// An index of one beyond a list's end makes it longer if `grow` allows it.
std::optional<std::string> stepInto(Place& place, std::string_view step, bool grow) {
  const Type& type = *place.value.type;
  std::size_t i = 0;
  while (i < type.indexNames.size() && type.indexNames[i] != step) ++i;
  if (type.indexNames.empty() || i == type.indexNames.size()) {
    const auto [end, failure] = std::from_chars(step.data(), step.data() + step.size(), i);
    if (failure != std::errc{} || end != step.data() + step.size())
      return "expected an index instead of " + std::string(step);
  }
  const std::size_t size = place.value.size();
  if (grow && type.kind == Kind::list && i == size)
    type.resize(place.value.data, size + 1);
  else if (i >= size)
    return "there is no element " + std::string(step) + ", only " + std::to_string(size);
  place.value = place.value.element(i);
  return std::nullopt;
}

std::optional<std::string> find(Value root, std::string_view path, bool grow, Place& place) {
  place = {root, {}};
  while (!path.empty()) {
    const auto dot = std::min(path.find('.'), path.size());
    const std::string_view step = path.substr(0, dot);
    path.remove_prefix(std::min(dot + 1, path.size()));
    const Type& type = *place.value.type;
    if (type.kind == Kind::array || type.kind == Kind::list) {
      if (auto what = stepInto(place, step, grow)) return what;
      continue;
    }
    if (type.kind != Kind::record) return "unknown name: this is one value, not a group of fields";
    const auto part = std::find_if(type.parts.begin(), type.parts.end(),
                                   [&](const Part& p) { return p.name == step; });
    if (part == type.parts.end())
      return "unknown name; " + std::string(type.name) + " has " + knownNames(type);
    const Range range = part->range.bounds() ? part->range : place.info.range;
    place = {place.value.part(*part), *part};
    place.info.range = range;
  }
  return std::nullopt;
}

/// Sets a flat value from words, of which there are as many as it needs.
std::optional<std::string> setTokens(Value value, Range range, const Token*& token) {
  const Type& type = *value.type;
  std::optional<std::string> what;
  if (type.kind == Kind::record)
    for (const Part& p : type.parts) {
      if (what) break;
      what = setTokens(value.part(p), range, token);
    }
  else if (type.kind == Kind::array || type.kind == Kind::list)
    for (std::size_t i = 0; i < value.size() && !what; ++i)
      what = setTokens(value.element(i), range, token);
  else {
    what = setScalar(value, token->text, range);
    if (what) *what += " instead of " + (token->text.empty() ? "nothing" : token->text);
    ++token;
  }
  return what;
}

std::optional<std::string> setFlat(const Place& place, const Line& line) {
  const Type& type = *place.value.type;
  if (!isFlat(type)) return "is a group of fields; name one of them";
  const std::size_t given = line.tokens.size();
  if (type.kind == Kind::text && given > 1) {
    if (line.tokens[0].quoted) return "expected one text";
    return setScalar(place.value, line.rest);
  }
  if (type.kind == Kind::list) {
    const std::size_t each = width(type.element());
    if (given % each != 0)
      return "expected a multiple of " + std::to_string(each) + " values instead of " +
             std::to_string(given);
    type.resize(place.value.data, given / each);
  } else if (given != width(type))
    return given == 0 ? std::string("its value is missing")
                      : "expected " + std::to_string(width(type)) + " value" +
                            (width(type) == 1 ? "" : "s") + " instead of " + std::to_string(given);
  const Token* token = line.tokens.data();
  return setTokens(place.value, place.info.range, token);
}

/// Reads the lines of one text into a value.
class ConfigReader {
 public:
  ConfigReader(const ConfigOptions& options, Value root) : options_{options}, root_{root} {}

  /// Tells what is wrong with a line, and sets `field` to where.
  std::optional<std::string> read(std::string_view text, std::string& field) {
    Line line;
    auto what = parseLine(text, line);
    if (!line.section.empty()) return begin(line.section, field);
    const bool selected = options_.section.empty() || section_ == options_.section;
    const std::string path = joined(options_.section.empty() ? section_ : "", line.name);
    field = path;
    if (what || line.name.empty() || !selected) return what;
    if (!seen_.insert(path).second) return "is given twice";
    Place place;
    what = find(root_, path, true, place);
    return what ? what : setFlat(place, line);
  }

  bool foundSection() const { return found_; }

 private:
  std::optional<std::string> begin(const std::string& section, std::string& field) {
    section_ = field = section;
    found_ = found_ || section == options_.section;
    Place place;
    if (!options_.section.empty()) return std::nullopt;
    return find(root_, section, true, place);
  }

  const ConfigOptions& options_;
  Value root_;
  std::string section_;
  std::set<std::string> seen_;
  bool found_ = false;
};

void flatText(ConstValue value, std::string& out) {
  const Type& type = value.type();
  if (type.kind == Kind::record)
    for (const Part& p : type.parts) flatText(value.part(p), out);
  else if (type.kind == Kind::array || type.kind == Kind::list)
    for (std::size_t i = 0; i < value.size(); ++i) flatText(value.element(i), out);
  else
    (out += ' ') += type.kind == Kind::text ? quoted(scalarText(value)) : scalarText(value);
}

/// Calls visit(path, info, value) for all flat values below a value.
template <typename Visit>
void forEachPath(Value value, const PartInfo& info, const std::string& path, Visit&& visit) {
  const Type& type = *value.type;
  if (isFlat(type))
    visit(path, info, value);
  else if (type.kind == Kind::record)
    for (const Part& p : type.parts) forEachPath(value.part(p), p, joined(path, p.name), visit);
  else
    for (std::size_t i = 0; i < value.size(); ++i) {
      const bool named = i < type.indexNames.size();
      forEachPath(value.element(i), info,
                  joined(path, named ? std::string(type.indexNames[i]) : std::to_string(i)), visit);
    }
}

Value writable(ConstValue value) {
  return {&value.type(), const_cast<void*>(value.data())};
}

}  // namespace

Result<void> parseConfig(std::string_view text, const std::string& source,
                         const ConfigOptions& options, Value value) {
  ConfigReader reader{options, value};
  for (int number = 1; !text.empty(); ++number) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string field;
    if (const auto what = reader.read(text.substr(0, end), field))
      return Error{source, number, field, *what};
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!options.section.empty() && !reader.foundSection())
    return Error{source, 0, "[" + options.section + "]", "there is no such section"};
  return {};
}

void writeConfig(ConstValue value, std::string& out) {
  forEachPath(writable(value), {}, "", [&](const std::string& path, const PartInfo& info, Value v) {
    std::string comment{info.unit};
    if (!info.doc.empty()) comment += (comment.empty() ? "" : ": ") + std::string(info.doc);
    if (!comment.empty()) out += "// " + comment + '\n';
    out += path;
    flatText(v, out);
    out += '\n';
  });
}

Result<void> setByPath(Value root, std::string_view path, std::string_view text) {
  Place place;
  Line line;
  line.rest = trimmed(text);
  auto what = find(root, path, false, place);
  if (!what) what = takeTokens(line.rest, line.tokens);
  if (!what) what = setFlat(place, line);
  if (what) return Error{"", 0, std::string(path), *what};
  return {};
}

Result<std::string> getByPath(ConstValue root, std::string_view path) {
  Place place;
  auto what = find(writable(root), path, false, place);
  if (!what && !isFlat(*place.value.type)) what = "is a group of fields; name one of them";
  if (what) return Error{"", 0, std::string(path), *what};
  std::string text;
  flatText(place.value, text);
  return text.empty() ? text : text.substr(1);
}

std::vector<PathInfo> paths(Value root) {
  std::vector<PathInfo> all;
  forEachPath(root, {}, "", [&](const std::string& path, const PartInfo& info, Value value) {
    all.push_back({path, info, value});
  });
  return all;
}

}  // namespace gt::detail
