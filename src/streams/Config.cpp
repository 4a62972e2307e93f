#include "streams/Config.h"

#include <algorithm>
#include <set>

#include "base/Lines.h"
#include "base/Number.h"

namespace gt::detail {
namespace {

/// The content of a line of a config file.
struct ConfigLine {
  std::string section;      ///< Set if the line begins a section.
  std::string name;         ///< Empty for sections.
  std::vector<Word> words;  ///< The value.
  std::string_view rest;    ///< The value as it was written.
};

Error wrong(std::string what) {
  return {.what = std::move(what)};
}

std::string joined(std::string_view prefix, std::string_view name) {
  std::string path{prefix};
  if (!path.empty() && !name.empty()) path += '.';
  return path += name;
}

/// The name in a line [NAME]; no value if the line does not begin so.
std::optional<std::string_view> sectionOf(std::string_view line) {
  if (!line.starts_with('[')) return std::nullopt;
  if (!line.ends_with(']')) return std::string_view{};
  return trimmed(line.substr(1, line.size() - 2));
}

Result<ConfigLine> parseLine(std::string_view text) {
  ConfigLine line;
  if (const auto section = sectionOf(text)) {
    if (section->empty()) return wrong("expected [section]");
    line.section = *section;
    return line;
  }
  const auto end = std::min(text.find_first_of(" \t="), text.size());
  line.name = text.substr(0, end);
  text = trimmed(text.substr(end));
  if (text.starts_with('=')) text = trimmed(text.substr(1));
  if (line.name.empty()) return wrong("expected a name");
  line.rest = text;
  auto words = wordsOf(text);
  if (!words) return Error{.field = line.name, .what = words.error().what};
  line.words = std::move(*words);
  return line;
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

/// Goes to the element of an array or list that a step of a path names, by number or by the index's
/// name. An index of one beyond a list's end makes it longer if `grow` allows it.
Result<void> stepInto(Place& place, std::string_view step, bool grow) {
  const Type& type = *place.value.type;
  std::size_t i = 0;
  while (i < type.indexNames.size() && type.indexNames[i] != step) ++i;
  if (type.indexNames.empty() || i == type.indexNames.size()) {
    const auto index = numberFrom<std::size_t>(step);
    if (!index) return wrong("expected an index instead of " + std::string(step));
    i = *index;
  }
  const std::size_t size = place.value.size();
  if (grow && type.kind == Kind::list && i == size)
    type.resize(place.value.data, size + 1);
  else if (i >= size)
    return wrong("there is no element " + std::string(step) + ", only " + std::to_string(size));
  place.value = place.value.element(i);
  return {};
}

Result<Place> find(Value root, std::string_view path, bool grow) {
  Place place{root, {}};
  while (!path.empty()) {
    const auto dot = std::min(path.find('.'), path.size());
    const std::string_view step = path.substr(0, dot);
    path.remove_prefix(std::min(dot + 1, path.size()));
    const Type& type = *place.value.type;
    if (type.kind == Kind::array || type.kind == Kind::list) {
      if (const auto done = stepInto(place, step, grow); !done) return done.error();
      continue;
    }
    if (type.kind != Kind::record)
      return wrong("unknown name: this is one value, not a group of fields");
    const auto part = std::ranges::find(type.parts, step, &Part::name);
    if (part == type.parts.end())
      return wrong("unknown name; " + std::string(type.name) + " has " + knownNames(type));
    const Range range = part->range.bounds() ? part->range : place.info.range;
    place = {place.value.part(*part), *part};
    place.info.range = range;
  }
  return place;
}

/// Sets a flat value from words, of which there are as many as it needs.
Result<void> setWords(Value value, Range range, const Word*& word) {
  const Type& type = *value.type;
  if (type.kind == Kind::record) {
    for (const Part& p : type.parts)
      if (auto done = setWords(value.part(p), range, word); !done) return done;
    return {};
  }
  if (type.kind == Kind::array || type.kind == Kind::list) {
    for (std::size_t i = 0; i < value.size(); ++i)
      if (auto done = setWords(value.element(i), range, word); !done) return done;
    return {};
  }
  const std::string& text = word++->text;
  if (const auto done = setScalar(value, text, range); !done)
    return wrong(done.error().what + " instead of " + (text.empty() ? "nothing" : text));
  return {};
}

Result<void> setFlat(const Place& place, const ConfigLine& line) {
  const Type& type = *place.value.type;
  if (!isFlat(type)) return wrong("is a group of fields; name one of them");
  const std::size_t given = line.words.size();
  if (type.kind == Kind::text && given > 1) {
    if (line.words[0].quoted) return wrong("expected one text");
    return setScalar(place.value, line.rest);
  }
  if (type.kind == Kind::list) {
    const std::size_t each = width(type.element());
    if (given % each != 0)
      return wrong("expected a multiple of " + std::to_string(each) + " values instead of " +
                   std::to_string(given));
    type.resize(place.value.data, given / each);
  } else if (given != width(type)) {
    if (given == 0) return wrong("its value is missing");
    return wrong("expected " + std::to_string(width(type)) + " value" +
                 (width(type) == 1 ? "" : "s") + " instead of " + std::to_string(given));
  }
  const Word* word = line.words.data();
  return setWords(place.value, place.info.range, word);
}

/// Reads the lines of one text into a value.
class ConfigReader {
 public:
  ConfigReader(const ConfigOptions& options, Value root) : options_{options}, root_{root} {}

  /// The error's field is where it is.
  Result<void> read(std::string_view text) {
    if (const auto section = sectionOf(text)) {
      section_ = *section;
      selected_ = options_.section.empty() ? !options_.common : options_.section == section_;
      found_ = found_ || selected_;
    }
    if (!selected_) return {};
    const auto at = [](std::string path, const Result<void>& done) -> Result<void> {
      if (done) return done;
      return Error{.field = std::move(path), .what = done.error().what};
    };
    const auto line = parseLine(text);
    const std::string prefix = options_.section.empty() ? section_ : "";
    if (!line) return at(joined(prefix, line.error().field), line.error());
    if (!line->section.empty()) {
      if (!options_.section.empty()) return {};
      const auto place = find(root_, line->section, true);
      selected_ = static_cast<bool>(place);  // what follows would be wrong for the same reason
      return at(line->section, place ? Result<void>{} : place.error());
    }
    const std::string path = joined(prefix, line->name);
    if (!seen_.insert(path).second) return at(path, wrong("is given twice"));
    const auto place = find(root_, path, true);
    return at(path, place ? setFlat(*place, *line) : place.error());
  }

  bool foundSection() const { return found_; }

 private:
  const ConfigOptions& options_;
  Value root_;
  std::string section_;
  std::set<std::string> seen_;
  bool selected_ = options_.section.empty();
  bool found_ = false;
};

void flatText(ConstValue value, std::string& out) {
  const Type& type = value.type();
  if (type.kind == Kind::record)
    for (const Part& p : type.parts) flatText(value.part(p), out);
  else if (type.kind == Kind::array || type.kind == Kind::list)
    for (std::size_t i = 0; i < value.size(); ++i) flatText(value.element(i), out);
  else
    (out += ' ') += type.kind == Kind::text ? quotedWord(scalarText(value)) : scalarText(value);
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

Findings parseConfig(std::string_view text, const std::string& source, const ConfigOptions& options,
                     Value value) {
  constexpr std::size_t most = 100;  // errors that a person reads
  Findings findings;
  ConfigReader reader{options, value};
  for (const Line& line : linesOf(text)) {
    const auto done = reader.read(line.text);
    if (done) continue;
    findings.add({.file = source,
                  .line = line.number,
                  .field = done.error().field,
                  .what = done.error().what});
    if (findings.errors() == most) return findings;
  }
  if (!options.section.empty() && !reader.foundSection())
    findings.add(
        {.file = source, .field = "[" + options.section + "]", .what = "there is no such section"});
  return findings;
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
  const auto failed = [&](const Error& error) {
    return Error{.field = std::string(path), .what = error.what};
  };
  const auto place = find(root, path, false);
  if (!place) return failed(place.error());
  const std::string_view rest = trimmed(text);
  auto words = wordsOf(rest);
  if (!words) return failed(words.error());
  const auto done = setFlat(*place, {"", "", std::move(*words), rest});
  return done ? done : failed(done.error());
}

Result<std::string> getByPath(ConstValue root, std::string_view path) {
  const auto place = find(writable(root), path, false);
  if (!place || !isFlat(*place->value.type))
    return Error{.field = std::string(path),
                 .what = place ? "is a group of fields; name one of them" : place.error().what};
  std::string text;
  flatText(place->value, text);
  return text.empty() ? text : text.substr(1);
}

std::vector<ConfigSection> configSections(std::string_view text) {
  std::vector<ConfigSection> sections;
  for (const Line& line : linesOf(text))
    if (const auto name = sectionOf(line.text))
      sections.push_back({std::string{*name}, line.number});
  return sections;
}

std::vector<PathInfo> paths(ConstValue root) {
  std::vector<PathInfo> all;
  forEachPath(writable(root), {}, "",
              [&](const std::string& path, const PartInfo& info, Value value) {
                all.push_back({path, info, value});
              });
  return all;
}

}  // namespace gt::detail
