#include "streams/RecordedMessage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <variant>

#include "base/Base64.h"
#include "streams/Binary.h"
#include "streams/NumberType.h"
#include "streams/Schema.h"

namespace gt {
namespace {

using RecordedField = MessageDefinition::Field;
using Record = MessageDefinition::Record;
using Size = MessageDefinition::Size;
using cdr::Reader;

/// A scalar as it was recorded.
using Scalar = std::variant<std::int64_t, std::uint64_t, double, std::string>;

template <typename N>
bool takeNumber(Reader& reader, Scalar& scalar) {
  N number{};
  if (!cdr::getScalar(reader, number)) return false;
  if constexpr (std::is_floating_point_v<N>)
    scalar = static_cast<double>(number);
  else if constexpr (std::is_signed_v<N>)
    scalar = static_cast<std::int64_t>(number);
  else
    scalar = static_cast<std::uint64_t>(number);
  return true;
}

/// Takes what fields hold from bytes that are not trusted.
class FieldReader {
 protected:
  FieldReader(const MessageDefinition& definition, Reader& reader)
      : definition_{definition}, reader_{reader} {}

  bool takeScalar(const RecordedField& field, Scalar& scalar) {
    if (!spend(1)) return false;
    if (field.kind == Kind::text) return cdr::getText(reader_, scalar.emplace<std::string>());
    if (field.kind == Kind::boolean) return takeNumber<std::uint8_t>(reader_, scalar);
    return withType(field.number, [&]<typename N>(std::type_identity<N>) {
      return takeNumber<N>(reader_, scalar);
    });
  }

  /// How many elements a field has; false if the data cannot hold that many.
  bool takeCount(const RecordedField& field, std::size_t& count) {
    count = field.size == Size::array ? field.count : 1;
    if (field.size == Size::list) {
      std::uint32_t n = 0;
      if (!cdr::getScalar(reader_, n)) return false;
      count = n;
    }
    return count <= reader_.left() / definition_.leastSize(field) ||
           reader_.fail("its length exceeds the data");
  }

  /// What is made of the data may be far larger than the data: this bounds it.
  bool spend(std::size_t count) {
    if (count > left_) return reader_.fail("the message has too many elements");
    left_ -= count;
    return true;
  }

  /// The record that is an element of a field; null if it has no fields, which takes one byte, as
  /// in ROS 2.
  const Record* recordOf(const RecordedField& field) const {
    const Record& record = definition_.record(field.record);
    return record.fields.empty() ? nullptr : &record;
  }

  const MessageDefinition& definition_;
  Reader& reader_;

 private:
  std::size_t left_ = 1u << 22;
};

// --- To JSON

Json recordedScalarJson(const RecordedField& field, const Scalar& scalar) {
  if (const auto* text = std::get_if<std::string>(&scalar)) return *text;
  if (const auto* real = std::get_if<double>(&scalar)) {
    if (!std::isfinite(*real)) return nullptr;
    // By its shortest text, so that 0.1f is 0.1 and not 0.10000000149.
    if (field.number == Number::float32)
      return *parseJson(
          scalarText(valueOf(std::as_const(static_cast<const float&>(static_cast<float>(*real))))),
          "");
    return *real;
  }
  if (const auto* number = std::get_if<std::int64_t>(&scalar)) return *number;
  const auto number = std::get<std::uint64_t>(scalar);
  if (field.kind == Kind::boolean) return number != 0;
  if (number < field.names.size()) return field.names[static_cast<std::size_t>(number)];
  return number;
}

/// Makes JSON of a message.
class JsonMaker : private FieldReader {
 public:
  JsonMaker(const MessageDefinition& definition, Reader& reader)
      : FieldReader{definition, reader} {}

  bool make(const Record& record, Json& json) {
    for (const RecordedField& field : record.fields)
      if (!makeField(field, json[field.name])) return reader_.failedIn(field.name);
    return true;
  }

 private:
  bool makeField(const RecordedField& field, Json& json) {
    std::size_t count = 0;
    if (!takeCount(field, count)) return false;
    if (field.size == Size::single) return makeElement(field, json);
    const bool bytes = field.kind == Kind::number && field.number == Number::uint8;
    if (field.size == Size::list && bytes && field.names.empty()) {
      json = base64({reader_.next(), count});
      return reader_.skip(count);
    }
    if (!spend(count)) return false;
    json = Json::array();
    for (std::size_t i = 0; i < count; ++i)
      if (!makeElement(field, json.emplace_back())) return reader_.failedIn(i);
    return true;
  }

