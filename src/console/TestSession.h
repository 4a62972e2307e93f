#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/TemporaryFolder.h"
#include "console/Condition.h"
#include "console/Console.h"

namespace gt {

/// Keeps the printed lines.
class TestScreen : public Screen {
 public:
  void print(std::string_view line) override { printed.emplace_back(line); }
  void clear() override { printed.clear(); }

  std::vector<std::string> printed;
};

/// A console on a small scene, for tests: red1 and red4 active, blue1 passive, a ball, no referee.
class SessionTest : public ::testing::Test {
 protected:
  SessionTest() {
    const std::string scene = (folder.path() / "test.scene").string(),
                      root = std::filesystem::current_path().string();
    std::ofstream{scene} << "<scene field='" << root << "/models/field2003.xml' config='" << root
                         << "/config'><game referee='false'/><robots>"
                         << robot("red", "goalie", "-2000", root)
                         << robot("red", "striker2", "-600", root) << "</robots><extras>"
                         << robot("blue", "goalie", "2000", root)
                         << "</extras><balls><ball x='200' y='0' model='" << root
                         << "/models/ball.xml'/></balls></scene>";
    MatchOptions options;
    options.scene = scene;
    auto made = Session::make(options, screen);
    EXPECT_TRUE(made) << made.error().text();
    session = std::move(*made);
    console = std::make_unique<Console>(*session);
  }

  static std::string robot(const std::string& team, const std::string& role, const std::string& x,
                           const std::string& root) {
    return "<robot team='" + team + "' role='" + role + "' x='" + x + "' y='0' model='" + root +
           "/models/ers210.xml' layout='" + root + "/layouts/cmd.layout'/>";
  }
  void expectFine(const std::string& line) {
    const auto done = console->execute(line);
    EXPECT_TRUE(done) << line << ": " << done.error().text();
  }
  void expectError(const std::string& line, const std::string& field, const std::string& what) {
    const auto done = console->execute(line);
    ASSERT_FALSE(done) << line;
    EXPECT_EQ(done.error().field, field) << line;
    EXPECT_THAT(done.error().what, ::testing::HasSubstr(what)) << line;
  }
  /// The lines that a command prints.
  std::vector<std::string> answers(const std::string& line) {
    screen.printed.clear();
    expectFine(line);
    return screen.printed;
  }
  /// Whether a condition holds now.
  bool holds(const std::string& text) {
    const auto condition = Condition::parse(text);
    EXPECT_TRUE(condition) << text << ": " << condition.error().text();
    const auto truth = condition->holds(*console);
    EXPECT_TRUE(truth) << text << ": " << truth.error().text();
    return *truth;
  }
  std::string value(const std::string& path) { return answers("get " + path).back(); }
  Robot& robot(std::size_t i) { return session->match().robots()[i]->robot(); }
  std::string file(const std::string& name) const { return (folder.path() / name).string(); }

  TemporaryFolder folder;
  TestScreen screen;
  std::unique_ptr<Session> session;
  std::unique_ptr<Console> console;
};

}  // namespace gt
