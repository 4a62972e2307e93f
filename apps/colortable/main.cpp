#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>

#include "colors/ColorConfusion.h"
#include "colors/ColorTableEditor.h"
#include "colortable/ColorFiles.h"
#include "colortable/Pictures.h"
#include "views/painting/ColorClassViews.h"

namespace {

using namespace gt;

/// What the command line tells; each command uses some of it.
struct Arguments {
  PictureSource source;
  Learning learning;
  std::string table, other, out;
  bool nao2009 = false;
  bool remove = false;
  MedianRule rule{0, 1, false};
  std::string colorClass, picture;

  ColorClassOrder order() const {
    return nao2009 ? ColorClassOrder{nao2009ColorOrder} : ColorClassOrder{gt2003ColorOrder};
  }
};

void printSizes(const ColorTable64& table) {
  EnumArray<ColorClass, int> sizes;
  for (const ColorClass c : table.classes) ++sizes[c];
  for (std::size_t i = 0; i < sizes.size(); ++i)
    fmt::print("{:8} {:6} colours\n", enumNames<ColorClass>[i], sizes.values[i]);
}

/// An error if there is nothing to learn from.
Result<void> checkLabels(const PictureSource& source) {
  if (!source.simulated() && source.labels.empty())
    return Error{"", 0, "--labels", "must tell what the pictures show"};
  return {};
}

Result<void> learn(const Arguments& a) {
  if (auto done = checkLabels(a.source); !done) return done;
  ColorStatistics statistics;
  const auto done = forEachPicture(a.source, [&](const std::string&, const LabelledPicture& p) {
    statistics.add(p);
    return true;
  });
  if (!done) return done;
  const auto table = writeLearnt(a.out, statistics, a.learning);
  if (!table) return table.error();
  printSizes(*table);
  return {};
}

Result<void> confusion(const Arguments& a) {
  if (auto done = checkLabels(a.source); !done) return done;
  const auto table = readColors(a.table, a.order());
  if (!table) return table.error();
  ColorConfusion confusion;
  const auto done = forEachPicture(a.source, [&](const std::string&, const LabelledPicture& p) {
    p.forEachPixel([&](const Pixel& pixel, ColorClass c) { confusion.add(c, (*table)[pixel]); });
    return true;
  });
  if (done) fmt::print("{}", confusion.text("truth", a.table));
  return done;
}

Result<void> compare(const Arguments& a) {
  const auto first = readColors(a.table, a.order());
  if (!first) return first.error();
  const auto second = readColors(a.other, a.order());
  if (!second) return second.error();
  fmt::print("{}", compareTables(*first, *second).text("first", "second"));
  return {};
}

Result<void> convert(const Arguments& a) {
  const auto table = readColors(a.table, a.order());
  if (!table) return table.error();
  return writeColors(a.out, *table);
}

Result<void> filter(const Arguments& a) {
  const auto table = readColors(a.table, a.order());
  if (!table) return table.error();
  std::optional<ColorClass> selected;
  if (!a.colorClass.empty()) {
    selected = enumValue<ColorClass>(a.colorClass);
    if (!selected || selected == ColorClass::noColor)
      return Error{"", 0, "--class", "there is no class '" + a.colorClass + "'"};
  }
  ColorTableEditor editor{*table};
  if (a.remove) editor.removeIsolated(selected);
  if (a.rule.neighbors > 0) editor.median(a.rule, selected);
  if (auto done = writeColors(a.out, editor.table()); !done) return done;
  printSizes(editor.table());
  return {};
}

Result<void> show(const Arguments& a) {
  const auto table = readColors(a.table, a.order());
  if (!table) return table.error();
  return tableSheet(*table).write(a.out);
}

/// A picture beside its classes.
Result<void> segment(const Arguments& a) {
  const auto table = readColors(a.table, a.order());
  if (!table) return table.error();
  Result<void> written = Error{"", 0, "--picture", "there is no picture " + a.picture};
  const auto done =
      forEachPicture(a.source, [&](const std::string& name, const LabelledPicture& p) {
        if (!a.picture.empty() && name != a.picture) return true;
        const int width = p.image.info.width, height = p.image.info.height;
        const int scale = std::max(1, std::min(4, 1600 / (2 * width)));
        Sheet sheet{2 * width * scale + 8, height * scale};
        sheet.paint(rgbOf(p.image), {0, 0}, scale);
        sheet.paint(classesOf(p.image, *table), {width * scale + 8.0, 0}, scale);
        written = sheet.write(a.out);
        return false;
      });
  return done ? written : done;
}

void addSource(CLI::App& command, PictureSource& source) {
  command.add_option("--scene", source.scene, "A scene, whose pictures are simulated")
      ->capture_default_str();
  command.add_option("--seed", source.seed, "Of chance in the scene");
  command.add_option("--moments", source.moments, "Of the scene: each gives one picture a robot")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  command.add_option("--light", source.light, "Of the scene: by which share it grows and shrinks")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  auto* log = command.add_option("--log", source.log,
                                 "A log with pictures (.mcap), or one of the real robot of 2009");
  auto* files = command.add_option("--pictures", source.files, "Pictures as JPEG")->excludes(log);
  log->excludes(files);
  command.add_option("--labels", source.labels,
                     "What a log's or files' pictures show: picture,class,left,top,right,bottom");
}

}  // namespace

