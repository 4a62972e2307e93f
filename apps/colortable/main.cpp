#include <fmt/core.h>

#include <filesystem>
#include <optional>

#include "colors/ColorConfusion.h"
#include "colors/ColorOrder.h"
#include "colors/ColorTableEditor.h"
#include "colortable/ColorFiles.h"
#include "colortable/Images.h"
#include "commandline/CommandLine.h"
#include "measure/Figures.h"
#include "views/painting/ColorClassViews.h"

namespace {

using namespace gt;

/// The arguments of the command line; each command uses a part of them.
struct Arguments {
  ImageSource source;
  Learning learning;
  std::string table, other, out, json;
  bool nao2009 = false;
  bool remove = false;
  MedianRule rule{0, 1, false};
  std::string colorClass, picture;

  /// Reads a table, and warns if that was probably in the wrong order.
  Result<ColorTable64> read(const std::string& file) const {
    const auto colors = readColors(
        file, nao2009 ? ColorClassOrder{nao2009ColorOrder} : ColorClassOrder{gt2003ColorOrder});
    if (!colors) return colors;
    const std::string doubt =
        doubtOfOrder(*colors, file, nao2009, nao2009 ? "without --nao2009" : "--nao2009");
    if (!doubt.empty()) fmt::print(stderr, "colortable: warning: {}\n", doubt);
    return colors;
  }
};

void printSizes(const ColorTable64& table) {
  EnumArray<ColorClass, int> sizes;
  for (const ColorClass c : table.classes) ++sizes[c];
  for (std::size_t i = 0; i < sizes.size(); ++i)
    fmt::print("{:8} {:6} colors\n", enumNames<ColorClass>[i], sizes.values[i]);
}

/// An error if there is nothing to learn from.
Result<void> checkLabels(const ImageSource& source) {
  if (!source.simulated() && source.labels.empty())
    return Error{.field = "--labels", .what = "must state what the images show"};
  return {};
}

Result<void> learn(const Arguments& a) {
  if (auto done = checkLabels(a.source); !done) return done;
  ColorStatistics statistics;
  const auto done = forEachImage(a.source, [&](const std::string&, const LabeledImage& p) {
    statistics.add(p);
    return true;
  });
  if (!done) return done;
  const auto table = writeLearnt(a.out, statistics, a.learning);
  if (!table) return table.error();
  printSizes(*table);
  return {};
}

/// How much a table sees of each class, and how much of it is right, by the table's kind:
/// colors.c64.
Result<void> writeFigures(const ColorConfusion& confusion, const Arguments& a) {
  Figures figures;
  const std::string kind = "colors" + std::filesystem::path{a.table}.extension().string();
  figures.add(kind + ".right", "%", {100 * confusion.accuracy()});
  for (const std::string_view name : enumNames<ColorClass>) {
    const ColorClass c = *enumValue<ColorClass>(name);
    figures.add(fmt::format("{}.{}.recall", kind, name), "%", {100 * confusion.recall(c)});
    figures.add(fmt::format("{}.{}.precision", kind, name), "%", {100 * confusion.precision(c)});
  }
  return figures.write(a.json);
}

Result<void> confusion(const Arguments& a) {
  if (auto done = checkLabels(a.source); !done) return done;
  const auto table = a.read(a.table);
  if (!table) return table.error();
  ColorConfusion confusion;
  const auto done = forEachImage(a.source, [&](const std::string&, const LabeledImage& p) {
    p.forEachPixel([&](const Pixel& pixel, ColorClass c) { confusion.add(c, (*table)[pixel]); });
    return true;
  });
  if (!done) return done;
  fmt::print("{}", confusion.text("truth", a.table));
  return a.json.empty() ? Result<void>{} : writeFigures(confusion, a);
}

Result<void> compare(const Arguments& a) {
  const auto first = a.read(a.table);
  if (!first) return first.error();
  const auto second = a.read(a.other);
  if (!second) return second.error();
  fmt::print("{}", compareTables(*first, *second).text("first", "second"));
  return {};
}

Result<void> convert(const Arguments& a) {
  const auto table = a.read(a.table);
  if (!table) return table.error();
  return writeColors(a.out, *table);
}

Result<void> filter(const Arguments& a) {
  const auto table = a.read(a.table);
  if (!table) return table.error();
  std::optional<ColorClass> selected;
  if (!a.colorClass.empty()) {
    selected = enumValue<ColorClass>(a.colorClass);
    if (!selected || selected == ColorClass::noColor)
      return Error{.field = "--class", .what = "there is no class '" + a.colorClass + "'"};
  }
  ColorTableEditor editor{*table};
  if (a.remove) editor.removeIsolated(selected);
  if (a.rule.neighbors > 0) editor.median(a.rule, selected);
  if (auto done = writeColors(a.out, editor.table()); !done) return done;
  printSizes(editor.table());
  return {};
}

Result<void> show(const Arguments& a) {
  const auto table = a.read(a.table);
  if (!table) return table.error();
  return tableSheet(*table).write(a.out);
}

/// An image beside its classes.
Result<void> segment(const Arguments& a) {
  const auto table = a.read(a.table);
  if (!table) return table.error();
  Result<void> written = Error{.field = "--picture", .what = "there is no image " + a.picture};
  const auto done = forEachImage(a.source, [&](const std::string& name, const LabeledImage& p) {
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

void addSource(CLI::App& command, ImageSource& source) {
  command.add_option("--scene", source.scene, "A scene, whose images are simulated")
      ->capture_default_str();
  command.add_option("--seed", source.seed, "Of chance in the scene");
  command.add_option("--moments", source.moments, "Of the scene: each gives one image a robot")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  command.add_option("--light", source.light, "Of the scene: by which share it grows and shrinks")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  auto* log = command.add_option("--log", source.log,
                                 "A log with images (.mcap), or one of the real robot of 2009");
  auto* files = command.add_option("--pictures", source.files, "Images as JPEG")->excludes(log);
  log->excludes(files);
  command.add_option("--labels", source.labels,
                     "What a log's or files' pictures show: picture,class,left,top,right,bottom");
}

using Action = Result<void> (*)(const Arguments&);

/// Adds a command that reads a table.
CLI::App& addCommand(CommandLine& line, Arguments& a, const char* name, const char* description,
                     Action action) {
  CLI::App& command = line.command(name, description, [&a, action] { return action(a); });
  command.add_option("table", a.table, "A .c64, .hsi or .tsl file")->required();
  command.add_flag("--nao2009", a.nao2009, ".c64 files have the classes of the real robot of 2009");
  return command;
}

void addLearning(CommandLine& line, Arguments& a) {
  CLI::App& command = line.command(
      "learn", "Learns from simulated images, whose true classes are known, or from labels",
      [&a] { return learn(a); });
  addSource(command, a.source);
  command.add_option("--out", a.out, "What is learned: .c64, .hsi or .tsl")->required();
  command.add_option("--growth", a.learning.growth, "Of tables: steps into colors never seen")
      ->check(CLI::Range(0, 64))
      ->capture_default_str();
  command
      .add_option("--share", a.learning.share,
                  "Of HSI and TSL: how many of a class's pixels lie in each of its ranges")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
}

void addJudging(CommandLine& line, Arguments& a) {
  CLI::App& judging = addCommand(line, a, "confusion",
                                 "Compares what a table says of images with the truth", confusion);
  addSource(judging, a.source);
  judging.add_option("--json", a.json, "File for the figures");
  addCommand(line, a, "compare", "Compares two tables color by color", compare)
      .add_option("other", a.other, "The other one")
      ->required();
}

void addConversion(CommandLine& line, Arguments& a) {
  addCommand(line, a, "convert", "Writes what a file says as a table", convert)
      .add_option("out", a.out, "A .c64 file")
      ->required();
  CLI::App& filtering =
      addCommand(line, a, "filter", "Removes and adds colors by their neighbors", filter);
  filtering.add_option("out", a.out, "A .c64 file")->required();
  filtering.add_flag("--remove", a.remove, "Removes colors without a neighbor of their class");
  filtering
      .add_option("--median", a.rule.neighbors,
                  "Adds colors that have so many colors of a class near")
      ->check(CLI::Range(1, 10'000));
  filtering.add_option("--distance", a.rule.distance, "How far away those may be, in cubes")
      ->check(CLI::Range(1, 8))
      ->capture_default_str();
  filtering.add_flag("--reassign", a.rule.reassign, "Also colors that have a class");
  filtering.add_option("--class", a.colorClass, "Only this class");
}

void addPainting(CommandLine& line, Arguments& a) {
  addCommand(line, a, "show", "Paints a table as PNG or SVG", show)
      .add_option("out", a.out)
      ->required();
  CLI::App& segmenting =
      addCommand(line, a, "segment", "Paints an image beside its classes", segment);
  segmenting.add_option("out", a.out, "PNG or SVG")->required();
  addSource(segmenting, a.source);
  segmenting.add_option(
      "--picture", a.picture,
      "Its number, of a scene MOMENT.ROBOT, or its name; otherwise the first one");
}

}  // namespace

/// colortable: learns, judges, converts and shows color classes.
int main(int argc, char** argv) {
  CommandLine line{argc, argv, "Color tables (.c64), HSI ranges (.hsi) and TSL thresholds (.tsl)"};
  Arguments arguments;
  arguments.source.root = line.root();
  arguments.source.scene = line.root().path("scenes/match.scene");
  addLearning(line, arguments);
  addJudging(line, arguments);
  addConversion(line, arguments);
  addPainting(line, arguments);
  return line.run();
}
