#include "workbench/Application.h"

#include "workbench/Background.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

/// What ends the event loop once something has happened in it.
std::string failureAfter(const std::function<void()>& begin) {
  QTimer::singleShot(0, begin);
  EXPECT_EQ(QApplication::exec(), 2);
  const auto failure = static_cast<Application*>(QCoreApplication::instance())->takeFailure();
  return failure ? failure->text() : "";
}

TEST(Application, AnExceptionOfAHandlerIsItsFailure) {
  EXPECT_EQ(failureAfter([] { throw std::runtime_error{"the handler"}; }),
            "exception: the handler");
}

TEST(Application, SoIsAnExceptionOfWorkInTheBackground) {
  QObject receiver;
  Background background;
  EXPECT_EQ(failureAfter([&] {
              background.start(
                  &receiver, [](const Background::Progress&) -> int { throw std::bad_alloc{}; },
                  [](int) { ADD_FAILURE() << "there is nothing to show"; });
            }),
            "not enough memory");
  EXPECT_FALSE(background.running());
}

using SessionExceptions = WindowTest;

TEST_F(SessionExceptions, AreErrorsInTheConsoleAfterWhichTimeStands) {
  std::shared_ptr<const void> listener;
  session->change([&](Console& console) {
    listener = console.session().afterSteps([] { throw std::runtime_error{"a step"}; });
    console.session().start();
  });
  std::uint64_t seen = 0;
  std::vector<std::string> lines;
  EXPECT_TRUE(until([&] {
    std::ranges::copy(session->linesSince(seen), std::back_inserter(lines));
    return std::ranges::count(lines, "error: exception: a step") > 0;
  }));
  EXPECT_FALSE(on([](Console& console) { return console.session().started(); }));
  const auto done = execute("run 1");
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().text(), "exception: a step");
  session->change([&](Console&) { listener.reset(); });
  EXPECT_TRUE(execute("run 8 ms"));
}

}  // namespace
}  // namespace gt