/// colortable: learns, judges, converts and shows colour classes.
int main(int argc, char** argv) {
  CLI::App app{"Colour tables (.c64), HSI ranges (.hsi) and TSL thresholds (.tsl)"};
  app.require_subcommand(1);
  Arguments a;
  std::function<Result<void>(const Arguments&)> run;
  const auto command = [&](const char* name, const char* what, auto action) -> CLI::App& {
    CLI::App& sub = *app.add_subcommand(name, what);
    sub.callback([&run, action] { run = action; });
    return sub;
  };
  const auto addTable = [&](CLI::App& sub) {
    sub.add_option("table", a.table, "A .c64, .hsi or .tsl file")->required();
    sub.add_flag("--nao2009", a.nao2009, ".c64 files have the classes of the real robot of 2009");
  };
  CLI::App& learning = command(
      "learn", "Learns from simulated pictures, whose true classes are known, or from labels",
      learn);
  addSource(learning, a.source);
  learning.add_option("--out", a.out, "What is learnt: .c64, .hsi or .tsl")->required();
  learning.add_option("--growth", a.learning.growth, "Of tables: steps into colours never seen")
      ->check(CLI::Range(0, 64))
      ->capture_default_str();
  learning
      .add_option("--share", a.learning.share,
                  "Of HSI and TSL: how many of a class's pixels lie in each of its ranges")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  CLI::App& judging =
      command("confusion", "Compares what a table says of pictures with the truth", confusion);
  addTable(judging);
  addSource(judging, a.source);
  CLI::App& comparing = command("compare", "Compares two tables colour by colour", compare);
  addTable(comparing);
  comparing.add_option("other", a.other, "The other one")->required();
  CLI::App& converting = command("convert", "Writes what a file says as a table", convert);
  addTable(converting);
  converting.add_option("out", a.out, "A .c64 file")->required();
  CLI::App& filtering = command("filter", "Removes and adds colours by their neighbours", filter);
  addTable(filtering);
  filtering.add_option("out", a.out, "A .c64 file")->required();
  filtering.add_flag("--remove", a.remove, "Removes colours without a neighbour of their class");
  filtering
      .add_option("--median", a.rule.neighbors,
                  "Adds colours that have so many colours of a class near")
      ->check(CLI::Range(1, 10'000));
  filtering.add_option("--distance", a.rule.distance, "How far away those may be, in cubes")
      ->check(CLI::Range(1, 8))
      ->capture_default_str();
  filtering.add_flag("--reassign", a.rule.reassign, "Also colours that have a class");
  filtering.add_option("--class", a.colorClass, "Only this class");
  CLI::App& showing = command("show", "Paints a table as PNG or SVG", show);
  addTable(showing);
  showing.add_option("out", a.out)->required();
  CLI::App& segmenting = command("segment", "Paints a picture beside its classes", segment);
  addTable(segmenting);
  segmenting.add_option("out", a.out, "PNG or SVG")->required();
  addSource(segmenting, a.source);
  segmenting.add_option(
      "--picture", a.picture,
      "Its number, of a scene MOMENT.ROBOT, or its name; otherwise the first one");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto done = run(a);
  if (!done) fmt::print(stderr, "colortable: {}\n", done.error().text());
  return done ? 0 : 2;
}
