#include <algorithm>
#include <iterator>

#include "base/File.h"
#include "base/Suggestion.h"
#include "console/Commands.h"
#include "console/Values.h"

namespace gt {
namespace {

bool isImage(const std::string& word) {
  return word.ends_with(".png") || word.ends_with(".svg");
}

std::vector<std::string> viewNames(Console& console, const Words&) {
  std::vector<std::string> names;
  for (const auto& view : console.views()) names.push_back(view->name());
  return names;
}

Result<std::shared_ptr<const View>> viewOf(Console& console, const std::string& name) {
  for (const auto& view : console.views())
    if (view->name() == name) return view;
  return Error{
      .field = name,
      .what = "there is no such view; try picture ?" + suggestion(name, viewNames(console, {}))};
}

/// The numbers at the end of a line.
Result<std::vector<double>> numbersOf(const Words& words, std::size_t first) {
  std::vector<double> numbers;
  for (std::size_t i = first; i < words.size(); ++i) {
    const auto number = numberOf(words[i], -1e5, 1e5);
    if (!number) return number.error();
    numbers.push_back(*number);
  }
  return numbers;
}

/// image [VIEW] FILE {NUMBER}: the scene without a view's name.
Result<void> picture(Console& console, const Words& words) {
  if (words[1] == "?") {
    for (const auto& view : console.views()) console.print(view->name() + "  " + view->help());
    return {};
  }
  const bool named = words.size() > 2 && !isImage(words[1]);
  const std::size_t fileWord = named ? 2 : 1;
  if (words.size() <= fileWord || (!named && viewOf(console, words[1])))
    return wrongArguments(words);
  const auto view = viewOf(console, named ? words[1] : "scene");
  if (!view) return view.error();
  const auto numbers = numbersOf(words, fileWord + 1);
  if (!numbers) return numbers.error();
  const auto sheet = (*view)->show(console.viewSubject(), *numbers);
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
  for (const auto& [name, samples] : console.recorder().series()) {
    text += "," + name;
    for (const auto& [time, value] : samples) rows[time.ms][name] = value;
  }
  text += "\n";
  for (const auto& [time, values] : rows) {
    text += std::to_string(time);
    for (const auto& [name, samples] : console.recorder().series()) {
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
    const auto view = viewOf(console, "plot");
    if (!view) return view.error();
    const auto sheet = (*view)->show(console.viewSubject(), *seconds);
    if (!sheet) return sheet.error();
    if (auto done = sheet->write(file); !done) return done;
  }
  printWritten(console, file);
  return {};
}

Result<void> plot(Console& console, const Words& words) {
  if (words[1] == "?") {
    for (const auto& [name, samples] : console.recorder().series())
      console.print(name + " " + std::to_string(samples.size()) + " values");
    return {};
  }
  if (words[1] == "save") return savePlots(console, words);
  if (words[2] == "on") return console.recorder().record(console, words[1]);
  if (console.recorder().forget(words[1])) return {};
  return Error{.field = words[1], .what = "is not recorded; try plot ?"};
}

Result<void> film(Console& console, const Words& words) {
  if (words[1] == "stop") {
    const auto file = console.recorder().stopFilm();
    if (!file) return file.error();
    printWritten(console, *file);
    return {};
  }
  const auto view = viewOf(console, words.size() > 3 ? words[3] : "scene");
  if (!view) return view.error();
  const auto numbers = numbersOf(words, std::min<std::size_t>(words.size(), 4));
  if (!numbers) return numbers.error();
  return console.recorder().startFilm(console, withDefaults(words[2], "out", ".mp4"), *view,
                                      *numbers);
}

/// view NAME image|field ELEMENT…: defines a view by the list of its elements (report I.3.3).
Result<void> defineView(Console& console, const std::string& name, const Words& words) {
  const bool image = words[2] == "image";
  const auto& parts = image ? imageViewElements : fieldViewElements;
  std::vector<std::string> elements;
  for (std::size_t i = 3; i < words.size(); ++i) {
    const auto keys = drawingKeys(words[i]);
    if (std::ranges::find(parts, words[i]) != parts.end())
      elements.push_back(words[i]);
    else if (!keys.empty())
      elements.insert(elements.end(), keys.begin(), keys.end());
    else
      return Error{.field = words[i],
                   .what = "there is no such drawing" + suggestion(words[i], parts)};
  }
  const std::string help = "defined: " + words.rest;
  console.define(image ? makeImageView(name, help, std::move(elements))
                       : makeFieldView(name, help, std::move(elements)));
  return {};
}

Result<void> view(Console& console, const Words& words) {
  if (words[1] == "?") {
    for (const auto& known : console.views()) console.print(known->name() + "  " + known->help());
    return {};
  }
  const std::string& name = words[1];
  if (words[2] == "off") {
    if (console.forgetView(name)) return {};
    return Error{.field = name, .what = "no view was defined by this name"};
  }
  if (std::ranges::any_of(builtInViews(), [&](const auto& known) { return known->name() == name; }))
    return Error{.field = name, .what = "is a view already"};
  return defineView(console, name, words);
}

std::vector<std::string> elementNames(Console& console, const Words& before) {
  if (before.size() < 3) return {};
  auto names = before[2] == "image" ? imageViewElements : fieldViewElements;
  if (const auto robot = console.firstRobot())
    std::ranges::copy((*robot)->observed().debugKeys(), std::back_inserter(names));
  return names;
}

}  // namespace

std::vector<Command> viewCommands() {
  using enum Command::Kind;
  return {
      {robot, "film", "start FILE [VIEW {NUMBER}] | stop",
       "Films a view (the scene if none is named) from now on, 25 images a simulated second, as "
       "MP4 (.mp4).",
       film, viewNames},
      {robot, "picture", "? | [VIEW] FILE {NUMBER}",
       "Writes a view of the first selected robot (the scene without a word) to a file .png or "
       ".svg. With ? it lists the views.",
       picture, viewNames},
      {robot, "plot", "? | VALUE (on | off) | save FILE [SECONDS]",
       "Records a value over time, or no more; saves all that is recorded as a chart (.png, .svg) "
       "of the last seconds, or as numbers (.csv).",
       plot, valueChoices},
      {global, "view", "? | NAME off | NAME (image | field) ELEMENT {ELEMENT}",
       "Defines a view by what is painted on one another: image or colorClassImage, and image "
       "drawings; or fieldPolygons, fieldLines, flags, truth, and drawings on the field. Drawings "
       "are named by their debug keys or as in the report; drawings stands for all that come.",
       view, elementNames}};
}

}  // namespace gt
