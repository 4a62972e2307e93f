#include "xabsl/tools/server/Server.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "xabsl/tools/server/MessageReader.h"

namespace xabsl::server {
namespace {

using Json = nlohmann::json;

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

TEST(Lines, CountUnitsOfUtf16) {
  const Lines lines("a\n\xC3\xBC\xF0\x9F\x98\x80x");
  EXPECT_EQ(lines.position({0, 2, 3}).character, 3);
  EXPECT_EQ(lines.location({1, 3}, 0).column, 3);
  EXPECT_EQ(lines.offset({1, 3}), 8u);
}

TEST(Server, AnswersWhateverComes) {
  std::vector<Json> answers;
  Server server(
      {[](const std::string&, std::string&) { return std::optional<std::string>("none"); },
       [](const std::string&) { return std::vector<std::string>(); }},
      [&](const std::string& text) { answers.push_back(Json::parse(text)); });
  const auto code = [&](const std::string& message) {
    answers.clear();
    server.handle(message);
    return answers.empty() ? 0 : answers[0].value("error", Json::object()).value("code", 1);
  };
  EXPECT_EQ(code("garbage"), -32700);
  EXPECT_EQ(code("[]"), -32600);
  EXPECT_EQ(code(R"({"id":1,"method":"textDocument/hover"})"), -32002);
  EXPECT_EQ(code(R"({"id":1,"method":"initialize","params":{}})"), 1);
  EXPECT_EQ(code(R"({"id":1,"method":"frobnicate"})"), -32601);
  EXPECT_EQ(code(R"({"id":1,"method":"textDocument/hover","params":{"textDocument":5}})"), -32602);
  EXPECT_EQ(code(R"({"method":"textDocument/didOpen","params":[]})"), 0);
  EXPECT_EQ(code(R"({"id":1,"method":"shutdown"})"), 1);
  EXPECT_EQ(code(R"({"method":"exit"})"), 0);
  EXPECT_TRUE(server.ended());
  EXPECT_EQ(server.status(), 0);
}

}  // namespace
}  // namespace xabsl::server
