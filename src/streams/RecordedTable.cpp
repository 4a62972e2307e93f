#include "streams/RecordedTable.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "streams/Binary.h"

namespace gt {
namespace {

constexpr std::size_t largestRow = 1u << 26;
constexpr std::size_t mostFields = 10'000;

}  // namespace

/// Works out where fields lie in a row.
class RecordedTable::Maker {
 public:
  explicit Maker(const MessageDefinition& definition) : definition_{definition} {}

  Result<RecordedTable> make() {
    auto row = record(definition_.root());
    if (!row) return row.error();
    table_.row_ = std::move(*row);
    return std::move(table_);
  }

 private:
  std::size_t addPool() {
    table_.pools_.emplace_back();
    return table_.pools_.size() - 1;
  }

  Result<Element> record(const MessageDefinition::Record& definition) {
    Element element{.kind = Kind::record, .leastSize = definition.leastSize};
    for (const MessageDefinition::Field& field : definition.fields) {
      auto made = this->field(field);
      if (!made) return made.error();
      element.size += made->pool ? sizeof(Span) : made->element.size * made->count.value_or(1);
      if (element.size > largestRow)
        return Error{.field = field.name, .what = "its rows would be larger than 64 MiB"};
      element.fields.push_back(std::move(*made));
    }
    return element;
  }

  Result<Field> field(const MessageDefinition::Field& definition) {
    if (++fields_ > mostFields)
      return Error{.field = definition.name, .what = "the schema has too many fields"};
    auto element = elementOf(definition);
    if (!element) return element.error();
    Field field{.name = definition.name,
                .element = std::move(*element),
                .indexNames = definition.indexNames};
    if (definition.size == MessageDefinition::Size::list) field.pool = addPool();
    if (definition.size != MessageDefinition::Size::array) return field;
    field.count = definition.count;
    if (definition.count > largestRow)
      return Error{.field = field.name, .what = "its rows would be larger than 64 MiB"};
    return field;
  }

  Result<Element> elementOf(const MessageDefinition::Field& definition) {
    if (definition.kind == Kind::record) return record(definition_.record(definition.record));
    Element element{.kind = definition.kind,
                    .names = definition.names,
                    .leastSize = definition_.leastSize(definition)};
    if (definition.kind == Kind::number) element.number = definition.number;
    if (definition.kind == Kind::text) element.pool = addPool();
    element.size = definition.kind == Kind::text ? sizeof(Span) : numberSize(element.number);
    return element;
  }

  const MessageDefinition& definition_;
  RecordedTable table_;
  std::size_t fields_ = 0;
};

/// Takes one message.
class RecordedTable::MessageReader {
 public:
  MessageReader(RecordedTable& table, std::span<const std::byte> content)
      : table_{table}, reader_{content} {}

  bool take() {
    std::byte* const row = append(table_.rows_, table_.row_.size);
    return takeElements(table_.row_, 1, row) && reader_.finish();
  }
  Error error() const { return reader_.error(); }

 private:
  static std::byte* append(Pool& pool, std::size_t bytes) {
    pool.resize(pool.size() + bytes);
    return pool.data() + pool.size() - bytes;
  }
  template <typename T>
  static void store(const T& value, std::byte* place) {
    std::memcpy(place, &value, sizeof value);
  }

  bool takeField(const Field& field, std::byte* place) {
    if (!field.pool) return takeElements(field.element, field.count.value_or(1), place);
    std::uint32_t count = 0;
    if (!cdr::getScalar(reader_, count) || !has(field.element, count)) return false;
    Pool& pool = table_.pools_[*field.pool];
    // An element without fields takes no room.
    const std::size_t size = std::max<std::size_t>(field.element.size, 1);
    const auto begin = static_cast<std::int64_t>(pool.size() / size);
    std::byte* const elements = append(pool, count * size);
    store(Span{begin, begin + count}, place);
    return takeElements(field.element, count, elements);
  }

  bool has(const Element& element, std::size_t count) {
    return count <= reader_.left() / element.leastSize ||
           reader_.fail("its length exceeds the data");
  }

  bool takeElements(const Element& element, std::size_t count, std::byte* place) {
    if (!has(element, count)) return false;
    switch (element.kind) {
      case Kind::record:
        return takeRecords(element, count, place);
      case Kind::text:
        for (std::size_t i = 0; i < count; ++i)
          if (!takeText(element, place + i * sizeof(Span))) return false;
        return true;
      default:
        return count == 0 ||
               (reader_.align(element.size) && reader_.take(place, count * element.size) &&
                (element.kind != Kind::boolean || areBooleans(place, count)));
    }
  }

  bool areBooleans(const std::byte* bytes, std::size_t count) {
    return std::all_of(bytes, bytes + count, [](std::byte b) { return b <= std::byte{1}; }) ||
           reader_.fail("is neither true nor false");
  }

  bool takeRecords(const Element& record, std::size_t count, std::byte* place) {
    if (record.fields.empty()) return reader_.skip(count);  // a byte each, as in ROS 2
    for (std::size_t i = 0; i < count; ++i)
      for (const Field& field : record.fields) {
        if (!takeField(field, place)) return reader_.failedIn(field.name);
        place += field.pool ? sizeof(Span) : field.element.size * field.count.value_or(1);
      }
    return true;
  }

  bool takeText(const Element& element, std::byte* place) {
    std::string text;
    if (!cdr::getText(reader_, text)) return false;
    Pool& pool = table_.pools_[element.pool];
    const auto begin = static_cast<std::int64_t>(pool.size());
    const auto letters = std::as_bytes(std::span{text});
    pool.insert(pool.end(), letters.begin(), letters.end());
    store(Span{begin, static_cast<std::int64_t>(pool.size())}, place);
    return true;
  }

  RecordedTable& table_;
  cdr::Reader reader_;
};

Result<RecordedTable> RecordedTable::make(const MessageDefinition& definition) {
  return Maker{definition}.make();
}

Result<void> RecordedTable::add(std::span<const std::byte> message) {
  if (!cdr::isHeaded(message)) return cdr::headerError(message);
  const std::size_t before = rows_.size();
  std::vector<std::size_t> sizes;
  for (const Pool& pool : pools_) sizes.push_back(pool.size());
  MessageReader reader{*this, message.subspan(cdr::headerSize)};
  if (reader.take()) {
    ++size_;
    return {};
  }
  rows_.resize(before);
  for (std::size_t i = 0; i < pools_.size(); ++i) pools_[i].resize(sizes[i]);
  return reader.error();
}

}  // namespace gt
