#include "colortable/Images.h"

#include <map>
#include <set>

#include "base/File.h"
#include "images/Jpeg.h"
#include "logs/NaoLog.h"
#include "measure/worlds/GameViews.h"
#include "streams/mcap/Mcap.h"

namespace gt {
namespace {

/// The labels of each image.
class Labels {
 public:
  static Result<Labels> read(const std::string& file) {
    Labels labels;
    labels.file_ = file;
    if (file.empty()) return labels;
    const auto regions = readRegions(file);
    if (!regions) return regions.error();
    for (const LabeledRegion& region : *regions)
      labels.byPicture_[region.picture].push_back(region);
    return labels;
  }

  std::span<const LabeledRegion> of(const std::string& picture) {
    used_.insert(picture);
    return byPicture_[picture];
  }

  /// Whether all labels belong to images that there were.
  Result<void> check() const {
    for (const auto& entry : byPicture_)
      if (!used_.contains(entry.first))
        return Error{.file = file_, .field = entry.first, .what = "there is no such image"};
    return {};
  }

 private:
  std::string file_;
  std::map<std::string, std::vector<LabeledRegion>> byPicture_;
  std::set<std::string> used_;
};

Result<void> visitSimulated(const ImageSource& source, const ImageVisitor& visit) {
  const auto scene = loadScene(source.scene);
  if (!scene) return scene.error();
  auto views = GameViews::make(source.root, *scene, source.seed);
  if (!views) return views.error();
  constexpr std::array share{-1.0, -1.0 / 3, 0.0, 1.0 / 3, 1.0};
  for (int i = 0; i < source.moments; ++i) {
    views->shuffle();
    CameraEffects effects = views->scene().camera;
    effects.brightness *= 1 + source.light * share[static_cast<std::size_t>(i) % share.size()];
    for (std::size_t robot = 0; robot < views->world().activeRobots(); ++robot) {
      const GameView& view = views->look(robot, effects);
      const std::string name = std::to_string(i) + "." + std::to_string(robot);
      if (!visit(name, {view.image, view.truth.classes, {}})) return {};
    }
  }
  return {};
}

Result<Image> decode(std::span<const std::uint8_t> bytes, const std::string& name) {
  const auto raw = decodeJpeg(bytes);
  if (!raw) return Error{.file = name, .what = raw.error().what};
  if (raw->components != 3) return Error{.file = name, .what = "is no color image in YCbCr"};
  constexpr int largest = 4096;
  if (raw->width > largest || raw->height > largest)
    return Error{.file = name,
                 .what = "is larger than " + std::to_string(largest) + " pixels a side"};
  Image image;
  image.info.width = raw->width;
  image.info.height = raw->height;
  image.allocate();
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = {raw->data[3 * i], raw->data[3 * i + 1], raw->data[3 * i + 2], 0};
  return image;
}

/// Shows an image to a visitor; false if that was the last one.
using Show = std::function<bool(const std::string&, const Image&)>;

Result<void> showMcap(const std::string& path, const Show& show) {
  auto log = McapReader::open(path);
  if (!log) return log.error();
  int number = 0;
  while (const auto message = log->next()) {
    // Images are named by their numbers, so none may be missing.
    if (!log->damage().empty()) return log->damage().front();
    if (log->channel(message->channel)->topic != "/camera") continue;
    const std::string name = std::to_string(number++);
    CompressedImage packed;
    if (auto done = gt::decode(message->data, packed); !done)
      return Error{.file = path, .field = "/camera " + name, .what = done.error().text()};
    const auto image = decode(packed.data, path);
    if (!image) return Error{.file = path, .field = "/camera " + name, .what = image.error().what};
    if (!show(name, *image)) return {};
  }
  if (!log->damage().empty()) return log->damage().front();
  if (number == 0)
    return Error{.file = path, .field = "/camera", .what = "there are no images in it"};
  return {};
}

Result<void> showNaoLog(const std::string& path, const Show& show) {
  const auto log = readNaoLog(path);
  if (!log) return log.error();
  if (log->pictures.empty()) return Error{.file = path, .what = "there are no images in it"};
  Image image;
  for (const NaoImage& picture : log->pictures) {
    if (auto done = log->decode(picture, image); !done) return done;
    if (!show(std::to_string(picture.number), image)) return {};
  }
  if (!log->damage.empty()) return log->damage.front();
  return {};
}

Result<void> showFiles(const std::vector<std::string>& files, const Show& show) {
  for (const std::string& file : files) {
    const auto bytes = readFile(file);
    if (!bytes) return bytes.error();
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes->data());
    const auto image = decode({data, bytes->size()}, file);
    if (!image) return image.error();
    if (!show(file, *image)) return {};
  }
  return {};
}

}  // namespace

Result<void> forEachImage(const ImageSource& source, const ImageVisitor& visit) {
  if (source.simulated()) return visitSimulated(source, visit);
  auto labels = Labels::read(source.labels);
  if (!labels) return labels.error();
  bool all = true;
  const auto show = [&](const std::string& name, const Image& image) {
    all = visit(name, {image, {}, labels->of(name)});
    return all;
  };
  const auto done = source.log.empty()              ? showFiles(source.files, show)
                    : source.log.ends_with(".mcap") ? showMcap(source.log, show)
                                                    : showNaoLog(source.log, show);
  return done && all ? labels->check() : done;
}

}  // namespace gt
