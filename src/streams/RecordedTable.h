#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/Result.h"
#include "streams/MessageDefinition.h"

namespace gt {

/// Messages of one type as rows of numbers, read by the schema that was recorded with them: fast,
/// and without the C++ type. A row is packed: the fields in their order, without gaps. Records lie
/// in it as rows of their own. A list or text is a `Span`: its elements stand in a pool.
class RecordedTable {
 public:
  /// Where the elements of a list, or the letters of a text, begin and end in their pool.
  struct Span {
    std::int64_t begin = 0, end = 0;
  };

  struct Field;

  /// What a field has one or several of.
  struct Element {
    Kind kind = Kind::number;          ///< boolean, number, text or record.
    Number number = Number::uint8;     ///< Of numbers and booleans.
    std::vector<std::string> names{};  ///< Of an enumeration's values, in ROS's spelling.
    std::vector<Field> fields{};       ///< Of records.
    std::size_t pool = 0;              ///< Of texts: where the letters are.
    std::size_t size = 0;              ///< In a row: bytes.
    std::size_t leastSize = 1;         ///< In a message: bytes.
  };
  struct Field {
    std::string name;
    Element element;
    std::optional<std::size_t> count{};     ///< Of an array.
    std::optional<std::size_t> pool{};      ///< Of a list: where the elements are.
    std::vector<std::string> indexNames{};  ///< Of an array's elements, if they have names.
  };
  using Pool = std::vector<std::byte>;

  /// An empty table for messages of a definition. An error if a row would be
  /// larger than 64 MiB, or the schema has more than 10,000 fields.
  static Result<RecordedTable> make(const MessageDefinition& definition);

  /// Appends a message in CDR with its header as a row. After an error the table is as it was; the
  /// error's field is that of the message.
  Result<void> add(std::span<const std::byte> message);

  /// A record: the fields of a row.
  const Element& row() const { return row_; }
  const Pool& rows() const { return rows_; }
  std::size_t size() const { return size_; }
  const std::vector<Pool>& pools() const { return pools_; }
  /// Takes the rows and pools out of the table.
  std::pair<Pool, std::vector<Pool>> release() && { return {std::move(rows_), std::move(pools_)}; }

 private:
  RecordedTable() = default;

  class Maker;
  class MessageReader;

  Element row_;
  Pool rows_;
  std::size_t size_ = 0;
  std::vector<Pool> pools_;
};

}  // namespace gt
