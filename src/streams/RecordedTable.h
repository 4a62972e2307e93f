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
/// and without the C++ type. A row contains the fields in their order, without padding. Nested
/// records are embedded as rows. A list or text is a `Span` of elements in a pool.
class RecordedTable {
 public:
  /// Begin and end of the elements of a list, or of the letters of a text, in their pool.
  struct Span {
    std::int64_t begin = 0, end = 0;
  };

  struct Field;

  /// The type of a field's elements.
  struct Element {
    Kind kind = Kind::number;          ///< boolean, number, text or record.
    Number number = Number::uint8;     ///< Type of numbers and booleans.
    std::vector<std::string> names{};  ///< Names of an enumeration's values, in ROS's spelling.
    std::vector<Field> fields{};       ///< Fields of a record.
    std::size_t pool = 0;              ///< Index of the pool with the letters of a text.
    std::size_t size = 0;              ///< Size in a row, in bytes.
    std::size_t leastSize = 1;         ///< Least size in a message, in bytes.
  };
  struct Field {
    std::string name;
    Element element;
    std::optional<std::size_t> count{};     ///< Number of elements of an array.
    std::optional<std::size_t> pool{};      ///< Index of the pool with the elements of a list.
    std::vector<std::string> indexNames{};  ///< Names of an array's elements; empty if they have
                                            ///< none.
  };
  using Pool = std::vector<std::byte>;

  /// Makes an empty table for messages of a definition. Returns an error if a row would be larger
  /// than 64 MiB, or the schema has more than 10,000 fields.
  static Result<RecordedTable> make(const MessageDefinition& definition);

  /// Appends a message in CDR with its header as a row. After an error the table is unchanged; the
  /// error's field is that of the message.
  Result<void> add(std::span<const std::byte> message);

  /// The element type of a row: a record.
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
