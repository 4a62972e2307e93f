#include "xabsl/tools/server/Server.h"

#include <gtest/gtest.h>

#include "base/ParseJson.h"

namespace xabsl::server {
namespace {

using Json = nlohmann::json;

TEST(Server, AnswersWhateverComes) {
  std::vector<Json> answers;
  Server server(
      {[](const std::string&, std::string&) { return std::optional<std::string>("none"); },
       [](const std::string&) { return std::vector<std::string>(); }},
      [&](const std::string& text) { answers.push_back(*gt::parseJsonAs<Json>(text, "")); });
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

TEST(Server, RefusesMessagesThatAreNestedTooDeeply) {
  Json answer;
  Server server(
      {[](const std::string&, std::string&) { return std::optional<std::string>("none"); },
       [](const std::string&) { return std::vector<std::string>(); }},
      [&](const std::string& text) { answer = *gt::parseJsonAs<Json>(text, ""); });
  constexpr std::size_t levels = 100'000;
  std::string lists;
  for (std::size_t i = 0; i < levels; ++i)
    lists += R"(["]",)";  // a bracket in a string closes none
  server.handle(R"({"id":1,"method":"initialize","params":)" + lists + "1" +
                std::string(levels, ']') + "}");
  EXPECT_EQ(answer["error"]["code"], -32700);
  EXPECT_EQ(answer["error"]["message"], "the text is nested too deeply, at most 100 levels");
}

/// A server with one file, open in the editor.
class ServerWithFile {
 public:
  explicit ServerWithFile(const std::string& text)
      : server_(
            {[](const std::string&, std::string&) { return std::optional<std::string>("none"); },
             [](const std::string&) { return std::vector<std::string>(); }},
            [this](const std::string& message) { answer_ = *gt::parseJsonAs<Json>(message, ""); }) {
    ask("initialize", Json::object());
    send({{"method", "textDocument/didOpen"},
          {"params", {{"textDocument", {{"uri", uri_}, {"text", text}}}}}});
  }

  Json ask(const std::string& method, const Json& parameters) {
    send({{"id", 1}, {"method", method}, {"params", parameters}});
    return answer_;
  }
  /// With more parameters besides the place.
  Json askAt(const std::string& method, int line, int character, Json more = Json::object()) {
    more["textDocument"] = {{"uri", uri_}};
    more["position"] = {{"line", line}, {"character", character}};
    return ask(method, more);
  }

 private:
  void send(const Json& message) { server_.handle(message.dump()); }

  const std::string uri_ = "file:///main.xabsl";
  Json answer_;
  Server server_;
};

TEST(Server, RenamesAParameterAlsoAtItsMark) {
  ServerWithFile server(
      "option main {\n  bool @p;\n  initial state s {\n    decision { if (@p) stay; else stay; }\n"
      "    action { }\n  }\n}\nagent a(\"A\", main);\n");
  const Json range = server.askAt("textDocument/prepareRename", 1, 7)["result"];
  EXPECT_EQ(range["start"]["character"], 7);
  EXPECT_EQ(range["end"]["character"], 9);
  for (const std::string name : {"q", "@q"})
    for (const int character : {7, 8}) {
      const Json answer = server.askAt("textDocument/rename", 1, character, {{"newName", name}});
      const Json& edits = answer["result"]["changes"]["file:///main.xabsl"];
      ASSERT_EQ(edits.size(), 2u) << answer;
      for (const Json& edit : edits) EXPECT_EQ(edit["newText"], "q");
      EXPECT_EQ(edits[1]["range"]["start"]["character"], 8);
    }
  EXPECT_EQ(server.askAt("textDocument/rename", 0, 8, {{"newName", "@q"}})["error"]["code"],
            -32803);
}

}  // namespace
}  // namespace xabsl::server
