#include "simulation/scene/ModelFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace gt {
namespace {

namespace fs = std::filesystem;

using testing::ElementsAre;

/// A folder with a model and its parts.
class ModelFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path{testing::TempDir()} /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_ / "parts");
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream{folder_ / name} << text;
    return (folder_ / name).string();
  }
  /// What is wrong with a model, each below the folder.
  std::vector<std::string> errorsOf(const std::string& text) {
    std::vector<Error> errors;
    const auto model = ModelFile::read(write("model.xml", text), errors);
    EXPECT_EQ(model.has_value(), errors.empty());
    std::vector<std::string> texts;
    for (const Error& error : errors) {
      std::string line = error.text();
      for (std::size_t at; (at = line.find(folder_.string() + "/")) != line.npos;)
        line.erase(at, folder_.string().size() + 1);
      texts.push_back(line);
    }
    return texts;
  }

  fs::path folder_;
};

TEST_F(ModelFiles, IncludesAreRelativeToTheFirstFile) {
  write("parts/one.xml", "<mujocoinclude><a/><include file='parts/two.xml'/><c/></mujocoinclude>");
  write("parts/two.xml", "<any>\n<b/></any>");
  std::vector<Error> errors;
  const auto file = ModelFile::read(
      write("model.xml", "<mujoco><include file='parts/one.xml'/><d/></mujoco>"), errors);
  ASSERT_TRUE(file) << errors.front().text();
  std::string names;
  for (const xmlNode* node : elementsOf(file->root())) names += nameOf(node);
  EXPECT_EQ(names, "abcd");
  EXPECT_EQ(file->at(elementsOf(file->root())[1], "", "x").text(),
            (folder_ / "parts/two.xml").string() + ":2: x");
  EXPECT_EQ(file->at(elementsOf(file->root())[2], "", "x").file,
            (folder_ / "parts/one.xml").string());
}

TEST_F(ModelFiles, PathsLeadThroughLinks) {
  fs::create_directories(folder_ / "elsewhere/deep");
  write("elsewhere/part.xml", "<mujoco><a/></mujoco>");
  fs::create_directory_symlink(folder_ / "elsewhere/deep", folder_ / "link");
  EXPECT_THAT(errorsOf("<mujoco><include file='link/../part.xml'/></mujoco>"), ElementsAre());
}

TEST_F(ModelFiles, WrongIncludes) {
  write("empty.xml", "<mujoco/>");
  write("broken.xml", "<mujoco>\n<a></mujoco>");
  write("itself.xml", "<mujoco><include file='itself.xml'/></mujoco>");
  write("a.xml", "<mujoco><a/></mujoco>");
  EXPECT_THAT(errorsOf("<mujoco>\n<include/></mujoco>"),
              ElementsAre("model.xml:2: file: expected the name of a file"));
  EXPECT_THAT(errorsOf("<mujoco>\n<include file='absent.xml'/></mujoco>"),
              ElementsAre("model.xml:2: file: there is no file absent.xml"));
  EXPECT_THAT(errorsOf("<mujoco><include file='empty.xml'/></mujoco>"),
              ElementsAre("model.xml:1: file: there are no elements in empty.xml"));
  EXPECT_THAT(errorsOf("<mujoco><include file='itself.xml'/></mujoco>"),
              ElementsAre("itself.xml:1: file: a second time itself.xml"));
  EXPECT_THAT(errorsOf("<mujoco><include file='a.xml'/><include file='a.xml'/></mujoco>"),
              ElementsAre("model.xml:1: file: a second time a.xml"));
  EXPECT_THAT(errorsOf("<mujoco><include file='model.xml'/></mujoco>"),
              ElementsAre("model.xml:1: file: a second time model.xml"));
  EXPECT_THAT(errorsOf("<mujoco><include file='a.xml'><b/></include></mujoco>"),
              ElementsAre("model.xml:1: include: has no content"));
  EXPECT_THAT(errorsOf("<mujoco><include file='broken.xml'/></mujoco>"),
              ElementsAre(testing::StartsWith("broken.xml:2:13: ")));
}

TEST_F(ModelFiles, NoIncludeIsTooDeep) {
  for (int i = 0; i < 20; ++i)
    write("part" + std::to_string(i) + ".xml",
          "<m><a><include file='part" + std::to_string(i + 1) + ".xml'/></a></m>");
  EXPECT_THAT(errorsOf("<mujoco><include file='part0.xml'/></mujoco>"),
              ElementsAre("part15.xml:1: include: is deeper than 16"));
}

TEST_F(ModelFiles, AssetsThatAreMissing) {
  EXPECT_THAT(
      errorsOf("<mujoco><compiler meshdir='m' texturedir='t'/>\n<asset>\n<mesh file='a.stl'/>\n"
               "<texture fileup='b.png'/>\n<hfield file='c.png'/></asset></mujoco>"),
      ElementsAre("model.xml:3: file: there is no file m/a.stl",
                  "model.xml:4: fileup: there is no file t/b.png",
                  "model.xml:5: file: there is no file m/c.png"));
}

TEST_F(ModelFiles, MeanTheSameInAnyWorkingDirectory) {
  std::vector<Error> errors;
  const auto file = ModelFile::read("tests/models/degree.xml", errors);
  ASSERT_TRUE(file);
  const fs::path here = fs::current_path();
  fs::current_path("/");
  const auto model = file->compile();
  fs::current_path(here);
  ASSERT_TRUE(model) << model.error().text();
  EXPECT_GE(mj_name2id(model->get(), mjOBJ_MESH, "wedge"), 0) << "named as its file";
}

}  // namespace
}  // namespace gt
