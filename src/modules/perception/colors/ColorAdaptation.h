#pragma once
#include <array>

#include "base/Enum.h"
#include "modules/perception/scanning/Horizon.h"
#include "representations/infrastructure/Image.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// A color independent of the light: its direction from gray, and its distance from gray relative
/// to its brightness. Light and shade move a color along the line from black, which changes
/// neither.
struct Tone {
  double hue = 0;       ///< rad, the angle of (cb, cr) around gray.
  double strength = 0;  ///< Logarithm of the distance from gray divided by the brightness.
};

/// A color table that is learned while a robot plays (report 6.2.1; Jüngel, Hoffmann, Lötzsch: A
/// Real-Time Auto-Adjusting Vision System for Robotic Soccer, 2003). No color is given; heuristics
/// about the environment replace them. Most pixels below the horizon are green. The brightness of
/// green measures the light. Pixels that are brighter and have no color are white and define gray.
/// The other colors lie around gray in a known order and are adapted to recognized objects.
class ColorAdaptation {
 public:
  ColorAdaptation();

  /// Searches a few hundred pixels of an image for green and white.
  void observe(const Image& image, const Horizon& horizon);
  /// Learns from a pixel of a recognized object that must have this color. Pixels too far from the
  /// color are ignored.
  void learn(ColorClass color, const Pixel& pixel);
  /// Updates a part of the table; eight calls update all of it.
  void refresh();

  /// The color table; all entries are noColor until green is known.
  const ColorTable64& table() const { return table_; }
  bool isGreenKnown() const { return greenKnown_; }
  /// The mean brightness (y) of green and of white.
  double greenY() const { return greenY_; }
  double whiteY() const { return greenY_ * whiteRatio_; }
  const Tone& tone(ColorClass color) const { return tones_[color]; }

 private:
  /// Pixels of one hue below the horizon, collected until green is known.
  struct HueBin {
    double count = 0, strength = 0;
  };
  /// Statistics of the green pixels of an image.
  struct GreenSample {
    int ground = 0, count = 0;
    double y = 0, hue = 0, strength = 0;
  };
  static constexpr std::size_t hueBins = 36, ratioBins = 64;

  Tone toneOf(double y, double cb, double cr) const;
  double distance(ColorClass color, const Tone& tone, double chroma) const;
  void refreshColumn(int cbStep, int crStep);
  void addGround(const Pixel& pixel, GreenSample& green);
  void addBright(const Pixel& pixel);
  void findGreen();
  void followGreen(const GreenSample& green);
  void findWhite();
  void forgetGreen();
  void noteChanges();

  ColorTable64 table_;
  EnumArray<ColorClass, Tone> tones_;  ///< Of all classes that are colors.
  double grayCb_ = 128, grayCr_ = 128;
  bool greenKnown_ = false;
  double greenY_ = 0, whiteRatio_ = 0;
  int withoutGreen_ = 0;  ///< Number of consecutive images of ground without green.
  double groundCount_ = 0;
  std::array<HueBin, hueBins> hues_{};
  std::array<double, ratioBins> ratios_{};  ///< Histogram of brightness relative to green's.

  // The values for which the table was computed, and the part that must be recomputed.
  EnumArray<ColorClass, Tone> builtTones_;
  double builtWhite_ = 0, builtCb_ = 0, builtCr_ = 0;
  int nextPlane_ = 0, planesLeft_ = 0;
};

}  // namespace gt
