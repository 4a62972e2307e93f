#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/Result.h"
#include "streams/Type.h"

namespace gt {

/// A message type as defined by the schema in a log (`ros2msg`), without the C++ type from which it
/// was written: that type may have changed since, or belong to another project. Made by parse().
class MessageDefinition {
 public:
  enum class Size { single, array, list };

  struct Field {
    std::string name;
    Kind kind = Kind::number;             ///< Kind of one element: boolean, number, text or record.
    Number number = Number::int8;         ///< Type of numbers.
    std::size_t record = 0;               ///< Index of a record, for record().
    Size size = Size::single;             ///< Number of elements.
    std::size_t count = 0;                ///< Number of elements of an array.
    std::vector<std::string> names;       ///< Names of an enumeration's values, in ROS's spelling.
    std::vector<std::string> indexNames;  ///< Names of an array's elements; empty if they have
                                          ///< none.
  };
  struct Record {
    std::string name;
    std::vector<Field> fields;
    std::size_t leastSize = 0;  ///< Least size of a value in bytes, at least 1.
  };

  /// Parses a schema. The error's line is that of the text; its file is the schema's name.
  static Result<MessageDefinition> parse(const std::string& name, std::string_view text);

  const Record& root() const { return records_.front(); }
  const Record& record(std::size_t index) const { return records_[index]; }
  /// The least number of bytes that one element of a field takes.
  std::size_t leastSize(const Field& field) const;

 private:
  friend class MessageDefinitionParser;
  std::vector<Record> records_;
};

}  // namespace gt
