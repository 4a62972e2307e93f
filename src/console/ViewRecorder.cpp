#include "console/ViewRecorder.h"

#include "console/Console.h"
#include "console/Values.h"
#include "views/FilmWriter.h"

namespace gt {
namespace {

constexpr std::int64_t period = 1000 / FilmWriter::imagesPerSecond;  // ms, also of values
constexpr std::size_t mostSamples = 1'000'000;
constexpr std::size_t mostSeries = 100;

}  // namespace

struct ViewRecorder::Film {
  std::string file;
  std::unique_ptr<FilmWriter> writer;
  std::shared_ptr<const View> view;
  std::vector<double> numbers;
  std::vector<std::string> robots;  ///< Those that were selected when it began.

  /// Paints the view with the film's robots, independent of the present selection.
  Result<Sheet> show(Console& console) const {
    const std::vector<std::string> selected = console.selection();
    console.select(robots);
    auto sheet = view->show(console.viewSubject(), numbers);
    console.select(selected);
    return sheet;
  }
};

ViewRecorder::ViewRecorder() = default;
ViewRecorder::~ViewRecorder() = default;

Result<void> ViewRecorder::record(Console& console, const std::string& path) {
  const auto value = valueAt(console, path);
  if (!value) return value.error();
  if (!value->number) return Error{.field = path, .what = "is no number, so it cannot be plotted"};
  if (series_.size() >= mostSeries)
    return Error{.field = path, .what = "too many values are plotted"};
  series_.try_emplace(path);
  return {};
}

Result<void> ViewRecorder::startFilm(Console& console, const std::string& file,
                                     std::shared_ptr<const View> view,
                                     std::vector<double> numbers) {
  if (film_)
    return Error{.field = "film", .what = film_->file + " is being made; film stop ends it"};
  const auto first = view->show(console.viewSubject(), numbers);
  if (!first) return first.error();
  auto writer = FilmWriter::open(file, first->width(), first->height());
  if (!writer) return writer.error();
  film_.reset(
      new Film{file, std::move(*writer), std::move(view), std::move(numbers), console.selection()});
  return {};
}

Result<std::string> ViewRecorder::stopFilm() {
  if (!film_) return Error{.field = "film", .what = "none is being made"};
  const auto film = std::move(film_);
  const auto done = film->writer->close();
  return done ? Result<std::string>{film->file} : done.error();
}

void ViewRecorder::step(Console& console) {
  const Time now = console.session().time();
  if (now.ms % period != 0) return;
  for (auto& [path, samples] : series_) {
    const auto value = samples.size() < mostSamples ? valueAt(console, path) : Error{};
    if (value && value->number) samples.push_back({now, *value->number});
  }
  if (!film_) return;
  const auto sheet = film_->show(console);
  const auto done = sheet ? film_->writer->add(sheet->pixels()) : Result<void>{sheet.error()};
  if (done) return;
  console.print("film: " + done.error().text());
  static_cast<void>(stopFilm());
}

void ViewRecorder::clear(Console& console) {
  series_.clear();
  if (!film_) return;
  const auto film = stopFilm();
  console.print(film ? "written: " + *film : "film: " + film.error().text());
}

}  // namespace gt
