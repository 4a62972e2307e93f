#include "base/Lines.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(Lines, LeaveOutCommentsAndBlanks) {
  const auto lines = linesOf("# all\n\n  a b // c\r\nhttp://x#y\n\"# no\" # yes\n\t//\nlast");
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].number, 3);
  EXPECT_EQ(lines[0].text, "a b");
  EXPECT_EQ(lines[1].text, "http://x#y") << "a comment begins after a blank";
  EXPECT_EQ(lines[2].text, "\"# no\"");
  EXPECT_EQ(lines[3].number, 7);
  EXPECT_EQ(lines[3].text, "last");
  EXPECT_TRUE(linesOf("").empty());
}

TEST(Lines, EndAsOnAnyMachine) {
  for (const char* text : {"a\n\nb c\n", "a\r\n\r\nb c\r\n",
                           "\xEF\xBB\xBF"
                           "a\n\nb c"}) {
    LineReader reader{text};
    EXPECT_EQ(reader.next(), "a");
    EXPECT_EQ(reader.next(), "");
    EXPECT_EQ(reader.next(), "b c");
    EXPECT_EQ(reader.number(), 3);
    EXPECT_FALSE(reader.next());
  }
  EXPECT_FALSE(LineReader{""}.next());
  EXPECT_FALSE(LineReader{"\xEF\xBB\xBF"}.next());
  EXPECT_EQ(linesOf("\xEF\xBB\xBF# all\r\n\tword\t# one").at(0).text, "word");
}

TEST(Lines, ConsistOfWords) {
  const auto words = wordsOf("  one \"two three\" \"\" \"a\\n\\\"b\" ");
  ASSERT_TRUE(words);
  ASSERT_EQ(words->size(), 4u);
  EXPECT_EQ((*words)[0], "one");
  EXPECT_FALSE((*words)[0].quoted);
  EXPECT_EQ((*words)[1], "two three");
  EXPECT_TRUE((*words)[2].quoted);
  EXPECT_EQ((*words)[3], "a\n\"b");
  const auto open = wordsOf("one \"two");
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().what, "the closing quote is missing");
}

TEST(Lines, TextsAreReadAsTheyWereWritten) {
  using namespace std::literals;
  for (const std::string& text :
       {"plain"s, ""s, "two words"s, "a\"b\\c"s, "# // ="s, "x\ny\tz\r"s, "nul\0l"s}) {
    const auto words = wordsOf(withoutComment(quotedWord(text)));
    ASSERT_TRUE(words);
    ASSERT_EQ(words->size(), 1u);
    EXPECT_EQ((*words)[0].text, text);
  }
  EXPECT_EQ(quotedWord("plain"), "plain");
}

}  // namespace
}  // namespace gt
