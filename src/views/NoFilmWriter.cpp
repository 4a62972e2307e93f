// A build without FFmpeg's libraries writes no films.
#include "views/FilmWriter.h"

namespace gt {

struct FilmWriter::State {};

FilmWriter::FilmWriter(std::unique_ptr<State> state) : state_{std::move(state)} {}
FilmWriter::~FilmWriter() = default;

Result<std::unique_ptr<FilmWriter>> FilmWriter::open(const std::string& file, int, int) {
  return Error{.file = file,
               .what =
                   "cannot be written: films need FFmpeg's libraries, which this build has not; "
                   "install libavformat-dev, libavcodec-dev, libswscale-dev, and build anew"};
}

Result<void> FilmWriter::add(const RgbImage&) {
  return {};
}

Result<void> FilmWriter::close() {
  return {};
}

}  // namespace gt
