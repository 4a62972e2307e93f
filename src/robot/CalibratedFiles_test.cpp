#include "robot/CalibratedFiles.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "base/File.h"
#include "base/TemporaryFolder.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

class CalibratedFilesTest : public ::testing::Test {
 protected:
  CalibratedFilesTest() {
    write("config/calibrated.cfg",
          "// Which files fit what.\n"
          "[files.0]\n"
          "file config/table.cfg\n"
          "command \"measure, then write\"\n"
          "sources.0 motions - // of all kinds\n"
          "sources.1 src/world.cpp -\n"
          "[files.1]\n"
          "file config/other.cfg\n"
          "command paint\n"
          "sources.0 motions -\n");
    write("motions/kick.mof", "lift 3\nstretch 4\n");
    write("motions/more/wave.mof", "wave\n");
    write("src/world.cpp", "int gravity = 9;  // m/s^2\n");
    keep("config/table.cfg");
    keep("config/other.cfg");
  }

  void write(const std::string& name, std::string_view text) const {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    ASSERT_TRUE(writeFile(file.string(), text));
  }
  void keep(const std::string& file) const {
    const auto done = keepCalibratedFile(folder_.path().string(), file);
    ASSERT_TRUE(done) << done.error().text();
  }
  /// What is found, with the folder's name left out.
  std::string found() const {
    std::string text = checkCalibratedFiles(folder_.path().string()).text();
    const std::string folder = folder_.path().string() + '/';
    for (std::size_t at = 0; (at = text.find(folder)) != text.npos;) text.erase(at, folder.size());
    return text;
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

TEST_F(CalibratedFilesTest, AreToldWithWhatHasChanged) {
  EXPECT_EQ(found(), "");
  write("motions/kick.mof", "stretch 4\nlift 3\n");
  EXPECT_EQ(found(),
            "config/table.cfg: warning: motions has changed since it was measured to fit; made "
            "anew by: measure, then write\n"
            "config/other.cfg: warning: motions has changed since it was measured to fit; made "
            "anew by: paint\n");
  write("src/world.cpp", "int gravity = 8;\n");
  keep("config/other.cfg");
  EXPECT_EQ(found(),
            "config/table.cfg: warning: motions, src/world.cpp have changed since it was measured "
            "to fit; made anew by: measure, then write\n");
}

TEST_F(CalibratedFilesTest, FitHoweverTheirSourcesAreWritten) {
  write("motions/kick.mof", "// A kick.\n  lift 3\r\n\r\nstretch 4");
  write("src/world.cpp", "int gravity = 9;\n");
  EXPECT_EQ(found(), "");
}

TEST_F(CalibratedFilesTest, DependOnNamesToo) {
  fs::rename(path("motions/kick.mof"), path("motions/other.mof"));
  EXPECT_THAT(found(), ::testing::HasSubstr("config/other.cfg: warning: motions has changed"));
}

TEST_F(CalibratedFilesTest, OfAnInstallationLackTheSourcesOfPrograms) {
  fs::remove(path("src/world.cpp"));
  EXPECT_EQ(found(),
            "config/calibrated.cfg: config/table.cfg: src/world.cpp: there is no such file\n");
  fs::remove(path("src"));
  EXPECT_EQ(found(), "");
  fs::remove(path("config/calibrated.cfg"));
  EXPECT_EQ(found(), "");
}

TEST_F(CalibratedFilesTest, KeepTheRestOfTheList) {
  const auto before = readFile(path("config/calibrated.cfg").string());
  write("src/world.cpp", "int gravity = 8;\n");
  keep("config/table.cfg");
  const auto after = readFile(path("config/calibrated.cfg").string());
  ASSERT_TRUE(before && after);
  EXPECT_NE(*before, *after);
  for (const std::string& text : {*before, *after})
    EXPECT_THAT(text, ::testing::MatchesRegex("// Which files fit what.\n"
                                              "\\[files.0\\]\n"
                                              "file config/table.cfg\n"
                                              "command \"measure, then write\"\n"
                                              "sources.0 motions [0-9a-f]+ // of all kinds\n"
                                              "sources.1 src/world.cpp [0-9a-f]+\n"
                                              "\\[files.1\\]\n"
                                              "file config/other.cfg\n"
                                              "command paint\n"
                                              "sources.0 motions [0-9a-f]+\n"));
}

TEST_F(CalibratedFilesTest, AreListedOrRefused) {
  const auto done = keepCalibratedFile(path("").string(), "config/none.cfg");
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().what, "is not listed");
  EXPECT_EQ(done.error().field, "config/none.cfg");
}

}  // namespace
}  // namespace gt
