#include "base/DataRoot.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

namespace gt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Roots of empty folders below a folder of their own.
class DataRootTest : public testing::Test {
 protected:
  DataRootTest()
      : folder_{fs::canonical(fs::temp_directory_path()) /
                ("gt2003-root-" + std::to_string(getpid()))} {}
  ~DataRootTest() override { fs::remove_all(folder_); }

  std::string makeRoot(const std::string& name) const {
    for (const char* content : {"behavior", "config", "layouts", "models", "motions", "scenes"})
      fs::create_directories(folder_ / name / content);
    return (folder_ / name).string();
  }
  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  static std::string found(const DataRoot::Places& places) {
    const auto root = DataRoot::find(places);
    return root ? root->path("config") : root.error().text();
  }

 private:
  fs::path folder_;
};

TEST_F(DataRootTest, PlacesWinInTheirOrder) {
  const std::string option = makeRoot("option"), variable = makeRoot("variable"),
                    installed = makeRoot("prefix/share/gt2003"), sources = makeRoot("sources");
  DataRoot::Places places{option, variable, in("prefix/bin/simgt"), sources};
  EXPECT_EQ(found(places), option + "/config");
  places.option.clear();
  EXPECT_EQ(found(places), variable + "/config");
  places.variable.clear();
  EXPECT_EQ(found(places), installed + "/config");
  places.program = in("elsewhere/bin/simgt");
  EXPECT_EQ(found(places), sources + "/config");
}

TEST_F(DataRootTest, AProgramBelowARootFindsIt) {
  const std::string tree = makeRoot("tree"), sources = makeRoot("sources");
  EXPECT_EQ(found({"", "", in("tree/build/release/bin/simgt"), sources}), tree + "/config");
}

TEST_F(DataRootTest, WhatIsNamedMustBeARoot) {
  const std::string sources = makeRoot("sources"), broken = makeRoot("broken");
  fs::remove_all(broken + "/motions");
  EXPECT_EQ(found({broken, "", "", sources}),
            broken + ": --root: is no data root: it has no folder 'motions'");
  EXPECT_EQ(found({"", "/nowhere", "", sources}),
            "/nowhere: GT2003_ROOT: is no data root: it has no folder 'behavior'");
  EXPECT_THAT(found({"", "", "/nowhere/bin/simgt", ""}), HasSubstr("no data root found"));
}

TEST_F(DataRootTest, PathsInTheWorkingDirectoryAreRelative) {
  EXPECT_EQ(DataRoot{}.path("scenes/match.scene"), "scenes/match.scene");
  EXPECT_EQ(DataRoot{fs::current_path().string()}.path("config"), "config");
  EXPECT_EQ(DataRoot{"tests"}.path("config"), "tests/config");
  EXPECT_EQ(DataRoot{".."}.path("config"), fs::current_path().parent_path().string() + "/config");
}

}  // namespace
}  // namespace gt
