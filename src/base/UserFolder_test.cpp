#include "base/UserFolder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <optional>

namespace gt {
namespace {

/// Sets variables of the environment, and sets them back.
class Variables {
 public:
  explicit Variables(const std::map<std::string, std::string>& values) {
    for (const char* name :
         {"HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"}) {
      const char* before = std::getenv(name);
      before_[name] = before ? std::optional<std::string>{before} : std::nullopt;
      set(name, values.contains(name) ? std::optional{values.at(name)} : std::nullopt);
    }
  }
  ~Variables() {
    for (const auto& [name, value] : before_) set(name, value);
  }
  Variables(const Variables&) = delete;
  Variables& operator=(const Variables&) = delete;

 private:
  static void set(const std::string& name, const std::optional<std::string>& value) {
    EXPECT_EQ(value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str()), 0);
  }
  std::map<std::string, std::optional<std::string>> before_;
};

TEST(UserFolder, IsInTheHomeByDefault) {
  const Variables variables{{{"HOME", "/home/asimov"}}};
  EXPECT_EQ(userFolder(UserFolder::cache), "/home/asimov/.cache/gt2003");
  EXPECT_EQ(userFolder(UserFolder::config), "/home/asimov/.config/gt2003");
  EXPECT_EQ(userFolder(UserFolder::state), "/home/asimov/.local/state/gt2003");
  EXPECT_EQ(userFolder(UserFolder::runtime), "");
}

TEST(UserFolder, IsWhereItsVariableSays) {
  const Variables variables{{{"HOME", "/home/asimov"},
                             {"XDG_CACHE_HOME", "/a"},
                             {"XDG_CONFIG_HOME", "/b"},
                             {"XDG_STATE_HOME", "/c"},
                             {"XDG_RUNTIME_DIR", "/d"}}};
  EXPECT_EQ(userFolder(UserFolder::cache), "/a/gt2003");
  EXPECT_EQ(userFolder(UserFolder::config), "/b/gt2003");
  EXPECT_EQ(userFolder(UserFolder::state), "/c/gt2003");
  EXPECT_EQ(userFolder(UserFolder::runtime), "/d/gt2003");
}

TEST(UserFolder, IsNoneThatDependsOnTheWorkingDirectory) {
  const Variables relative{{{"HOME", "here"}, {"XDG_STATE_HOME", "state"}, {"XDG_CACHE_HOME", ""}}};
  for (const UserFolder folder :
       {UserFolder::cache, UserFolder::config, UserFolder::state, UserFolder::runtime})
    EXPECT_EQ(userFolder(folder), "");
}

}  // namespace
}  // namespace gt
