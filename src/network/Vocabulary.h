#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framework/Representation.h"
#include "streams/MessageDefinition.h"

namespace gt {

/// The schema that a program uses to write packages and messages of a type.
struct TypeDescription {
  std::uint32_t type = 0;
  std::string name, schema;

  static TypeDescription of(const RepresentationType& type);
  static constexpr auto fields() {
    return Fields{field<&TypeDescription::type>("id of the type"),
                  field<&TypeDescription::name>("name of the schema"),
                  field<&TypeDescription::schema>("text of the schema")};
  }
};

/// The schemas of all messages that a program writes.
struct TypeDescriptions {
  std::uint32_t vocabulary = 0;
  std::vector<TypeDescription> types;

  static constexpr auto fields() {
    return Fields{field<&TypeDescriptions::vocabulary>("id of the vocabulary"),
                  field<&TypeDescriptions::types>()};
  }
};

/// The message types that a program knows, with their schemas.
class Vocabulary {
 public:
  /// Types that are not streamed are ignored.
  explicit Vocabulary(const std::vector<const RepresentationType*>& types);

  /// Id of the schemas: vocabularies with the same schemas have the same id. Never 0.
  std::uint32_t id() const { return descriptions_.vocabulary; }
  const TypeDescriptions& descriptions() const { return descriptions_; }
  /// Returns a type by its id; null if it is not in the vocabulary.
  const RepresentationType* find(std::uint32_t type) const;

 private:
  std::vector<const RepresentationType*> types_;
  TypeDescriptions descriptions_;
};

/// Reads the messages of another program, which may be built from another version. Types with
/// different schemas are read field by field; fields that the other program does not write keep
/// their default values.
class Interpreter {
 public:
  /// `own` is this program's vocabulary; null for programs that transfer messages unchanged.
  explicit Interpreter(const Vocabulary* own) : own_{own} {}

  /// Whether messages of a vocabulary can be read: the own vocabulary, one that was received, or
  /// one that is not stated (0).
  bool knows(std::uint32_t vocabulary) const {
    return vocabulary == 0 || (own_ && vocabulary == own_->id()) ||
           vocabulary == theirs_.vocabulary;
  }
  void learn(TypeDescriptions theirs);
  /// The vocabulary that was received last.
  const TypeDescriptions& theirs() const { return theirs_; }
  /// Appends messages, converted to the own vocabulary. Unreadable messages are skipped and
  /// reported.
  void take(const MessageQueue& messages, MessageQueue& to);
  /// News about the other program that were not yet reported to the user.
  std::vector<std::string> takeNews() { return std::exchange(news_, {}); }

 private:
  struct Foreign {
    const RepresentationType* type;
    std::optional<MessageDefinition> definition;  ///< Empty if the schema cannot be read.
    bool failed = false;                          ///< Whether an unreadable message was reported.
  };

  void translate(const Message& message, Foreign& foreign, MessageQueue& to);

  const Vocabulary* own_;
  TypeDescriptions theirs_;
  std::map<std::uint32_t, Foreign> foreign_;
  std::vector<std::string> news_;
};

}  // namespace gt
