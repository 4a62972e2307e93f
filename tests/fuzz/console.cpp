#include "console/Console.h"

#include "Fuzz.h"

namespace {

/// A robot without a simulator; time does not pass.
class FuzzWorld : public gt::ConsoleWorld {
 public:
  FuzzWorld() {
    const auto configuration = gt::loadConfiguration({});
    const auto layout = gt::loadLayout("layouts/single.layout");
    if (!configuration || !layout) std::abort();
    auto robot = gt::Robot::make({*configuration, *layout, {}, 1});
    if (!robot) std::abort();
    robot_ = std::move(*robot);
  }
  std::vector<NamedRobot> robots() override { return {{"red1", robot_.get()}}; }
  bool step() override { return false; }
  gt::Time time() const override { return {}; }
  void print(std::string_view) override {}

 private:
  std::unique_ptr<gt::Robot> robot_;
};

}  // namespace

/// Lines of a console or a script, one after another on the same robot.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static FuzzWorld world;
  gt::Console console{world};
  const std::string text{gt::textOf(data, size)};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    // A script would be any file of the machine.
    if (line.find("call") == line.npos && line.find("layout") == line.npos)
      (void)!console.execute(line);
    at = end + 1;
  }
  world.robots().front().robot->fromTools().clear();
  return 0;
}
