#include <algorithm>

#include "representations/perception/ColorTable64.h"
#include "views/Views.h"
#include "views/painting/ColorClassViews.h"

namespace gt {
namespace {

class ImageView : public View {
 public:
  ImageView(std::string name, std::string help, std::vector<std::string> elements)
      : View{std::move(name), std::move(help)}, elements_{std::move(elements)} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double>) const override {
    const auto robot = subject.robot();
    if (!robot) return robot.error();
    const auto image = (*robot)->value<Image>();
    if (!image) return image.error();
    const CameraInfo& info = (*image)->info;
    if ((*image)->pixels.empty() || info.width <= 0 || info.height <= 0)
      return Error{.field = (*robot)->name(), .what = "has no image yet"};
    const RgbImage colors = rgbOf(**image);
    Sheet sheet{info.width * imageViewScale, info.height * imageViewScale, colors::black};
    for (const std::string& element : elements_) {
      if (element == "image") {
        sheet.paint(colors, {0, 0}, imageViewScale);
      } else if (element == "colorClassImage") {
        const auto table = (*robot)->value<ColorTable64>();
        if (!table) return table.error();
        sheet.paint(classesOf(**image, **table), {0, 0}, imageViewScale);
      } else {
        paintDrawings(sheet, **robot, element);
      }
    }
    return sheet;
  }

 private:
  static void paintDrawings(Sheet& sheet, const ObservedRobot& robot, const std::string& element) {
    for (const auto& [key, drawing] : robot.drawings())
      if (drawing.space == DrawingSpace::image && (key == element || element == "drawings"))
        sheet.paint(drawing, {Vector2d::Zero(), imageViewScale, false});
  }

  std::vector<std::string> elements_;
};

}  // namespace

const std::vector<std::string> imageViewElements{"image", "colorClassImage", "drawings"};

std::unique_ptr<View> makeImageView(std::string name, std::string help,
                                    std::vector<std::string> elements) {
  return std::make_unique<ImageView>(std::move(name), std::move(help), std::move(elements));
}

}  // namespace gt
