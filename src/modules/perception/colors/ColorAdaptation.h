#pragma once
#include <array>

#include "base/Enum.h"
#include "modules/perception/scanning/Horizon.h"
#include "representations/infrastructure/Image.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// A color whatever the light: in which direction it lies from gray, and how far for its
/// brightness. Light and shade move a color along the line from black to it, which changes neither.
struct Tone {
  double hue = 0;       ///< rad, the angle of (cb, cr) around gray.
  double strength = 0;  ///< The logarithm of its distance from gray over its brightness.
};

/// A color table that makes itself while a robot plays (report 6.2.1; Jüngel, Hoffmann, Lötzsch: A
/// Real-Time Auto-Adjusting Vision System for Robotic Soccer, 2003). It is given no color, but
/// heuristics about the environment do: most of what is seen below the horizon is green. Green's
/// brightness tells the light, what is brighter than it and has no color is white and tells gray;
/// the other colors lie around gray in a known order, and move to where recognized objects have
/// them.
class ColorAdaptation {
 public:
  ColorAdaptation();

  /// Looks for green and white in an image: a few hundred pixels of it.
  void observe(const Image& image, const Horizon& horizon);
  /// A pixel of something that was recognized and must have this color; one that is too far away
  /// from it is none of it.
  void learn(ColorClass color, const Pixel& pixel);
  /// Brings a part of the table up to date; all of it within eight calls.
  void refresh();

  /// All noColor until green is known.
  const ColorTable64& table() const { return table_; }
  bool isGreenKnown() const { return greenKnown_; }
  /// The mean brightness (y) of green, and that of white.
  double greenY() const { return greenY_; }
  double whiteY() const { return greenY_ * whiteRatio_; }
  const Tone& tone(ColorClass color) const { return tones_[color]; }

 private:
  /// What was seen below the horizon of each hue, before green is known.
  struct HueBin {
    double count = 0, strength = 0;
  };
  /// What an image showed of green.
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
  EnumArray<ColorClass, Tone> tones_;  ///< Of the colors proper.
  double grayCb_ = 128, grayCr_ = 128;
  bool greenKnown_ = false;
  double greenY_ = 0, whiteRatio_ = 0;
  int withoutGreen_ = 0;  ///< Images of ground in a row that showed none.
  double groundCount_ = 0;
  std::array<HueBin, hueBins> hues_{};
  std::array<double, ratioBins> ratios_{};  ///< How often a brightness over green's was seen.

  // What the table was made for, and what is left to be made anew.
  EnumArray<ColorClass, Tone> builtTones_;
  double builtWhite_ = 0, builtCb_ = 0, builtCr_ = 0;
  int nextPlane_ = 0, planesLeft_ = 0;
};

}  // namespace gt
