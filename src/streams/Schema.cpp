#include "streams/Schema.h"

#include <algorithm>

#include "base/Number.h"

namespace gt {
namespace {

constexpr std::string_view package = "gt2003_msgs";

bool isUpper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || isUpper(c);
}
char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string numberName(Number number) {
  constexpr std::string_view names[] = {"int8",   "uint8", "int16",  "uint16",  "int32",
                                        "uint32", "int64", "uint64", "float32", "float64"};
  return std::string(names[static_cast<std::size_t>(number)]);
}

/// A name for a type's message: letters and digits, the first one a capital.
std::string messageName(const Type& type) {
  if (type.kind == Kind::array) return "ArrayOf" + messageName(type.element());
  if (type.kind == Kind::list) return "ListOf" + messageName(type.element());
  const std::string name =
      type.kind == Kind::number ? numberName(type.number) : std::string(type.name);
  std::string s;
  for (const char c : name)
    if (isLetter(c) || isDigit(c)) s += s.empty() ? upper(c) : c;
  return s;
}

/// What is to be known about a field, as the comment behind it.
std::string comment(const PartInfo& info, const Type& type) {
  std::vector<std::string> parts;
  if (!info.unit.empty()) parts.emplace_back(info.unit);
  if (!info.doc.empty()) parts.emplace_back(info.doc);
  if (info.range.bounds())
    parts.push_back("from " + numberText(info.range.low) + " to " + numberText(info.range.high));
  if (!type.indexNames.empty()) {
    std::string s = "of";
    for (const auto name : type.indexNames) (s += ' ') += name;
    parts.push_back(s);
  }
  std::string s;
  for (const auto& p : parts) (s += s.empty() ? "  # " : "; ") += p;
  return s;
}

/// Writes the schema of one type and of all that it consists of.
class SchemaWriter {
 public:
  explicit SchemaWriter(const Type& root) : schema_{"", ""} {
    const std::string name = nameOf(root);
    schema_.name = std::string(package) + "/msg/" + name;
    for (std::size_t i = 0; i < messages_.size(); ++i) {
      const Message message = messages_[i];
      if (i > 0)
        schema_.text +=
            std::string(80, '=') + "\nMSG: " + std::string(package) + "/" + message.name + "\n";
      write(*message.type);
    }
  }

  Schema schema() const { return schema_; }

 private:
  struct Message {
    const Type* type;
    std::string name;
  };

  /// The name of a type's message, which is distinguished from other types of that name.
  std::string nameOf(const Type& type) {
    for (const Message& m : messages_)
      if (m.type == &type) return m.name;
    const std::string plain = messageName(type);
    std::string name = plain;
    for (int i = 2; isTaken(name); ++i) name = plain + std::to_string(i);
    messages_.push_back({&type, name});
    return name;
  }

  bool isTaken(const std::string& name) const {
    return std::any_of(messages_.begin(), messages_.end(),
                       [&](const Message& m) { return m.name == name; });
  }

  /// How a type is called that is neither an array nor a list.
  std::string singleName(const Type& type) {
    switch (type.kind) {
      case Kind::boolean:
        return "bool";
      case Kind::number:
        return numberName(type.number);
      case Kind::enumeration:
        return "uint8";
      case Kind::text:
        return "string";
      default:
        return std::string(package) + "/" + nameOf(type);
    }
  }

  std::string fieldType(const Type& type) {
    if (type.kind == Kind::array)
      return singleName(type.element()) + "[" + std::to_string(type.count) + "]";
    return type.kind == Kind::list ? singleName(type.element()) + "[]" : singleName(type);
  }

  void write(const Type& type) {
    if (type.kind == Kind::record)
      for (const Part& p : type.parts) writeField(p, p.type());
    else
      writeField(
          {type.kind == Kind::array || type.kind == Kind::list ? "values" : "value", "", "", {}},
          type);
  }

  void writeField(const PartInfo& info, const Type& type) {
    const bool many = type.kind == Kind::array || type.kind == Kind::list;
    const std::string name = snakeCase(info.name);
    writeConstants(name, many ? type.element() : type);
    schema_.text += fieldType(type) + " " + name + comment(info, type) + "\n";
  }

  void writeConstants(const std::string& name, const Type& type) {
    for (std::size_t i = 0; i < type.names.size(); ++i) {
      const std::string constant = upperCase(name + "_" + snakeCase(type.names[i]));
      schema_.text += "uint8 " + constant + "=" + std::to_string(i) + "\n";
    }
  }

  Schema schema_;
  std::vector<Message> messages_;
};

}  // namespace

std::string snakeCase(std::string_view name) {
  std::string s;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    // A word begins at a capital behind a small letter, or at the last of several capitals.
    const bool begins = i > 0 && isUpper(c) &&
                        (!isUpper(name[i - 1]) ||
                         (i + 1 < name.size() && isLetter(name[i + 1]) && !isUpper(name[i + 1])));
    if (begins && !s.empty() && s.back() != '_') s += '_';
    if (isUpper(c))
      s += static_cast<char>(c - 'A' + 'a');
    else if (isLetter(c) || isDigit(c) || (c == '_' && !s.empty() && s.back() != '_'))
      s += c;
  }
  return s;
}

std::string upperCase(std::string_view text) {
  std::string s{text};
  std::ranges::transform(s, s.begin(), upper);
  return s;
}

Schema detail::schemaOf(const Type& type) {
  return SchemaWriter{type}.schema();
}

RosTime RosTime::of(Time time) {
  const std::int64_t ms = std::max<std::int64_t>(time.ms, 0);
  return {static_cast<std::int32_t>(ms / 1000), static_cast<std::uint32_t>(ms % 1000 * 1'000'000)};
}

Schema CompressedImage::schema() {
  const std::string line = std::string(80, '=') + "\n";
  return {"sensor_msgs/msg/CompressedImage",
          "std_msgs/Header header\nstring format\nuint8[] data\n" + line +
              "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + line +
              "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n"};
}

}  // namespace gt
