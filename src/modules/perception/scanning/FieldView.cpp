#include "modules/perception/scanning/FieldView.h"

namespace gt {
std::optional<Vector2d> onPlane(const CameraImage& picture, const Vector2d& inImage,
                                double height) {
  const Vector3d ray = picture.matrix.ray(inImage.x(), inImage.y());
  const Vector3d& camera = picture.matrix.pose.translation;
  const double above = camera.z() - height;
  if (above * ray.z() >= 0) return std::nullopt;
  const Vector2d way = -above / ray.z() * ray.head<2>();
  if (way.squaredNorm() > farthestOnGround * farthestOnGround) return std::nullopt;
  return Vector2d{camera.head<2>() + way};
}

double expectedLineWidth(const CameraImage& picture, double distance,
                         const FieldDimensions& field) {
  const double height = picture.matrix.pose.translation.z();
  // The difference of the angles down to both of its sides.
  return picture.matrix.info.focalX *
         std::atan2(height * field.lineWidth,
                    distance * (distance + field.lineWidth) + height * height);
}

double expectedBorderHeight(const CameraImage& picture, double distance,
                            const FieldDimensions& field) {
  const double height = picture.matrix.pose.translation.z();
  return picture.matrix.info.focalX *
         std::atan2(field.wallHeight * distance,
                    distance * distance + height * (height - field.wallHeight));
}

}  // namespace gt
