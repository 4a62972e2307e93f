#include "xabsl/formats/Root.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "xabsl/language/VirtualFiles.h"

namespace xabsl {
namespace {

const VirtualFiles behaviorInFolders = {
    {"/b/agents.xabsl", "include \"options/main.xabsl\"; agent m(\"M\", main);"},
    {"/b/no_agents.xabsl", "include \"options/alone.xabsl\";"},
    {"/b/options/main.xabsl", "option main { initial state s { action { } } }"},
    {"/b/options/alone.xabsl", "option alone { initial state s { action { } } }"}};

std::string rootInMemory(const std::string& path, const std::string& last = {}) {
  const FolderLister lister = [](const std::string& folder) {
    std::vector<std::string> paths;
    for (const auto& [file, text] : behaviorInFolders)
      if (std::filesystem::path(file).parent_path() == folder) paths.push_back(file);
    return paths;
  };
  return rootOf(path, lister, readerOf(behaviorInFolders), last);
}

TEST(Root, IsTheFileWithAgentsThatIncludesAnotherOne) {
  EXPECT_EQ(rootInMemory("/b/options/main.xabsl"), "/b/agents.xabsl");
  EXPECT_EQ(rootInMemory("/b/agents.xabsl"), "/b/agents.xabsl");
  EXPECT_EQ(rootInMemory("/b/options/alone.xabsl"), "");
  EXPECT_EQ(rootInMemory("/b/options/main.xabsl", "/b/options"), "");
  EXPECT_EQ(rootInMemory("/nowhere/main.xabsl"), "");
}

TEST(Root, IsFoundOnDisk) {
  const std::string agents = std::filesystem::absolute("src/xabsl/example/agents.xabsl");
  const std::string option = std::filesystem::absolute("src/xabsl/example/options/play.xabsl");
  EXPECT_EQ(rootOf(option, diskLister(), diskReader()), agents);
}

}  // namespace
}  // namespace xabsl
