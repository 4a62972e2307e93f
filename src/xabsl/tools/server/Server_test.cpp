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

/// An editor that opens one text, and what it was told.
class Editor {
 public:
  explicit Editor(const std::string& uri, const std::string& text) : uri_{uri} {
    send({{"id", 1}, {"method", "initialize"}, {"params", {{"processId", 77}}}});
    open(uri, text);
  }
  void open(const std::string& uri, const std::string& text) {
    notify("didOpen", {{"textDocument", {{"uri", uri}, {"text", text}}}});
  }
  void change(const Json& changes) {
    notify("didChange", {{"textDocument", {{"uri", uri_}}}, {"contentChanges", changes}});
  }
  /// A change of a range.
  static Json of(int line, int from, int to, const std::string& text) {
    return {{"range",
             {{"start", {{"line", line}, {"character", from}}},
              {"end", {{"line", line}, {"character", to}}}}},
            {"text", text}};
  }
  /// The names of a file's symbols.
  std::vector<std::string> symbols() {
    send({{"id", 1},
          {"method", "textDocument/documentSymbol"},
          {"params", {{"textDocument", {{"uri", uri_}}}}}});
    std::vector<std::string> names;
    for (const Json& symbol : told.back()["result"]) names.push_back(symbol["name"]);
    return names;
  }
  std::map<std::string, std::size_t> diagnostics() {
    told.clear();
    server.publish();
    std::map<std::string, std::size_t> counts;
    for (const Json& one : told) counts[one["params"]["uri"]] = one["params"]["diagnostics"].size();
    return counts;
  }

  std::vector<Json> told;
  Server server{
      {[](const std::string&, std::string&) { return std::optional<std::string>("none"); },
       [](const std::string&) { return std::vector<std::string>(); }},
      [this](const std::string& text) { told.push_back(*gt::parseJsonAs<Json>(text, "")); }};

 private:
  void send(const Json& message) { server.handle(message.dump()); }
  void notify(const std::string& method, const Json& parameters) {
    send({{"method", "textDocument/" + method}, {"params", parameters}});
  }

  std::string uri_;
};

const std::string oneOption =
    "option main {\n  initial state s {\n    decision { stay; }\n    action { }\n  }\n}\n"
    "agent a(\"A\", main);\n";
using Names = std::vector<std::string>;

TEST(Server, TakesChangesOfRangesInTheirOrder) {
  Editor editor{"file:///main.xabsl", oneOption};
  EXPECT_EQ(editor.symbols(), (Names{"main", "a"}));
  editor.change({Editor::of(0, 7, 11, "ümain"), Editor::of(0, 7, 8, ""), Editor::of(6, 6, 7, "c")});
  EXPECT_EQ(editor.symbols(), (Names{"main", "c"}));
  EXPECT_EQ(editor.diagnostics(), (std::map<std::string, std::size_t>{{"file:///main.xabsl", 0}}));
  editor.change({{{"text", oneOption}}, Editor::of(6, 6, 7, "b"), Editor::of(1000, 0, 0, "\n")});
  EXPECT_EQ(editor.symbols(), (Names{"main", "b"}));
  editor.change({Editor::of(-4, -4, -2, "// "), Editor::of(0, 12, 3, "")});
  EXPECT_EQ(editor.symbols(), (Names{"<option>", "b"}))
      << "ends before begins: nothing is taken out";
}

TEST(Server, KnowsTextsThatAreNoFiles) {
  for (const char* uri :
       {"untitled:Untitled-1", "untitled:///main.xabsl", "vscode-vfs://github/a/main.xabsl",
        "http://x/main.xabsl", "file:/main.xabsl", "file://localhost/main.xabsl",
        "FILE:///main.xabsl"}) {
    Editor editor{uri, oneOption};
    EXPECT_EQ(editor.symbols(), (Names{"main", "a"})) << uri;
    const auto diagnostics = editor.diagnostics();
    EXPECT_TRUE(diagnostics.size() == 1 && diagnostics.contains(uri)) << uri;
    editor.change({{{"text", "option"}}});
    EXPECT_GT(editor.diagnostics()[uri], 0u) << uri;
  }
}

/// One of a document under another spelling of its name takes its place.
TEST(Server, LeavesNoDiagnosticsUnderAnotherSpelling) {
  Editor editor{"file:///a%20b.xabsl", "option"};
  EXPECT_GT(editor.diagnostics()["file:///a%20b.xabsl"], 0u);
  editor.told.clear();
  editor.open("file:/a b.xabsl", "option");
  ASSERT_EQ(editor.told.size(), 1u);
  EXPECT_EQ(editor.told[0]["params"]["uri"], "file:///a%20b.xabsl");
  EXPECT_TRUE(editor.told[0]["params"]["diagnostics"].empty());
  EXPECT_EQ(editor.diagnostics().count("file:///a%20b.xabsl"), 0u);
}

TEST(Server, KnowsItsEditorsProcessAndWhatIsWrongInItsRequests) {
  Editor editor{"file:///main.xabsl", oneOption};
  EXPECT_EQ(editor.server.editor(), 77);
  editor.server.handle(R"({"id":1,"method":"textDocument/hover","params":null})");
  EXPECT_EQ(editor.told.back()["error"]["message"],
            "these are no parameters of textDocument/hover");
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
