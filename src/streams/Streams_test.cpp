#include "streams/Streams.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "streams/Binary.h"
#include "support/Samples.h"

namespace gt {
namespace {

using samples::Everything;
using testing::HasSubstr;

std::vector<std::byte> encodedBytes(const Everything& value) {
  std::vector<std::byte> bytes;
  encode(value, bytes);
  return bytes;
}

// Report D.3: functions know only In and Out.
void write(Out& stream) {
  stream << 1 << 3.14 << "Hello Dolly" << endl << 42;
}
void expectExample(In& stream) {
  int a = 0, d = 0;
  double b = 0;
  std::string c;
  stream >> a >> b >> c >> d;
  EXPECT_TRUE(stream) << stream.error()->text();
  EXPECT_EQ(a, 1);
  EXPECT_EQ(b, 3.14);
  EXPECT_EQ(c, "Hello Dolly");
  EXPECT_EQ(d, 42);
  EXPECT_TRUE(stream.eof());
}

TEST(Streams, TextIsAsInTheReport) {
  OutTextMemory out;
  write(out);
  EXPECT_EQ(out.text(), "1 3.14 Hello\\ Dolly\n42");
  InTextMemory in{out.text()};
  expectExample(in);
  // As the report's robot wrote it.
  InTextMemory printed{std::string_view{"1 3.14000 Hello\\ Dolly\n42\n"}};
  expectExample(printed);
}

TEST(Streams, FilesHoldWhatWasWritten) {
  const std::string path = testing::TempDir() + "Streams_test.bin";
  OutBinaryFile out{path};
  write(out);
  ASSERT_TRUE(out.close());
  {
    InBinaryFile in{path};
    expectExample(in);
  }
  OutTextFile text{path};
  write(text);
  ASSERT_TRUE(text.close());
  InTextFile in{path};
  expectExample(in);
  std::filesystem::remove(path);
  InTextFile missing{path};
  EXPECT_FALSE(missing);
  EXPECT_EQ(missing.error()->text(), path + ": there is no such file");
  OutTextFile nowhere{"/nowhere/file"};
  write(nowhere);
  EXPECT_FALSE(nowhere.close());
}

/// A stream that is given up leaves the file that was there before.
TEST(Streams, FilesAreWrittenWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.txt").string();
  OutTextFile first{path};
  write(first);
  ASSERT_TRUE(first.close());
  const std::string before = *readFile(path);
  {
    OutTextFile second{path};
    second << 17;
  }
  EXPECT_EQ(*readFile(path), before);
  EXPECT_FALSE(std::filesystem::exists(unfinishedName(path)));
}

TEST(Streams, SizesAreThoseOfWhatIsStored) {
  OutBinaryMemory memory;
  OutBinarySize size;
  OutTextMemory textMemory;
  OutTextSize textSize;
  for (Out* out : std::initializer_list<Out*>{&memory, &size, &textMemory, &textSize}) write(*out);
  EXPECT_EQ(size.size(), memory.bytes().size());
  EXPECT_EQ(textSize.size(), textMemory.bytes().size());
}

/// "void reset() {size = 0;}" (report D.5): what follows is a stream of its own.
TEST(Streams, BeginAnewWhenTheyAreReset) {
  OutBinaryMemory memory;
  OutBinarySize size;
  OutTextMemory text;
  for (int i = 0; i < 2; ++i) {
    memory.reset();
    size.reset();
    text.reset();
    memory << true << 3.14;
    size << true << 3.14;
    text << 1 << 2;
    EXPECT_EQ(memory.bytes().size(), cdr::headerSize + 16);
    EXPECT_EQ(size.size(), memory.bytes().size());
    EXPECT_EQ(text.text(), "1 2");
  }
}

TEST(Streams, TakeNumbersOfAllSizes) {
  OutTextMemory out;
  out << 'A' << short{-2} << 3u << 4L << 5UL << 0.1f << true << Vector2<int>{6, -7};
  EXPECT_EQ(out.text(), "65 -2 3 4 5 0.1 true 6 -7");
  char a = 0;
  unsigned long b = 0;
  int rest = 0;
  InTextMemory in{std::string_view{"65\n18446744073709551615 1"}};
  in >> a >> endl >> b >> endl >> rest;  // an end of line may be read, but need not
  EXPECT_TRUE(in && in.eof());
  EXPECT_EQ(a, 'A');
  EXPECT_EQ(b, ~0ul);
}

// The stream of one value is what encode() writes: two ways, one format.
TEST(Streams, BinaryIsTheFormatOfEncode) {
  Random random{10};
  for (int i = 0; i < 200; ++i) {
    Everything value, read;
    samples::randomize(valueOf(value), random);
    OutBinaryMemory out;
    out << value;
    ASSERT_EQ(out.bytes(), encodedBytes(value));
    InBinaryMemory in{out.bytes()};
    in >> read;
    ASSERT_TRUE(in) << in.error()->text();
    ASSERT_TRUE(in.eof());
    ASSERT_EQ(encodedBytes(read), encodedBytes(value));
  }
}

TEST(Streams, TextKeepsEveryBit) {
  Random random{11};
  for (int i = 0; i < 200; ++i) {
    Everything value, read;
    samples::randomize(valueOf(value), random);
    OutTextMemory out;
    out << value << endl << value;
    InTextMemory in{out.text()};
    in >> read >> read;
    ASSERT_TRUE(in) << in.error()->text();
    ASSERT_TRUE(in.eof());
    ASSERT_EQ(encodedBytes(read), encodedBytes(value));
  }
}

TEST(Streams, ConfigLeavesOutComments) {
  const std::string_view text =
      "// a comment\n"
      "1 # two\n"
      "3.14 /* [00] is no\n section */ Hello\\ Dolly // end\n"
      "42";
  InConfigMemory in{text};
  expectExample(in);
  InConfigMemory unfinished{std::string_view{"/* no end"}};
  EXPECT_TRUE(unfinished.eof());
}

TEST(Streams, ConfigReadsASection) {
  const std::string_view text =
      "[00022D1F626A]\nbodyTiltOffset 1\n"
      "[00022D1F626B] // of robot 2\nbodyTiltOffset 0.06\nbodyRollOffset 0\n[end]\n";
  InConfigMemory in{text, "00022D1F626B"};
  std::string name, name2;
  double tilt = 1, roll = 1;
  in >> name >> tilt >> name2 >> roll;
  ASSERT_TRUE(in) << in.error()->text();
  EXPECT_EQ(name, "bodyTiltOffset");
  EXPECT_EQ(tilt, 0.06);
  EXPECT_EQ(name2, "bodyRollOffset");
  EXPECT_TRUE(in.eof());
  InConfigMemory other{text, "000000000000"};
  EXPECT_TRUE(other.eof());
}

TEST(Streams, TellWhereTheyWereWrong) {
  samples::Inner inner;
  InTextMemory in{std::string_view{"true\ntext\nx"}};
  in >> inner;
  ASSERT_FALSE(in);
  EXPECT_EQ(in.error()->text(), ":3: value: expected a number instead of x");
  int unchanged = 5;
  in >> unchanged;
  EXPECT_EQ(unchanged, 5);
  std::vector<int> list;
  InTextMemory tooLong{std::string_view{"4000000000 1"}};
  tooLong >> list;
  EXPECT_THAT(tooLong.error()->text(), HasSubstr("its length exceeds the data"));
}

TEST(Streams, SurviveMutatedData) {
  Random random{12};
  int failures = 0;
  for (int i = 0; i < 6000; ++i) {
    Everything value;
    if (i % 50 < 2) samples::randomize(valueOf(value), random);
    OutTextMemory text;
    OutBinaryMemory binary;
    (i % 2 == 0 ? static_cast<Out&>(text) : binary) << value;
    auto bad = i % 2 == 0 ? text.bytes() : binary.bytes();
    if (random.chance(0.3)) bad.resize(random.index(bad.size() + 1));
    for (int k = 0; k < 3 && !bad.empty(); ++k)
      bad[random.index(bad.size())] = static_cast<std::byte>(random());
    Everything read;
    InTextMemory inText{bad};
    InBinaryMemory inBinary{bad};
    InConfigMemory inConfig{bad};
    for (In* in : std::initializer_list<In*>{&inText, &inBinary, &inConfig}) {
      *in >> read;
      failures += *in ? 0 : 1;
    }
    encodedBytes(read);
  }
  EXPECT_GT(failures, 6000);
}

/// A medium of one's own (report D.5): counts how often a byte is written.
class OutHistogram : public PhysicalOutStream {
 public:
  void writeToStream(std::span<const std::byte> bytes) override {
    for (const std::byte b : bytes) ++counts[std::to_integer<std::size_t>(b)];
  }
  std::array<int, 256> counts{};
};

TEST(Streams, TakeNewMedia) {
  OutStream<OutHistogram, OutText> out;
  write(out);
  EXPECT_EQ(out.counts['l'], 4);
}

/// A format of one's own (report D.5), Bernstein's netstrings: "11:Hello Dolly,".
class OutNetstrings : public StreamWriter {
 public:
  void writeScalar(ConstValue scalar, PhysicalOutStream& medium) override {
    const std::string text = scalarText(scalar);
    const std::string entry = std::to_string(text.size()) + ":" + text + ",";
    medium.writeToStream(std::as_bytes(std::span{entry}));
  }
};
class InNetstrings : public StreamReader {
 public:
  Result<void> readScalar(Value scalar) override {
    const std::string rest{reinterpret_cast<const char*>(left_.data()), left()};
    const std::size_t colon = rest.find(':');
    if (colon == rest.npos) return Error{.what = "no length"};
    const std::size_t size = std::stoul(rest);
    left_ = left_.subspan(colon + size + 2);
    return setScalar(scalar, rest.substr(colon + 1, size));
  }
};

TEST(Streams, TakeNewFormats) {
  OutStream<OutMemory, OutNetstrings> example;
  write(example);
  EXPECT_EQ(example.text(), "1:1,4:3.14,11:Hello Dolly,2:42,");
  InStream<InMemory, InNetstrings> back{example.bytes()};
  expectExample(back);
  Random random{3};
  for (int i = 0; i < 200; ++i) {
    Everything value, read;
    samples::randomize(valueOf(value), random);
    OutStream<OutMemory, OutNetstrings> out;
    out << value;
    InStream<InMemory, InNetstrings> in{out.bytes()};
    in >> read;
    ASSERT_TRUE(in) << in.error()->text();
    EXPECT_TRUE(in.eof());
    OutTextMemory before, after;
    before << value;
    after << read;
    EXPECT_EQ(before.text(), after.text());
  }
}

}  // namespace
}  // namespace gt
