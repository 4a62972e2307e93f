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

/// How a program writes the packages and messages of a type.
struct TypeDescription {
  std::uint32_t type = 0;
  std::string name, schema;

  static TypeDescription of(const RepresentationType& type);
  static constexpr auto fields() {
    return Fields{field<&TypeDescription::type>("the type's id"),
                  field<&TypeDescription::name>("the schema's name"),
                  field<&TypeDescription::schema>("the schema's text")};
  }
};

/// How a program writes all its messages.
struct TypeDescriptions {
  std::uint32_t vocabulary = 0;
  std::vector<TypeDescription> types;

  static constexpr auto fields() {
    return Fields{field<&TypeDescriptions::vocabulary>("the vocabulary's id"),
                  field<&TypeDescriptions::types>()};
  }
};

/// The types of messages that a program knows, and their schemas.
class Vocabulary {
 public:
  /// Types that are not streamed are left out.
  explicit Vocabulary(const std::vector<const RepresentationType*>& types);

  /// Of the schemas: that of another program with the same ones is the same. Never 0.
  std::uint32_t id() const { return descriptions_.vocabulary; }
  const TypeDescriptions& descriptions() const { return descriptions_; }
  /// A type by its id; null if it is not among them.
  const RepresentationType* find(std::uint32_t type) const;

 private:
  std::vector<const RepresentationType*> types_;
  TypeDescriptions descriptions_;
};

/// Understands the messages of another program, which may be built from another version: types
/// whose schemas differ are read field by field, into values that hold what the type begins with.
class Interpreter {
 public:
  /// `own` is this program's vocabulary; null for who passes messages on as they are.
  explicit Interpreter(const Vocabulary* own) : own_{own} {}

  /// Whether messages written by a vocabulary can be taken: by this one's, by one that was learned,
  /// or by none that is told (0).
  bool knows(std::uint32_t vocabulary) const {
    return vocabulary == 0 || (own_ && vocabulary == own_->id()) ||
           vocabulary == theirs_.vocabulary;
  }
  void learn(TypeDescriptions theirs);
  /// What was learned last.
  const TypeDescriptions& theirs() const { return theirs_; }
  /// Appends messages as this program writes them. What cannot be read is left out, and reported.
  void take(const MessageQueue& messages, MessageQueue& to);
  /// News about the other program that was not yet reported to the user.
  std::vector<std::string> takeNews() { return std::exchange(news_, {}); }

 private:
  struct Foreign {
    const RepresentationType* type;
    std::optional<MessageDefinition> definition;  ///< Empty if it cannot be read.
    bool failed = false;                          ///< That a message cannot be read was reported.
  };

  void translate(const Message& message, Foreign& foreign, MessageQueue& to);

  const Vocabulary* own_;
  TypeDescriptions theirs_;
  std::map<std::uint32_t, Foreign> foreign_;
  std::vector<std::string> news_;
};

}  // namespace gt
