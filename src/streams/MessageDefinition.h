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

/// A message type as the schema in a log states it (`ros2msg`), without the C++ type it was written
/// from: that may have changed since, or never have been ours. Made by parse().
class MessageDefinition {
 public:
  enum class Size { single, array, list };

  struct Field {
    std::string name;
    Kind kind = Kind::number;             ///< Of one element: boolean, number, text or record.
    Number number = Number::int8;         ///< Of numbers.
    std::size_t record = 0;               ///< Of records: an index for record().
    Size size = Size::single;             ///< How many elements there are.
    std::size_t count = 0;                ///< Of an array.
    std::vector<std::string> names;       ///< Of an enumeration's values, in ROS's spelling.
    std::vector<std::string> indexNames;  ///< Of an array's elements, if they have names.
  };
  struct Record {
    std::string name;
    std::vector<Field> fields;
    std::size_t leastSize = 0;  ///< Bytes that a value takes at least, at least 1.
  };

  /// Reads a schema. The error's line is that of the text; its file is the schema's name.
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
