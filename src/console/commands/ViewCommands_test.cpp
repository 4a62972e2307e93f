#include <filesystem>

#include "base/File.h"
#include "console/TestSession.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

using ViewCommands = SessionTest;

/// Notes whom it shows.
class NotingView : public View {
 public:
  explicit NotingView(std::vector<std::string>& shown) : View{"noting", ""}, shown_{shown} {}
  Result<Sheet> show(const ViewSubject& subject, std::span<const double>) const override {
    shown_.push_back(subject.robots.front()->name());
    return Sheet{16, 16};
  }

 private:
  std::vector<std::string>& shown_;
};

/// A film of a robot stays with it when commands for another one follow.
TEST_F(ViewCommands, FilmTheRobotThatWasSelectedWhenTheyBegan) {
  std::vector<std::string> shown;
  expectFine("robot red4");
  ASSERT_TRUE(console->recorder().startFilm(*console, file("a.mp4"),
                                            std::make_shared<NotingView>(shown), {}));
  expectFine("robot red1");
  expectFine("run 200 ms");
  expectFine("film stop");
  EXPECT_GT(shown.size(), 3u);
  EXPECT_THAT(shown, testing::Each("red4"));
  EXPECT_EQ(console->selection(), std::vector<std::string>{"red1"});
}

TEST_F(ViewCommands, RecordsAsOftenAsAskedFor) {
  expectFine("plot ball.x on");
  expectFine("plot ball.x off");
  expectFine("plot ball.x on");
  expectFine("plot ball.x on");
  expectFine("run 1");
  EXPECT_EQ(console->recorder().series().at("ball.x").size(), 25u);
  expectFine("film start " + file("a.mp4") + " field");
  expectError("film start " + file("b.mp4"), "film", "a.mp4 is being made");
  expectFine("run 200 ms");
  EXPECT_THAT(answers("reset"), Contains("written: " + file("a.mp4")));
  EXPECT_GT(std::filesystem::file_size(file("a.mp4")), 500u);
  expectError("film stop", "film", "none is being made");
  EXPECT_TRUE(console->recorder().series().empty());
  // What has recorded may be gone before the session goes on.
  expectFine("plot ball.x on");
  console.reset();
  EXPECT_TRUE(session->step());
}

TEST_F(ViewCommands, ViewsAreDefinedByWhatIsPainted) {
  expectFine("view plain field fieldLines flags");
  expectFine("view mine image image imageProcessor_horizon");
  EXPECT_THAT(answers("view ?"), Contains("plain  defined: plain field fieldLines flags"));
  EXPECT_THAT(answers("picture plain " + file("plain.svg")),
              testing::ElementsAre("written: " + file("plain.svg")));
  const std::string svg = *readFile(file("plain.svg"));
  EXPECT_THAT(svg, testing::Not(HasSubstr("#1e6e32"))) << "no grass without fieldPolygons";
  EXPECT_THAT(svg, HasSubstr("#fa5aaa")) << "flags are pink";
  EXPECT_THAT(console->completions("picture pla"), testing::ElementsAre("plain"));
  expectFine("view plain off");
  expectError("picture plain a.png", "plain", "no such view");
  expectError("view plain off", "plain", "no view was defined");
  expectError("view field field flags", "field", "is a view already");
  expectError("view new field nonsense", "nonsense", "no such drawing");
  expectError("view new cube flags", "view", "expected");
  expectError("picture image", "picture", "expected");
}

}  // namespace
}  // namespace gt