  bool makeElement(const RecordedField& field, Json& json) {
    if (field.kind == Kind::record) {
      json = Json::object();
      const Record* record = recordOf(field);
      return record ? make(*record, json) : reader_.skip(1);
    }
    Scalar scalar;
    if (!takeScalar(field, scalar)) return false;
    json = recordedScalarJson(field, scalar);
    return true;
  }
};

// --- Into a value

/// A number in the range of a type: rounded, and what lies beyond becomes the nearest.
template <typename N, typename From>
N converted(From from) {
  if constexpr (std::is_floating_point_v<N>)
    return static_cast<N>(from);
  else if constexpr (std::is_floating_point_v<From>) {
    if (std::isnan(from)) return 0;
    const double rounded = std::round(from);
    // The limits as doubles may lie one beyond what the type holds.
    if (rounded <= static_cast<double>(std::numeric_limits<N>::min()))
      return std::numeric_limits<N>::min();
    if (rounded >= static_cast<double>(std::numeric_limits<N>::max()))
      return std::numeric_limits<N>::max();
    return static_cast<N>(rounded);
  } else {
    if (std::cmp_less(from, std::numeric_limits<N>::min())) return std::numeric_limits<N>::min();
    if (std::cmp_greater(from, std::numeric_limits<N>::max())) return std::numeric_limits<N>::max();
    return static_cast<N>(from);
  }
}

/// The number that a scalar is; 0 of a text.
template <typename N>
N numberOf(const Scalar& scalar) {
  return std::visit(
      [](const auto& from) -> N {
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(from)>>)
          return converted<N>(from);
        else
          return N{};
      },
      scalar);
}

/// By name where the schema has names; a value that is not there any more changes nothing.
void setRecordedEnumeration(const RecordedField& field, const Scalar& scalar, Value value) {
  auto number = numberOf<std::int64_t>(scalar);
  const auto& names = value.type->names;
  if (!field.names.empty()) {
    if (number < 0 || std::cmp_greater_equal(number, field.names.size())) return;
    const std::string& recorded = field.names[static_cast<std::size_t>(number)];
    const auto same = [&](std::string_view name) { return upperCase(snakeCase(name)) == recorded; };
    number = std::find_if(names.begin(), names.end(), same) - names.begin();
  }
  if (number >= 0 && std::cmp_less(number, names.size())) setOrdinal(value, number);
}

void setRecordedScalar(const RecordedField& field, const Scalar& scalar, Value value) {
  const auto* text = std::get_if<std::string>(&scalar);
  const Kind kind = value.type->kind;
  if (text && kind == Kind::text) *static_cast<std::string*>(value.data) = *text;
  if (text) return;
  if (kind == Kind::number)
    withType(value.type->number, [&]<typename N>(std::type_identity<N>) {
      const N number = numberOf<N>(scalar);
      std::memcpy(value.data, &number, sizeof number);
    });
  else if (kind == Kind::boolean)
    setOrdinal(value, numberOf<double>(scalar) != 0);
  else if (kind == Kind::enumeration)
    setRecordedEnumeration(field, scalar, value);
}

/// Reads by a definition into values; a value without a type takes nothing in.
class ValueFiller : private FieldReader {
 public:
  ValueFiller(const MessageDefinition& definition, Reader& reader)
      : FieldReader{definition, reader} {}

  bool fill(const Record& record, Value value) {
    for (const RecordedField& field : record.fields)
      if (!fillField(field, target(record, field, value))) return reader_.failedIn(field.name);
    return true;
  }

 private:
  static bool isSequence(Value value) {
    return value.type && (value.type->kind == Kind::array || value.type->kind == Kind::list);
  }

  /// The part of a value that a field is meant for. What is no record in C++ has a message with one
  /// field of its own where it is an element of another (see schemaOf).
  static Value target(const Record& record, const RecordedField& field, Value value) {
    if (!value.type) return {};
    if (value.type->kind != Kind::record) {
      const bool wraps =
          record.fields.size() == 1 && field.name == (isSequence(value) ? "values" : "value");
      return wraps ? value : Value{};
    }
    for (const Part& part : value.type->parts)
      if (snakeCase(part.name) == field.name) return value.part(part);
    return {};
  }

  bool fillField(const RecordedField& field, Value value) {
    std::size_t count = 0;
    if (!takeCount(field, count)) return false;
    if (field.size == Size::single) return fillElement(field, value);
    if (!isSequence(value)) value = {};
    if (isSequence(value) && copyBytes(field, count, value)) return reader_.skip(count);
    if (!spend(count)) return false;
    if (value.type && value.type->kind == Kind::list) value.type->resize(value.data, count);
    for (std::size_t i = 0; i < count; ++i)
      if (!fillElement(field, elementFor(field, i, value))) return reader_.failedIn(i);
    return true;
  }

  /// Lists of bytes may be large; they are copied as they are.
  bool copyBytes(const RecordedField& field, std::size_t count, Value list) {
    const Type& element = list.type->element();
    if (list.type->kind != Kind::list || field.kind != Kind::number ||
        field.number != Number::uint8 || element.kind != Kind::number ||
        element.number != Number::uint8)
      return false;
    list.type->resize(list.data, count);
    if (count > 0) std::memcpy(list.element(0).data, reader_.next(), count);
    return true;
  }

  static Value elementFor(const RecordedField& field, std::size_t i, Value value) {
    if (!value.type) return {};
    const auto& names = value.type->indexNames;
    if (!field.indexNames.empty() && !names.empty())
      i = static_cast<std::size_t>(
          std::find_if(names.begin(), names.end(),
                       [&](std::string_view n) { return snakeCase(n) == field.indexNames[i]; }) -
          names.begin());
    return i < value.size() ? value.element(i) : Value{};
  }

  bool fillElement(const RecordedField& field, Value value) {
    if (field.kind == Kind::record) {
      const Record* record = recordOf(field);
      return record ? fill(*record, value) : reader_.skip(1);
    }
    Scalar scalar;
    if (!takeScalar(field, scalar)) return false;
    if (value.type) setRecordedScalar(field, scalar, value);
    return true;
  }
};

}  // namespace

Result<void> readRecorded(const MessageDefinition& definition, std::span<const std::byte> bytes,
                          Value value) {
  if (!cdr::isHeaded(bytes)) return cdr::headerError(bytes);
  Reader reader{bytes.subspan(cdr::headerSize)};
  if (!ValueFiller{definition, reader}.fill(definition.root(), value) || !reader.finish())
    return reader.error();
  return checked(value);
}

Result<Json> recordedJson(const MessageDefinition& definition, std::span<const std::byte> bytes) {
  if (!cdr::isHeaded(bytes)) return cdr::headerError(bytes);
  Reader reader{bytes.subspan(cdr::headerSize)};
  Json json = Json::object();
  if (!JsonMaker{definition, reader}.make(definition.root(), json) || !reader.finish())
    return reader.error();
  return json;
}

}  // namespace gt
