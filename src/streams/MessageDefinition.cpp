#include "streams/MessageDefinition.h"

#include <algorithm>
#include <array>
#include <map>

#include "base/Lines.h"
#include "base/Number.h"
#include "streams/Schema.h"

namespace gt {
namespace {

/// Guards against schemas that claim to be enormous.
constexpr std::size_t deepestNesting = 64, largestValue = 1u << 28;

struct Primitive {
  std::string_view name;
  Kind kind;
  Number number;
};
constexpr std::array primitives{Primitive{"bool", Kind::boolean, Number::uint8},
                                Primitive{"byte", Kind::number, Number::uint8},
                                Primitive{"char", Kind::number, Number::uint8},
                                Primitive{"int8", Kind::number, Number::int8},
                                Primitive{"uint8", Kind::number, Number::uint8},
                                Primitive{"int16", Kind::number, Number::int16},
                                Primitive{"uint16", Kind::number, Number::uint16},
                                Primitive{"int32", Kind::number, Number::int32},
                                Primitive{"uint32", Kind::number, Number::uint32},
                                Primitive{"int64", Kind::number, Number::int64},
                                Primitive{"uint64", Kind::number, Number::uint64},
                                Primitive{"float32", Kind::number, Number::float32},
                                Primitive{"float64", Kind::number, Number::float64},
                                Primitive{"string", Kind::text, Number::uint8}};

/// Takes the text up to the next blank.
std::string_view takeToken(std::string_view& text) {
  text = trimmed(text);
  const auto end = std::min(text.find_first_of(" \t"), text.size());
  const auto word = text.substr(0, end);
  text.remove_prefix(end);
  text = trimmed(text);
  return word;
}

/// package/msg/Name and package/Name are the same.
std::string shortName(std::string_view name) {
  std::string s{name};
  if (const auto at = s.find("/msg/"); at != s.npos) s.erase(at, 4);
  return s;
}

}  // namespace

/// Reads a schema line by line, then finds the records that its fields name.
class MessageDefinitionParser {
  using Field = MessageDefinition::Field;
  using Record = MessageDefinition::Record;

 public:
  MessageDefinitionParser(const std::string& name, std::string_view text)
      : name_{name}, lines_{text} {
    begin(shortName(name));
  }

  Result<MessageDefinition> parse() {
    while (const auto row = lines_.next()) {
      line_ = lines_.number();
      if (const auto done = readLine(trimmed(*row)); !done) return error(done.error().what);
    }
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (const auto done = resolve(i); !done) return done.error();
    depth_.assign(records().size(), 0);
    if (const auto done = measure(0, 1); !done) return error(done.error().what);
    return std::move(definition_);
  }

 private:
  struct Constant {
    std::string name;
    std::uint64_t value;
  };
  /// A field whose record is not known yet.
  struct Reference {
    std::size_t record, field;
    std::string type;
    int line;
  };

  std::vector<Record>& records() { return definition_.records_; }
  Error error(std::string what) const {
    return {.file = name_, .line = line_, .what = std::move(what)};
  }

  void begin(const std::string& name) {
    records().push_back({name, {}, 0});
    recordOf_.emplace(name, records().size() - 1);
    constants_.clear();
  }

  Result<void> readLine(std::string_view row) {
    if (row.empty() || row.front() == '#') return {};
    if (row.front() == '=' && row.find_first_not_of('=') == row.npos) return {};
    if (row.starts_with("MSG:")) {
      begin(shortName(trimmed(row.substr(4))));
      return {};
    }
    std::string_view rest = row;
    const std::string_view type = takeToken(rest);
    const std::string_view code = trimmed(rest.substr(0, rest.find('#')));
    if (code.empty()) return error("expected a type and a name");
    const auto end = std::min(code.find_first_of(" \t="), code.size());
    const std::string_view name = code.substr(0, end), behind = trimmed(code.substr(end));
    if (!behind.empty() && behind.front() == '=') {
      readConstant(name, trimmed(behind.substr(1)));
      return {};
    }
    const auto comment = rest.find('#');
    return readField(type, name, comment == rest.npos ? "" : rest.substr(comment + 1));
  }

  void readConstant(std::string_view name, std::string_view text) {
    if (const auto value = numberFrom<std::uint64_t>(text))
      constants_.push_back({std::string{name}, *value});
  }

