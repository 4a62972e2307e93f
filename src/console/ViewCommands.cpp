#include <algorithm>

#include "console/Commands.h"
#include "console/Film.h"
#include "console/Values.h"
#include "console/Views.h"
#include "streams/File.h"

namespace gt {
namespace {

constexpr std::int64_t samplePeriod = 40;  // ms, as pictures come
constexpr std::size_t mostSamples = 1'000'000;
constexpr std::size_t mostSeries = 100;

bool isPicture(const std::string& word) {
  return word.ends_with(".png") || word.ends_with(".svg");
}

/// picture [VIEW] FILE {NUMBER}: the scene without a view's name.
Result<void> picture(Console& console, const Words& words) {
  if (words.size() == 2 && words[1] == "?") {
    for (const View& view : views())
      console.print(std::string{view.name} + "  " + std::string{view.help});
    return {};
  }
  const bool named = words.size() > 2 && !isPicture(words[1]);
  const std::size_t file = named ? 2 : 1;
  if (words.size() <= file) return wrongArguments(words);
  const std::string name = named ? words[1] : "scene";
  const auto view =
      std::ranges::find_if(views(), [&](const View& known) { return known.name == name; });
  if (view == views().end()) return Error{"", 0, name, "there is no such view; try picture ?"};
  std::vector<double> numbers;
  for (std::size_t i = file + 1; i < words.size(); ++i) {
    const auto number = numberOf(words[i], -1e5, 1e5);
    if (!number) return number.error();
    numbers.push_back(*number);
  }
  const auto sheet = view->show(console, numbers);
  if (!sheet) return sheet.error();
  return sheet->write(withDefaults(words[file], "out", ".png"));
}

std::vector<std::string> pictureChoices(Console&, const Words& before) {
  std::vector<std::string> names;
  if (before.size() > 1) return names;
  for (const View& view : views()) names.emplace_back(view.name);
  names.emplace_back("?");
  return names;
}

/// Has a value recorded from now on.
Result<void> recordValue(Console& console, const std::string& path) {
  const auto value = valueAt(console, path);
  if (!value) return value.error();
  if (!value->number) return Error{"", 0, path, "is no number, so it cannot be plotted"};
  if (console.series().size() >= mostSeries)
    return Error{"", 0, path, "too many values are plotted"};
  if (!console.series().try_emplace(path).second) return {};
  console.session().recorders().push_back([&console, path] {
    const auto series = console.series().find(path);
    const Time now = console.session().time();
    if (series == console.series().end() || now.ms % samplePeriod != 0 ||
        series->second.size() >= mostSamples)
      return;
    const auto current = valueAt(console, path);
    if (current && current->number) series->second.push_back({now, *current->number});
  });
  return {};
}

/// The recorded values as CSV, a line for each time.
Result<void> writeValues(Console& console, const std::string& file) {
  std::map<std::int64_t, std::map<std::string, double>> rows;
  std::string text = "time";
  for (const auto& [name, samples] : console.series()) {
    text += "," + name;
    for (const auto& [time, value] : samples) rows[time.ms][name] = value;
  }
  text += "\n";
  for (const auto& [time, values] : rows) {
    text += std::to_string(time);
    for (const auto& [name, samples] : console.series()) {
      const auto value = values.find(name);
      text += value == values.end() ? "," : "," + std::to_string(value->second);
    }
    text += "\n";
  }
  return writeFile(file, text);
}

Result<void> plot(Console& console, const Words& words) {
  if (words.size() == 2 && words[1] == "?") {
    for (const auto& [name, samples] : console.series())
      console.print(name + " " + std::to_string(samples.size()) + " values");
    return {};
  }
  if (words.size() != 3 && !(words.size() == 4 && words[1] == "save")) return wrongArguments(words);
  if (words[1] == "save") {
    const std::string file = withDefaults(words[2], "out", ".png");
    if (file.ends_with(".csv")) return writeValues(console, file);
    std::vector<double> seconds;
    if (words.size() == 4) {
      const auto number = numberOf(words[3], 0.001, 1e7);
      if (!number) return number.error();
      seconds.push_back(*number);
    }
    const auto sheet = plotView(console, seconds);
    return sheet ? sheet->write(file) : sheet.error();
  }
  const auto on = switchOf(words, 2);
  if (!on) return on.error();
  if (*on) return recordValue(console, words[1]);
  if (console.series().erase(words[1]) == 0)
    return Error{"", 0, words[1], "is not recorded; try plot ?"};
  return {};
}

std::vector<std::string> plotChoices(Console& console, const Words& before) {
  if (before.size() == 2) return {"on", "off"};
  if (before.size() > 2) return {};
  auto names = valueNames(console);
  names.emplace_back("save");
  names.emplace_back("?");
  return names;
}

Result<void> film(Console& console, const Words& words) {
  if (words.size() == 2 && words[1] == "stop") return stopFilm(console);
  if (words.size() != 3 && words.size() != 4) return wrongArguments(words);
  if (words[1] != "start") return wrongArguments(words);
  const std::string name = words.size() == 4 ? words[3] : "scene";
  const auto view =
      std::ranges::find_if(views(), [&](const View& known) { return known.name == name; });
  if (view == views().end()) return Error{"", 0, name, "there is no such view; try picture ?"};
  return startFilm(console, withDefaults(words[2], "out", ".mp4"), *view);
}

}  // namespace

const std::vector<View>& views() {
  static const std::vector<View> list{
      {"scene", sceneView,
       "the scene from a side; X Y Z and X Y Z in mm may say from where and at what"},
      {"robot", robotView, "the robot from near, with its LEDs; a direction in degrees may follow"},
      {"facette", facetteView,
       "all around the robot's camera, or around X Y Z in mm, each degree a pixel"},
      {"image", imageView, "the camera's picture with the image drawings"},
      {"colorClassImage", colorClassImageView, "the same in colour classes"},
      {"colorSpace", colorSpaceView, "how the picture uses the colour space"},
      {"field", fieldView, "the field from above with the field drawings, and where all truly are"},
      {"radar", radarView, "what lies around the robot; how far in mm may follow"},
      {"xabsl", xabslView, "options, basic behavior and symbols"},
      {"sensors", sensorView, "joints, acceleration, distance and switches"},
      {"times", timeView, "how long each module takes"},
      {"plot", plotView, "what plot records, and the robot's plots; seconds back may follow"}};
  return list;
}

std::vector<Command> viewCommands() {
  using enum Command::Kind;
  return {
      {robot, "film", "start FILE [VIEW] | stop",
       "Films a view (the scene without a word) from now on, 25 pictures a simulated second, as "
       "MP4.",
       film},
      {robot, "picture", "? | [VIEW] FILE {NUMBER}",
       "Writes a view of the first selected robot (the scene without a word) to a file .png or "
       ".svg. With ? it lists the views.",
       picture, pictureChoices},
      {robot, "plot", "? | VALUE (on | off) | save FILE [SECONDS]",
       "Records a value over time, or no more; saves all that is recorded as a chart (.png, .svg) "
       "of the last seconds, or as numbers (.csv).",
       plot, plotChoices}};
}

}  // namespace gt
