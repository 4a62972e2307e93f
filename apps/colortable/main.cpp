#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

#include "colortable/GameViews.h"
#include "colors/ColorTableFile.h"

namespace {

using namespace gt;

/// How often each colour was seen in each class.
class ColorHistogram {
 public:
  ColorHistogram() : counts_(colors) {}

  /// Counts the pixels whose neighbours are of the same class: others are mixed by blur.
  void add(const GameView& view) {
    const int width = view.image.info.width, height = view.image.info.height;
    const auto& classes = view.truth.classes;
    for (int y = 1; y < height - 1; ++y)
      for (int x = 1; x < width - 1; ++x) {
        const int i = y * width + x;
        const auto at = [&](int k) { return classes[static_cast<std::size_t>(k)]; };
        const ColorClass c = at(i);
        if (at(i - 1) != c || at(i + 1) != c || at(i - width) != c || at(i + width) != c) continue;
        const Pixel& p = view.image.at(x, y);
        ++counts_[ColorTable64::index(p.y, p.cb, p.cr)][static_cast<std::size_t>(c)];
      }
  }

  /// The class that most pixels of each colour have. Colours of several classes stay without one,
  /// colours never seen take that of their neighbours.
  ColorTable64 table(int growth) const {
    ColorTable64 table;
    for (std::size_t i = 0; i < colors; ++i) {
      const auto& count = counts_[i];
      std::uint32_t total = 0;
      for (const std::uint32_t n : count) total += n;
      const auto best = std::max_element(count.begin(), count.end());
      if (total >= 2 && 10 * *best >= 7 * total)
        table.classes[i] = static_cast<ColorClass>(best - count.begin());
    }
    for (int i = 0; i < growth; ++i) grow(table);
    return table;
  }

 private:
  static constexpr std::size_t colors = 64 * 64 * 64;

  // One step into the colours never seen, where all neighbours with a class agree.
  void grow(ColorTable64& table) const {
    const ColorTable64 before = table;
    for (int y = 0; y < 64; ++y)
      for (int cb = 0; cb < 64; ++cb)
        for (int cr = 0; cr < 64; ++cr) {
          const auto i = static_cast<std::size_t>(y << 12 | cb << 6 | cr);
          if (before.classes[i] != ColorClass::noColor || seen(i)) continue;
          table.classes[i] = neighbour(before, y, cb, cr);
        }
  }

  bool seen(std::size_t i) const {
    return std::any_of(counts_[i].begin(), counts_[i].end(), [](auto n) { return n > 1; });
  }

  static ColorClass neighbour(const ColorTable64& table, int y, int cb, int cr) {
    ColorClass found = ColorClass::noColor;
    for (int dy = -1; dy <= 1; ++dy)
      for (int db = -1; db <= 1; ++db)
        for (int dr = -1; dr <= 1; ++dr) {
          const int a = y + dy, b = cb + db, c = cr + dr;
          if (std::min({a, b, c}) < 0 || std::max({a, b, c}) > 63) continue;
          const ColorClass other = table.classes[static_cast<std::size_t>(a << 12 | b << 6 | c)];
          if (other == ColorClass::noColor || other == found) continue;
          if (found != ColorClass::noColor) return ColorClass::noColor;
          found = other;
        }
    return found;
  }

  std::vector<std::array<std::uint32_t, enumCount<ColorClass>>> counts_;
};

struct Options {
  std::string scene = "scenes/match.scene", out = "config/coltable.c64";
  std::uint64_t seed = 1;
  int moments = 400, growth = 4;
};

Result<void> learn(const Options& options) {
  const auto scene = loadScene(options.scene);
  if (!scene) return scene.error();
  auto views = GameViews::make(*scene, options.seed);
  if (!views) return views.error();
  ColorHistogram histogram;
  // Light is never the same twice.
  constexpr std::array brightness{0.85, 0.95, 1.0, 1.05, 1.15};
  for (int i = 0; i < options.moments; ++i) {
    views->shuffle();
    CameraEffects effects = views->scene().camera;
    effects.brightness = brightness[static_cast<std::size_t>(i) % brightness.size()];
    for (std::size_t robot = 0; robot < views->world().activeRobots(); ++robot)
      histogram.add(views->look(robot, effects));
  }
  const ColorTable64 table = histogram.table(options.growth);
  std::ofstream file(options.out, std::ios::binary);
  file << colorTableBytes(table);
  if (!file.flush()) return Error{options.out, 0, "", "cannot be written"};
  std::array<int, enumCount<ColorClass>> sizes{};
  for (const ColorClass c : table.classes) ++sizes[static_cast<std::size_t>(c)];
  for (std::size_t i = 0; i < sizes.size(); ++i)
    fmt::print("{:8} {:6} colours\n", enumNames<ColorClass>[i], sizes[i]);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Learns a colour table from the simulator's pictures, whose true classes are known"};
  app.add_option("--scene", options.scene, "who stands in the pictures");
  app.add_option("--out", options.out, "the colour table");
  app.add_option("--seed", options.seed, "of chance");
  app.add_option("--moments", options.moments, "each gives one picture per robot")
      ->check(CLI::Range(1, 100000));
  app.add_option("--growth", options.growth, "steps into colours never seen")
      ->check(CLI::Range(0, 64));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto done = learn(options);
  if (!done) fmt::print(stderr, "{}\n", done.error().text());
  return done ? 0 : 2;
}
