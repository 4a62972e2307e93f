#include "network/Vocabulary.h"

#include <algorithm>

#include "streams/RecordedMessage.h"

namespace gt {
namespace {

/// A program that describes its types again and again is not reported without end.
constexpr std::size_t mostUnreportedNews = 100;

void addNews(std::vector<std::string>& news, std::string line) {
  if (news.size() < mostUnreportedNews) news.push_back(std::move(line));
}

}  // namespace

TypeDescription TypeDescription::of(const RepresentationType& type) {
  Schema schema = type.schema();
  return {type.id, std::move(schema.name), std::move(schema.text)};
}

Vocabulary::Vocabulary(const std::vector<const RepresentationType*>& types) {
  for (const RepresentationType* type : types)
    if (type->type() && std::ranges::find(types_, type) == types_.end()) types_.push_back(type);
  std::ranges::sort(types_, {}, [](const RepresentationType* type) { return type->id; });
  std::uint32_t id = hashOf("");
  for (const RepresentationType* type : types_) {
    const TypeDescription& description =
        descriptions_.types.emplace_back(TypeDescription::of(*type));
    id = hashOf(description.schema, hashOf(description.name, id));
  }
  descriptions_.vocabulary = std::max(id, 1u);
}

const RepresentationType* Vocabulary::find(std::uint32_t type) const {
  const auto found = std::ranges::find_if(
      types_, [&](const RepresentationType* candidate) { return candidate->id == type; });
  return found == types_.end() ? nullptr : *found;
}

void Interpreter::learn(TypeDescriptions theirs) {
  theirs_ = std::move(theirs);
  foreign_.clear();
  if (!own_) return;
  for (const TypeDescription& description : theirs_.types) {
    const RepresentationType* type = own_->find(description.type);
    if (!type || foreign_.contains(description.type)) continue;
    if (type->schema().id() == Schema{description.name, description.schema}.id()) continue;
    auto definition = MessageDefinition::parse(description.name, description.schema);
    addNews(news_, "the program was built from another version: its " + std::string{type->name} +
                       (definition ? " is read field by field"
                                   : " cannot be read: " + definition.error().text()));
    Foreign& foreign = foreign_[description.type] = {type, {}};
    if (definition) foreign.definition = std::move(*definition);
  }
}

void Interpreter::take(const MessageQueue& messages, MessageQueue& to) {
  if (foreign_.empty()) return messages.copyAllMessages(to);
  messages.handleAllMessages([&](const Message& message) {
    const auto foreign = foreign_.find(message.id);
    if (foreign == foreign_.end())
      to.append(message);
    else if (foreign->second.definition)
      translate(message, foreign->second, to);
  });
}

void Interpreter::translate(const Message& message, Foreign& foreign, MessageQueue& to) {
  const std::shared_ptr<void> value = foreign.type->make();
  const auto done =
      readRecorded(*foreign.definition, message.bytes, Value{foreign.type->type(), value.get()});
  if (done) {
    foreign.type->write(value.get(), message.time, to);
  } else if (!std::exchange(foreign.failed, true)) {
    addNews(news_, "the program sends a " + std::string{foreign.type->name} +
                       " that cannot be read: " + done.error().text());
  }
}

}  // namespace gt
