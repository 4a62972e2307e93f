#pragma once
#include <memory>
#include <string>

#include "base/Result.h"
#include "views/painting/Sheet.h"

namespace gt {

/// Writes images of one size as a film (MP4 with H.264, or MPEG-4 where that is
/// missing, by FFmpeg's libraries): whole, or not at all.
class FilmWriter {
 public:
  static constexpr int imagesPerSecond = 25;

  /// Opens a film. Width and height (pixels) are made even.
  static Result<std::unique_ptr<FilmWriter>> open(const std::string& file, int width, int height);
  ~FilmWriter();  ///< Closes the film.
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;

  /// Adds an image; one of another size is cropped, or gets a border.
  Result<void> add(const RgbImage& picture);
  Result<void> close();

 private:
  struct State;
  explicit FilmWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace gt
