#include "streams/RecordedTable.h"

#include <gtest/gtest.h>

#include <cstring>

#include "streams/Binary.h"
#include "streams/Schema.h"

namespace gt {
namespace {

enum class Mood { calm, wild };
struct Spot {
  float x = 0;
  std::int16_t y = 0;
  std::vector<std::string> names;
  static constexpr auto fields() {
    return Fields{field<&Spot::x>(), field<&Spot::y>(), field<&Spot::names>()};
  }
};
struct Sight {
  bool sure = false;
  std::array<std::uint16_t, 3> counts{};
  Mood mood = Mood::calm;
  double value = 0;
  std::vector<Spot> spots;
  std::vector<double> numbers;
  std::string note;
  static constexpr auto fields() {
    return Fields{field<&Sight::sure>(),  field<&Sight::counts>(), field<&Sight::mood>(),
                  field<&Sight::value>(), field<&Sight::spots>(),  field<&Sight::numbers>(),
                  field<&Sight::note>()};
  }
};

const Sight first{true, {1, 2, 3}, Mood::wild, 0.5, {{1, 2, {"a", "bc"}}, {3, 4, {}}}, {7, 8}, "x"};
const Sight second{false, {4, 5, 6}, Mood::calm, -1, {{5, 6, {"", "def"}}}, {}, "yz"};

std::vector<std::byte> bytesOf(const Sight& sight) {
  std::vector<std::byte> bytes;
  encode(sight, bytes);
  return bytes;
}

RecordedTable makeTable() {
  const Schema schema = schemaOf<Sight>();
  return *RecordedTable::make(*MessageDefinition::parse(schema.name, schema.text));
}

/// Reads what lies in a row or a pool, one after the other.
class Walk {
 public:
  explicit Walk(const RecordedTable::Pool& pool, std::size_t at = 0) : pool_{pool}, at_{at} {}
  template <typename T>
  T next() {
    T value{};
    std::memcpy(&value, pool_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }

 private:
  const RecordedTable::Pool& pool_;
  std::size_t at_;
};

std::string textAt(const RecordedTable& table, const RecordedTable::Element& element,
                   const RecordedTable::Span& span) {
  const auto& letters = table.pools()[element.pool];
  return {reinterpret_cast<const char*>(letters.data()) + span.begin,
          static_cast<std::size_t>(span.end - span.begin)};
}

void expectRow(const RecordedTable& table, std::size_t row, const Sight& sight) {
  const auto& fields = table.row().fields;
  Walk walk{table.rows(), row * table.row().size};
  EXPECT_EQ(walk.next<bool>(), sight.sure);
  for (const std::uint16_t count : sight.counts) EXPECT_EQ(walk.next<std::uint16_t>(), count);
  EXPECT_EQ(walk.next<std::uint8_t>(), static_cast<std::uint8_t>(sight.mood));
  EXPECT_EQ(walk.next<double>(), sight.value);
  const auto spots = walk.next<RecordedTable::Span>();
  ASSERT_EQ(spots.end - spots.begin, std::ssize(sight.spots));
  for (std::size_t i = 0; i < sight.spots.size(); ++i) {
    const auto& element = fields[4].element;
    Walk spot{table.pools()[*fields[4].pool],
              (static_cast<std::size_t>(spots.begin) + i) * element.size};
    EXPECT_EQ(spot.next<float>(), sight.spots[i].x);
    EXPECT_EQ(spot.next<std::int16_t>(), sight.spots[i].y);
    const auto names = spot.next<RecordedTable::Span>();
    const auto& name = element.fields[2];
    Walk text{table.pools()[*name.pool],
              static_cast<std::size_t>(names.begin) * sizeof(RecordedTable::Span)};
    for (const std::string& expected : sight.spots[i].names)
      EXPECT_EQ(textAt(table, name.element, text.next<RecordedTable::Span>()), expected);
  }
  const auto numbers = walk.next<RecordedTable::Span>();
  Walk number{table.pools()[*fields[5].pool],
              static_cast<std::size_t>(numbers.begin) * sizeof(double)};
  for (const double expected : sight.numbers) EXPECT_EQ(number.next<double>(), expected);
  EXPECT_EQ(textAt(table, fields[6].element, walk.next<RecordedTable::Span>()), sight.note);
}

TEST(RecordedTable, HoldsWhatWasRecorded) {
  RecordedTable table = makeTable();
  ASSERT_TRUE(table.add(bytesOf(first)));
  ASSERT_TRUE(table.add(bytesOf(second)));
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table.row().size, 1 + 6 + 1 + 8 + 3 * sizeof(RecordedTable::Span));
  EXPECT_EQ(table.rows().size(), 2 * table.row().size);
  EXPECT_EQ(table.row().fields[2].element.names, (std::vector<std::string>{"CALM", "WILD"}));
  expectRow(table, 0, first);
  expectRow(table, 1, second);
}

TEST(RecordedTable, IsAsItWasAfterABrokenMessage) {
  RecordedTable table = makeTable();
  ASSERT_TRUE(table.add(bytesOf(first)));
  const auto whole = bytesOf(second);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(table.add(std::span{whole}.first(size))) << size;
  auto neither = whole;
  neither[4] = std::byte{2};
  const auto done = table.add(neither);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().text(), "sure: is neither true nor false");
  EXPECT_EQ(table.size(), 1u);
  ASSERT_TRUE(table.add(bytesOf(second)));
  expectRow(table, 0, first);
  expectRow(table, 1, second);
}

TEST(RecordedTable, RefusesSchemasThatExplode) {
  std::string text;
  for (int level = 0; level < 8; ++level) {
    if (level > 0)
      text += std::string(80, '=') + "\nMSG: test_msgs/Level" + std::to_string(level) + "\n";
    for (int i = 0; i < 10; ++i)
      text += (level == 7 ? "int32" : "test_msgs/Level" + std::to_string(level + 1)) + "[] list" +
              std::to_string(i) + "\n";
  }
  const auto definition = MessageDefinition::parse("test_msgs/msg/Level0", text);
  ASSERT_TRUE(definition) << definition.error().text();
  const auto table = RecordedTable::make(*definition);
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().what, "the schema has too many fields");
}

}  // namespace
}  // namespace gt
