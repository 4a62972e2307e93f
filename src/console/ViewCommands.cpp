#include <algorithm>

#include "console/Commands.h"
#include "console/Values.h"
#include "console/Views.h"
#include "streams/File.h"

namespace gt {
namespace {

bool isPicture(const std::string& word) {
  return word.ends_with(".png") || word.ends_with(".svg");
}

std::vector<std::string> viewNames(Console&, const Words&) {
  std::vector<std::string> names;
  for (const View& view : views()) names.emplace_back(view.name);
  return names;
}

Result<const View*> viewOf(Console& console, const std::string& name) {
  const auto found =
      std::ranges::find_if(views(), [&](const View& known) { return known.name == name; });
  if (found != views().end()) return &*found;
  return Error{"", 0, name,
               "there is no such view; try picture ?" + suggestion(name, viewNames(console, {}))};
}

/// The numbers that end a line.
Result<std::vector<double>> numbersOf(const Words& words, std::size_t first) {
  std::vector<double> numbers;
  for (std::size_t i = first; i < words.size(); ++i) {
    const auto number = numberOf(words[i], -1e5, 1e5);
    if (!number) return number.error();
    numbers.push_back(*number);
  }
  return numbers;
}

/// picture [VIEW] FILE {NUMBER}: the scene without a view's name.
Result<void> picture(Console& console, const Words& words) {
  if (words.size() == 2 && words[1] == "?") {
    for (const View& view : views())
      console.print(std::string{view.name} + "  " + std::string{view.help});
    return {};
  }
  const bool named = words.size() > 2 && !isPicture(words[1]);
  const std::size_t fileWord = named ? 2 : 1;
  if (words.size() <= fileWord || (!named && viewOf(console, words[1])))
    return wrongArguments(words);
  const auto view = viewOf(console, named ? words[1] : "scene");
  if (!view) return view.error();
  const auto numbers = numbersOf(words, fileWord + 1);
  if (!numbers) return numbers.error();
  const auto sheet = (*view)->show(console, *numbers);
  if (!sheet) return sheet.error();
  const std::string file = withDefaults(words[fileWord], "out", ".png");
  if (auto done = sheet->write(file); !done) return done;
  printWritten(console, file);
  return {};
}

/// The recorded values as CSV, a line for each time.
Result<void> writeValues(Console& console, const std::string& file) {
  std::map<std::int64_t, std::map<std::string, double>> rows;
  std::string text = "time";
  for (const auto& [name, samples] : console.recording().series()) {
    text += "," + name;
    for (const auto& [time, value] : samples) rows[time.ms][name] = value;
  }
  text += "\n";
  for (const auto& [time, values] : rows) {
    text += std::to_string(time);
    for (const auto& [name, samples] : console.recording().series()) {
      const auto value = values.find(name);
      text += value == values.end() ? "," : "," + std::to_string(value->second);
    }
    text += "\n";
  }
  return writeFile(file, text);
}

Result<void> savePlots(Console& console, const Words& words) {
  const std::string file = withDefaults(words[2], "out", ".png");
  if (file.ends_with(".csv")) {
    if (auto done = writeValues(console, file); !done) return done;
  } else {
    const auto seconds = numbersOf(words, 3);
    if (!seconds) return seconds.error();
    const auto sheet = plotView(console, *seconds);
    if (!sheet) return sheet.error();
    if (auto done = sheet->write(file); !done) return done;
  }
  printWritten(console, file);
  return {};
}

Result<void> plot(Console& console, const Words& words) {
  if (words.size() == 2 && words[1] == "?") {
    for (const auto& [name, samples] : console.recording().series())
      console.print(name + " " + std::to_string(samples.size()) + " values");
    return {};
  }
  if (words.size() > 2 && words.size() < 5 && words[1] == "save") return savePlots(console, words);
  if (words.size() != 3) return wrongArguments(words);
  const auto on = switchOf(words, 2);
  if (!on) return on.error();
  if (*on) return console.recording().record(console, words[1]);
  if (console.recording().forget(words[1])) return {};
  return Error{"", 0, words[1], "is not recorded; try plot ?"};
}

Result<void> film(Console& console, const Words& words) {
  if (words.size() == 2 && words[1] == "stop") {
    const auto file = console.recording().stopFilm();
    if (!file) return file.error();
    printWritten(console, *file);
    return {};
  }
  if (words.size() < 3 || words[1] != "start") return wrongArguments(words);
  const auto view = viewOf(console, words.size() > 3 ? words[3] : "scene");
  if (!view) return view.error();
  const auto numbers = numbersOf(words, std::min<std::size_t>(words.size(), 4));
  if (!numbers) return numbers.error();
  return console.recording().startFilm(console, withDefaults(words[2], "out", ".mp4"), **view,
                                       *numbers);
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
      {robot, "film", "start FILE [VIEW {NUMBER}] | stop",
       "Films a view (the scene if none is named) from now on, 25 pictures a simulated second, as "
       "MP4 (.mp4).",
       film, viewNames},
      {robot, "picture", "? | [VIEW] FILE {NUMBER}",
       "Writes a view of the first selected robot (the scene without a word) to a file .png or "
       ".svg. With ? it lists the views.",
       picture, viewNames},
      {robot, "plot", "? | VALUE (on | off) | save FILE [SECONDS]",
       "Records a value over time, or no more; saves all that is recorded as a chart (.png, .svg) "
       "of the last seconds, or as numbers (.csv).",
       plot, valueChoices}};
}

}  // namespace gt
