#include <QMenu>
#include <map>
#include <utility>

#include "colors/ClassColors.h"
#include "workbench/space/SpaceDialog.h"

namespace gt {
namespace {

constexpr double edge = 256;  // mm: the color space's cube, one for each value of a channel
constexpr int cells = 32;     // along each axis
constexpr double cell = edge / cells;
constexpr int columnStep = 4;  // pixels of the image that a column of the height map stands for

enum class ColorSpaceKind { image, table, heightsY, heightsU, heightsV };
constexpr std::pair<ColorSpaceKind, const char*> spaceKinds[] = {
    {ColorSpaceKind::image, "Colors of the image"},
    {ColorSpaceKind::table, "Color table"},
    {ColorSpaceKind::heightsY, "Y over the image"},
    {ColorSpaceKind::heightsU, "U over the image"},
    {ColorSpaceKind::heightsV, "V over the image"}};

/// Where a color lies in the cube: U to the right, V back, Y up.
Vector3d placeOfColor(int y, int u, int v) {
  return {u - edge / 2, v - edge / 2, static_cast<double>(y)};
}

Color rgbOf(const Pixel& pixel) {
  Image one;
  one.info.width = one.info.height = 1;
  one.pixels = {pixel};
  const RgbImage rgb = gt::rgbOf(one);
  return {rgb.pixels[0], rgb.pixels[1], rgb.pixels[2]};
}

void addCube(GlScene& scene) {
  const Color gray{120, 120, 125};
  const auto corner = [](int i) {
    return placeOfColor(i & 4 ? 256 : 0, i & 1 ? 256 : 0, i & 2 ? 256 : 0);
  };
  for (int i = 0; i < 8; ++i)
    for (const int axis : {1, 2, 4})
      if (!(i & axis)) scene.addLine(corner(i), corner(i | axis), 1, gray);
}

/// A box for each cell that pixels of the image fall into.
void addImage(const Image& image, GlScene& scene) {
  std::map<std::array<int, 3>, Pixel> found;
  for (const Pixel& p : image.pixels) found.emplace(std::array{p.y / 8, p.cb / 8, p.cr / 8}, p);
  for (const auto& [place, pixel] : found)
    scene.add(mjGEOM_BOX, Vector3d::Constant(cell / 2),
              placeOfColor(place[0] * 8 + 4, place[1] * 8 + 4, place[2] * 8 + 4), rgbOf(pixel));
}

/// A box for each cell that is not inside its class.
void addTable(const ColorTable64& table, GlScene& scene) {
  const auto at = [&](int y, int u, int v) {
    const auto value = [](int i) { return static_cast<std::uint8_t>(i * 8 + 4); };
    const bool outside = y < 0 || u < 0 || v < 0 || y >= cells || u >= cells || v >= cells;
    return outside ? ColorClass::noColor : table[Pixel{value(y), value(u), value(v)}];
  };
  for (int y = 0; y < cells; ++y)
    for (int u = 0; u < cells; ++u)
      for (int v = 0; v < cells; ++v) {
        const ColorClass own = at(y, u, v);
        if (own == ColorClass::noColor) continue;
        if (at(y - 1, u, v) == own && at(y + 1, u, v) == own && at(y, u - 1, v) == own &&
            at(y, u + 1, v) == own && at(y, u, v - 1) == own && at(y, u, v + 1) == own)
          continue;
        scene.add(mjGEOM_BOX, Vector3d::Constant(cell / 2),
                  placeOfColor(y * 8 + 4, u * 8 + 4, v * 8 + 4), displayColor(own));
      }
}

/// A column for each square of pixels, as high as the channel's value.
void addHeights(const Image& image, ColorSpaceKind kind, GlScene& scene) {
  const double width = edge / image.info.width;
  for (int row = 0; row + columnStep <= image.info.height; row += columnStep)
    for (int column = 0; column + columnStep <= image.info.width; column += columnStep) {
      const Pixel& pixel = image.at(column, row);
      const double height = kind == ColorSpaceKind::heightsY   ? pixel.y
                            : kind == ColorSpaceKind::heightsU ? pixel.cb
                                                               : pixel.cr;
      const double half = columnStep * width / 2;
      scene.add(mjGEOM_BOX, {half, half, (height + 1) / 2},
                {(column - image.info.width / 2.0) * width + half,
                 (image.info.height / 2.0 - row) * width - half, (height + 1) / 2},
                rgbOf(pixel));
    }
}

/// Report J.3.4: the colors of the image in the color space, a channel of it as a height map, or
/// the color table.
class ColorSpace3D : public SpaceDialog {
 public:
  explicit ColorSpace3D(SessionThread& session) : SpaceDialog{session} {
    view().camera() = {.at = {0, 0, 110}, .azimuth = -60, .elevation = 25, .distance = 560};
    view().setLowest(-80);
  }

  QJsonObject settings() const override {
    QJsonObject settings = SpaceDialog::settings();
    settings["kind"] = static_cast<int>(kind_);
    return settings;
  }
  void restore(const QJsonObject& settings) override {
    SpaceDialog::restore(settings);
    const int kind = settings["kind"].toInt(static_cast<int>(kind_));
    if (kind >= 0 && kind <= static_cast<int>(ColorSpaceKind::heightsV))
      kind_ = static_cast<ColorSpaceKind>(kind);
  }

 protected:
  Draw drawing() const override {
    return [kind = kind_](const Canvas& canvas) -> std::string {
      canvas.scene.clear();
      if (!canvas.robot) return "No robot is connected.";
      ObservedRobot& robot = canvas.robot->observed();
      if (kind == ColorSpaceKind::table) {
        const auto table = robot.value<ColorTable64>();
        if (!table) return table.error().text();
        addTable(**table, canvas.scene);
        addCube(canvas.scene);
        return robot.name() + ": color table";
      }
      const auto image = robot.value<Image>();
      if (!image) return image.error().text();
      if (kind == ColorSpaceKind::image) {
        addImage(**image, canvas.scene);
        addCube(canvas.scene);
      } else {
        addHeights(**image, kind, canvas.scene);
      }
      return robot.name();
    };
  }
  void addActions(QMenu& menu, const QPointF&) override {
    for (const auto& [kind, text] : spaceKinds) {
      QAction* action = menu.addAction(text, this, [this, chosen = kind] {
        kind_ = chosen;
        drawAgain();
      });
      action->setCheckable(true);
      action->setChecked(kind == kind_);
    }
  }

 private:
  ColorSpaceKind kind_ = ColorSpaceKind::image;
};

const RegisterDialog<ColorSpace3D> registeredColorSpace3D{
    {.id = "colorSpace3D",
     .title = "Color space 3D",
     .group = "Viewers",
     .help = "The image's colors in the color space, a channel as a height map, or the color table",
     .report = "J.3.4",
     .several = true,
     .make = makeInSpace<ColorSpace3D>}};

}  // namespace
}  // namespace gt
