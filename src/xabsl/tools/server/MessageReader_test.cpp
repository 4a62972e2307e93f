#include "xabsl/tools/server/MessageReader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace xabsl::server {
namespace {

TEST(MessageReader, CutsWhateverIsAddedInWhateverPieces) {
  const std::string stream =
      "Content-Length: 2\r\n\r\n{}content-length: 3\r\nContent-Type: x\r\n\r\n[1]Content-Length: "
      "9\r\n";
  for (std::size_t step = 1; step < stream.size(); ++step) {
    MessageReader reader;
    std::vector<std::string> messages;
    for (std::size_t i = 0; i < stream.size(); i += step) {
      reader.add(std::string_view(stream).substr(i, step));
      while (auto message = reader.next()) messages.push_back(*message);
    }
    EXPECT_EQ(messages, (std::vector<std::string>{"{}", "[1]"}));
    EXPECT_FALSE(reader.broken());
  }
}

TEST(MessageReader, EndsAtWhatIsNoHeader) {
  for (const std::string& wrong :
       {std::string("Content-Length: x\r\n\r\n"), std::string("Length: 1\r\n\r\n"),
        std::string("Content-Length: 99999999999999999999\r\n\r\n"),
        std::string("Content-Length: 900000000\r\n\r\n"), std::string(5000, 'x')}) {
    MessageReader reader;
    reader.add(wrong);
    EXPECT_FALSE(reader.next());
    EXPECT_TRUE(reader.broken()) << wrong;
  }
}

}  // namespace
}  // namespace xabsl::server
