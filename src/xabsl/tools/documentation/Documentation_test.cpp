#include "xabsl/tools/documentation/Documentation.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "xabsl/tests/TestBehavior.h"
#include "xabsl/tools/documentation/Html.h"

namespace xabsl {
namespace {

namespace fs = std::filesystem;

/// Documentation in a folder of its own, with the text of every file.
class Documentation {
 public:
  explicit Documentation(const Model& model)
      : folder_(fs::temp_directory_path() / ("xabsl-doc-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    const auto failure = writeDocumentation(model, folder_.string());
    EXPECT_FALSE(failure) << toString(*failure);
    for (const auto& entry : fs::directory_iterator(folder_)) {
      std::ifstream file(entry.path(), std::ios::binary);
      files[entry.path().filename().string()] = {std::istreambuf_iterator<char>(file), {}};
    }
  }
  ~Documentation() { fs::remove_all(folder_); }

  std::map<std::string, std::string> files;

 private:
  fs::path folder_;
};

std::set<std::string> allMatches(const std::string& text, const char* expression) {
  std::set<std::string> found;
  const std::regex regex(expression);
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

/// Whether an address leads to a file, and behind a `#` to an element of it.
void expectLeads(const Documentation& documentation, const std::string& page,
                 const std::string& address) {
  const std::size_t sign = address.find('#');
  const std::string name = address.substr(0, sign);
  const auto file = documentation.files.find(name.empty() ? page : name);
  ASSERT_NE(file, documentation.files.end()) << page << " leads to " << address;
  if (sign == std::string::npos) return;
  EXPECT_NE(file->second.find("id=\"" + address.substr(sign + 1) + "\""), std::string::npos)
      << page << " leads to " << address;
}

void expectSound(const Documentation& documentation) {
  for (const auto& [name, text] : documentation.files) {
    for (const std::string& address : allMatches(text, "(?:href|src)=\"([^\"]*)\""))
      expectLeads(documentation, name, address);
    if (name == "entries.js")
      for (const std::string& address : allMatches(text, "\"([^\"]*)\"\\],"))
        expectLeads(documentation, name, address);
    EXPECT_TRUE(allMatches(text, "(?:href|src)=\"(https?:[^\"]*)\"").empty()) << name;
    const auto ids = std::regex(" id=\"([^\"]*)\"");
    const auto count = std::distance(std::sregex_iterator(text.begin(), text.end(), ids), {});
    EXPECT_EQ(static_cast<std::size_t>(count), allMatches(text, " id=\"([^\"]*)\"").size())
        << name << ": two elements have the same identifier";
  }
}

/// Everything that has a name can be found, and its page describes it.
void expectComplete(const Documentation& documentation, const Model& model) {
  const std::string& entries = documentation.files.at("entries.js");
  const auto expect = [&](const std::string& kind, const std::string& name) {
    EXPECT_NE(entries.find("[\"" + kind + "\"," + documentation::quotedScript(name) + ","),
              std::string::npos)
        << kind << ' ' << name;
  };
  for (const Agent& agent : model.agents) expect("agent", agent.name);
  for (const Symbol& symbol : model.symbols) expect("symbol", symbol.name);
  for (const Constant& constant : model.constants) expect("constant", constant.name);
  for (const BasicBehavior& behavior : model.behaviors) expect("behavior", behavior.name);
  for (const Enumeration& enumeration : model.enumerations) expect("enumeration", enumeration.name);
  for (const Option& option : model.options) {
    expect("option", option.name);
    for (const int i : option.states)
      expect("state", option.name + "." + model.states[static_cast<std::size_t>(i)].name);
  }
}

TEST(Documentation, OfTheSoccerBehaviorIsSoundAndComplete) {
  const Compilation compilation = compile("behavior/GT2003.xabsl");
  ASSERT_TRUE(compilation.behavior);
  const Model& model = compilation.behavior->model();
  const Documentation first(model);
  expectSound(first);
  expectComplete(first, model);
  // A chart of the overview, each agent, option and state, and of the common decision trees.
  std::size_t charts = 0, wanted = 1 + model.agents.size();
  for (const auto& [name, text] : first.files)
    for (std::size_t at = 0; (at = text.find("<svg ", at)) != std::string::npos; ++at) ++charts;
  for (const Option& option : model.options)
    wanted += option.commonDecision.kind == Branch::Kind::decision ? 2 : 1;
  EXPECT_EQ(charts, wanted + model.states.size());
  EXPECT_EQ(first.files, Documentation(model).files);
}

TEST(Documentation, TakesAnyNamesAndTexts) {
  const Behavior behavior = test::compiled(
      "/*** Title: <script>alert(1)</script> & \"more\" */"
      "namespace s(\"a <b> & \\\") { /** </table> \xFC */ float input x [0..<1] \"<i>\"; "
      "enum color output { red, blue }; enum color output light; float const limit = 3; }"
      "namespace s(\"again\") { float input f(float p;); bool internal b; }"
      "namespace t(\"Behaviors\") { behavior b { float " +
      std::string(200, 'p') + "; } }" + "option " + std::string(300, 'o') +
      " { initial state only { action { b(" + std::string(200, 'p') + " = f(p = limit)); } } }" +
      "option main { enum color @c; common decision { /** \\n \"quoted\" --> */ if (x < 1 && b) "
      "goto "
      "end; } common action { light = @c; } initial state begin { decision { else stay; } action "
      "{ " +
      std::string(300, 'o') +
      "(); } } target state end { decision { else if (x == 2) goto begin; "
      "else goto end; } action { b = x > 1; } } } agent a(\"<a>\", main);");
  const Documentation documentation(behavior.model());
  expectSound(documentation);
  expectComplete(documentation, behavior.model());
  for (const auto& [name, text] : documentation.files) {
    EXPECT_EQ(text.find("<script>alert"), std::string::npos) << name;
    EXPECT_EQ(text.find("</table> "), std::string::npos) << name;
    EXPECT_EQ(documentation::utf8(text), text) << name;
  }
}

TEST(Documentation, SaysWhatCannotBeWritten) {
  const Behavior behavior =
      test::compiled("option o { initial state s { action { } } } agent a(\"\", o);");
  const auto failure = writeDocumentation(behavior.model(), "/dev/null/docs");
  ASSERT_TRUE(failure);
  EXPECT_EQ(toString(*failure), "/dev/null/docs: cannot make the folder");
}

TEST(Documentation, MarksStatesThatAreNeverEntered) {
  const Behavior behavior = test::compiled(
      "option main { initial state s { action { } } state t { action { } } } agent a(\"A\", "
      "main);");
  const Documentation documentation(behavior.model());
  const std::string& page = documentation.files.at("option-main.html");
  const std::string badge = "never entered</span>";
  EXPECT_EQ(page.find(badge), page.rfind(badge));
  EXPECT_NE(page.find("<h3>t <span class=\"badge\">" + badge), std::string::npos) << page;
}

}  // namespace
}  // namespace xabsl
