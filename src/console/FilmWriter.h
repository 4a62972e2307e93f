#pragma once
#include <memory>
#include <string>

#include "console/Console.h"
#include "views/painting/Sheet.h"

namespace gt {

struct View;

/// Writes pictures of one size as a film, 25 a second (MP4 with H.264, or MPEG-4 where that is
/// missing, by FFmpeg's libraries).
class FilmWriter {
 public:
  /// Both sizes become even.
  static Result<std::unique_ptr<FilmWriter>> open(const std::string& file, int width, int height);
  ~FilmWriter();  ///< Closes the film.
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;

  /// A picture; of another size it is cut or left with a border.
  Result<void> add(const RgbPicture& picture);
  Result<void> close();

 private:
  struct State;
  explicit FilmWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Films a view of a console's session from now on, until it is stopped or begins anew.
Result<void> startFilm(Console& console, const std::string& file, const View& view);
Result<void> stopFilm(Console& console);

}  // namespace gt