  Result<void> readField(std::string_view type, std::string_view name, std::string_view comment) {
    Field field;
    field.name = name;
    std::string_view element = type;
    if (const auto bracket = type.find('['); bracket != type.npos) {
      element = type.substr(0, bracket);
      if (auto done = readSize(type.substr(bracket), field); !done) return done;
    }
    // A bound of a text's or a list's length does not change how it is written.
    element = element.substr(0, element.find("<="));
    const auto primitive = std::find_if(primitives.begin(), primitives.end(),
                                        [&](const Primitive& p) { return p.name == element; });
    if (primitive != primitives.end()) {
      field.kind = primitive->kind;
      field.number = primitive->number;
    } else {
      field.kind = Kind::record;
      names_.push_back(
          {records().size() - 1, records().back().fields.size(), std::string{element}, line_});
    }
    takeConstants(field);
    if (field.size == MessageDefinition::Size::array) readIndexNames(comment, field);
    records().back().fields.push_back(std::move(field));
    return {};
  }

  Result<void> readSize(std::string_view text, Field& field) {
    const auto end = text.find(']');
    if (end == text.npos || end + 1 != text.size())
      return error("expected TYPE[], TYPE[N] or TYPE[<=N]");
    const std::string_view inside = text.substr(1, end - 1);
    if (inside.empty() || inside.starts_with("<=")) {
      field.size = MessageDefinition::Size::list;
      return {};
    }
    const auto count = numberFrom<std::size_t>(inside);
    if (!count) return error("expected a number between the brackets");
    if (*count > largestValue) return error("the array is too large");
    field.count = *count;
    field.size = MessageDefinition::Size::array;
    return {};
  }

  /// The constants before a field that begin with its name and count from 0 are its enumeration.
  void takeConstants(Field& field) {
    const std::string prefix = upperCase(field.name) + "_";
    for (const Constant& constant : constants_)
      if (constant.name.starts_with(prefix) && constant.value == field.names.size())
        field.names.push_back(constant.name.substr(prefix.size()));
    constants_.clear();
  }

  /// "…; of redTeam blueTeam" at a comment's end names the elements (see schemaOf).
  static void readIndexNames(std::string_view comment, Field& field) {
    const auto semicolon = comment.rfind(';');
    std::string_view last = semicolon == comment.npos ? comment : comment.substr(semicolon + 1);
    if (takeToken(last) != "of") return;
    while (!last.empty()) field.indexNames.emplace_back(snakeCase(takeToken(last)));
    if (field.indexNames.size() != field.count) field.indexNames.clear();
  }

  Result<void> resolve(std::size_t i) {
    const Reference& reference = names_[i];
    auto found = recordOf_.find(shortName(reference.type));
    if (found == recordOf_.end()) {
      // Within a package its name may be left out.
      const std::string& owner = records()[reference.record].name;
      found = recordOf_.find(owner.substr(0, owner.find('/') + 1) + reference.type);
    }
    if (found == recordOf_.end())
      return Error{.file = name_,
                   .line = reference.line,
                   .what = "the schema does not define " + reference.type};
    records()[reference.record].fields[reference.field].record = found->second;
    return {};
  }

  /// Computes the least size of a record and of all in it.
  Result<void> measure(std::size_t index, std::size_t depth) {
    if (depth > deepestNesting) return error(records()[index].name + " is nested too deeply");
    if (records()[index].leastSize > 0 && depth_[index] >= depth) return {};
    depth_[index] = depth;
    std::size_t size = 0;
    for (const Field& field : records()[index].fields) {
      if (field.kind == Kind::record)
        if (auto done = measure(field.record, depth + 1); !done) return done;
      const std::size_t least =
          field.size == MessageDefinition::Size::list
              ? 4
              : definition_.leastSize(field) *
                    (field.size == MessageDefinition::Size::array ? field.count : 1);
      size += least;
      if (size > largestValue) return error(records()[index].name + " is too large");
    }
    records()[index].leastSize = std::max<std::size_t>(size, 1);
    return {};
  }

  std::string name_;
  LineReader lines_;
  int line_ = 0;
  MessageDefinition definition_;
  std::map<std::string, std::size_t> recordOf_;
  std::vector<Constant> constants_;
  std::vector<Reference> names_;
  std::vector<std::size_t> depth_;  ///< Of each record: the deepest place at which it was measured.
};

Result<MessageDefinition> MessageDefinition::parse(const std::string& name, std::string_view text) {
  return MessageDefinitionParser{name, text}.parse();
}

std::size_t MessageDefinition::leastSize(const Field& field) const {
  switch (field.kind) {
    case Kind::boolean:
      return 1;
    case Kind::number:
      return numberSize(field.number);
    case Kind::text:
      return 4;
    default:
      return records_[field.record].leastSize;
  }
}

}  // namespace gt
