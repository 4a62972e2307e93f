#include "modules/perception/colors/ColorAdaptation.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

// Prior knowledge of the colors: their order around gray, and how strong paints of these colors
// are.
struct KnownTone {
  ColorClass color;
  double hue, strength;  // Degrees; chroma over brightness.
};
constexpr std::array knownTones{
    KnownTone{ColorClass::orange, 139, 0.75},  KnownTone{ColorClass::yellow, 171, 0.57},
    KnownTone{ColorClass::skyblue, -57, 0.85}, KnownTone{ColorClass::pink, 80, 0.45},
    KnownTone{ColorClass::red, 109, 1.2},      KnownTone{ColorClass::blue, -9, 1.6},
    KnownTone{ColorClass::green, -118, 0.8}};

constexpr double hueSpread = fromDegrees(15), strengthSpread = 0.4;  // Of a color.
constexpr double noise = 3;           // Of a pixel's cb and cr, with the table's steps.
constexpr double minChroma = 7;       // Below it nothing has a color.
constexpr double minStrength = 0.13;  // Likewise, of chroma over brightness.
constexpr double darkest = 4;         // Brightness below which strengths mean nothing.
constexpr double farthest = 6.5;      // Distance up to which a color belongs to a class.
constexpr double farthestToLearn = 4;
constexpr double mostHueDrift = fromDegrees(30), mostStrengthDrift = 0.7;

constexpr int sampleStep = 6;       // Pixels between those that are looked at.
constexpr double belowHorizon = 8;  // Pixels: what is below is ground, mostly.
constexpr int minGreen = 20;        // Of an image's pixels, to trust them.
constexpr int maxWithout = 75;      // Images of ground without green, after which all was wrong.
constexpr double maxRatio = 8;      // Of brightnesses over green's.

double squared(double x) {
  return x * x;
}

KnownTone knownTone(ColorClass color) {
  return *std::find_if(knownTones.begin(), knownTones.end(),
                       [&](const KnownTone& known) { return known.color == color; });
}

}  // namespace

ColorAdaptation::ColorAdaptation() {
  for (const KnownTone& known : knownTones)
    tones_[known.color] = {fromDegrees(known.hue), std::log(known.strength)};
}

Tone ColorAdaptation::toneOf(double y, double cb, double cr) const {
  const double u = cb - grayCb_, v = cr - grayCr_;
  return {std::atan2(v, u), std::log(std::max(std::hypot(u, v), 0.5) / std::max(y, darkest))};
}

// The distance is in units of the spread. Noise changes the hue of weak colors more.
double ColorAdaptation::distance(ColorClass color, const Tone& tone, double chroma) const {
  const Tone& own = tones_[color];
  const double blurred = squared(noise / chroma);
  return squared(normalize(tone.hue - own.hue)) / (squared(hueSpread) + blurred) +
         squared(tone.strength - own.strength) / (squared(strengthSpread) + blurred);
}

// Updates all brightnesses of one cb and cr, which have the same hue.
void ColorAdaptation::refreshColumn(int cbStep, int crStep) {
  constexpr double whiteShare = 0.56, grayShare = 0.2;
  const auto middle = [](int step) { return 4 * step + 1.5; };
  const double cb = middle(cbStep), cr = middle(crStep);
  const double chroma = std::hypot(cb - grayCb_, cr - grayCr_);
  const double hue = std::atan2(cr - grayCr_, cb - grayCb_);
  std::array<ColorClass, knownTones.size()> near{};
  std::size_t nearCount = 0;
  for (const KnownTone& known : knownTones)
    if (distance(known.color, {hue, tones_[known.color].strength}, chroma) < farthest)
      near[nearCount++] = known.color;
  for (int step = 0; step < 64; ++step) {
    const double y = middle(step);
    ColorClass best = ColorClass::noColor;
    if (chroma < minChroma || chroma < minStrength * y) {
      best = y > whiteShare * whiteY()  ? ColorClass::white
             : y > grayShare * whiteY() ? ColorClass::gray
                                        : ColorClass::black;
    } else if (nearCount > 0) {
      const Tone tone{hue, std::log(chroma / std::max(y, darkest))};
      double least = farthest;
      for (std::size_t i = 0; i < nearCount; ++i) {
        const double d = distance(near[i], tone, chroma);
        if (d >= least) continue;
        least = d;
        best = near[i];
      }
    }
    table_.classes[static_cast<std::size_t>(step << 12 | cbStep << 6 | crStep)] = best;
  }
}

void ColorAdaptation::observe(const Image& image, const Horizon& horizon) {
  GreenSample green;
  for (int y = sampleStep / 2; y < image.info.height; y += sampleStep)
    for (int x = sampleStep / 2; x < image.info.width; x += sampleStep) {
      const Pixel& pixel = image.at(x, y);
      if (horizon.fromImage({x + 0.5, y + 0.5}).y() > belowHorizon) addGround(pixel, green);
    }
  if (!greenKnown_) return findGreen();
  followGreen(green);
  if (!greenKnown_ || green.count < minGreen) return;
  for (int y = sampleStep / 2; y < image.info.height; y += sampleStep)
    for (int x = sampleStep / 2; x < image.info.width; x += sampleStep) addBright(image.at(x, y));
  findWhite();
  noteChanges();
}

void ColorAdaptation::addGround(const Pixel& pixel, GreenSample& green) {
  const double chroma = std::hypot(pixel.cb - grayCb_, pixel.cr - grayCr_);
  const Tone tone = toneOf(pixel.y, pixel.cb, pixel.cr);
  ++green.ground;
  if (chroma < minChroma || chroma < minStrength * pixel.y) {
    groundCount_ += greenKnown_ ? 0 : 1;
  } else if (!greenKnown_) {
    ++groundCount_;
    const auto bin = static_cast<std::size_t>((tone.hue + pi) / (2 * pi) * hueBins) % hueBins;
    hues_[bin].count += 1;
    hues_[bin].strength += tone.strength;
  } else if (distance(ColorClass::green, tone, chroma) < farthest) {
    ++green.count;
    green.y += pixel.y;
    green.hue += normalize(tone.hue - tones_[ColorClass::green].hue);
    green.strength += tone.strength;
  }
}

// Green is the hue with the largest share of the ground, if it lies on green's side of gray.
void ColorAdaptation::findGreen() {
  constexpr double enough = 2000, share = 0.3, greensSide = fromDegrees(50), memory = 0.98;
  const double expected = fromDegrees(knownTone(ColorClass::green).hue);
  std::size_t best = hueBins;
  double most = 0;
  const auto at = [&](std::size_t i, std::size_t by) { return hues_[(i + by) % hueBins]; };
  for (std::size_t i = 0; i < hueBins; ++i) {
    const double count = at(i, hueBins - 1).count + at(i, 0).count + at(i, 1).count;
    const double hue = (static_cast<double>(i) + 0.5) * 2 * pi / hueBins - pi;
    if (count <= most || std::abs(normalize(hue - expected)) > greensSide) continue;
    most = count;
    best = i;
  }
  if (groundCount_ >= enough && most > share * groundCount_) {
    double hue = 0, strength = 0;
    for (const std::size_t by : {hueBins - 1, hueBins, hueBins + 1}) {
      const HueBin bin = at(best, by);
      hue += bin.count * (static_cast<double>(by) - hueBins);
      strength += bin.strength;
    }
    tones_[ColorClass::green] = {
        normalize((static_cast<double>(best) + 0.5 + hue / most) * 2 * pi / hueBins - pi),
        strength / most};
    greenKnown_ = true;
    greenY_ = 0;
  }
  groundCount_ *= memory;
  for (HueBin& bin : hues_) bin = {bin.count * memory, bin.strength * memory};
}

// Brightness follows the light at once, the tone of the carpet changes slowly.
void ColorAdaptation::followGreen(const GreenSample& green) {
  constexpr double lightRate = 0.25, toneRate = 0.05, leastShare = 0.05;
  if (green.ground >= 4 * minGreen)
    withoutGreen_ = green.count < leastShare * green.ground ? withoutGreen_ + 1 : 0;
  if (withoutGreen_ > maxWithout) return forgetGreen();
  if (green.count < minGreen) return;
  const double n = green.count, y = green.y / n;
  greenY_ = greenY_ > 0 ? greenY_ + lightRate * (y - greenY_) : y;
  Tone& tone = tones_[ColorClass::green];
  tone.hue = normalize(tone.hue + toneRate * green.hue / n);
  tone.strength += toneRate * (green.strength / n - tone.strength);
}

void ColorAdaptation::forgetGreen() {
  *this = {};
}

void ColorAdaptation::addBright(const Pixel& pixel) {
  constexpr double brighter = 1.35, grayStrength = 0.16, grayRate = 0.002, nearWhite = 0.75;
  const double ratio = pixel.y / greenY_;
  if (ratio < brighter ||
      std::hypot(pixel.cb - grayCb_, pixel.cr - grayCr_) > minChroma + grayStrength * pixel.y)
    return;
  const double bin = std::min(ratio / maxRatio, 1.0) * (ratioBins - 1);
  ++ratios_[static_cast<std::size_t>(bin)];
  if (ratio < nearWhite * whiteRatio_) return;
  grayCb_ += grayRate * (pixel.cb - grayCb_);
  grayCr_ += grayRate * (pixel.cr - grayCr_);
}

// Lines, walls and feet of flags are brighter than most other objects without color.
void ColorAdaptation::findWhite() {
  constexpr double share = 0.8, memory = 0.99;
  double sum = 0, below = 0;
  for (const double count : ratios_) sum += count;
  std::size_t bin = 0;
  while (bin + 1 < ratioBins && below + ratios_[bin] < share * sum) below += ratios_[bin++];
  if (sum > 0) whiteRatio_ = (static_cast<double>(bin) + 0.5) * maxRatio / (ratioBins - 1);
  for (double& count : ratios_) count *= memory;
}

void ColorAdaptation::learn(ColorClass color, const Pixel& pixel) {
  constexpr double rate = 0.01, brightest = 250;
  const double chroma = std::hypot(pixel.cb - grayCb_, pixel.cr - grayCr_);
  const Tone seen = toneOf(pixel.y, pixel.cb, pixel.cr);
  if (chroma < minChroma || pixel.y > brightest || distance(color, seen, chroma) > farthestToLearn)
    return;
  const double hue = fromDegrees(knownTone(color).hue);
  const double strength = std::log(knownTone(color).strength);
  Tone& own = tones_[color];
  own.hue += rate * normalize(seen.hue - own.hue);
  own.hue = hue + std::clamp(normalize(own.hue - hue), -mostHueDrift, mostHueDrift);
  own.strength = std::clamp(own.strength + rate * (seen.strength - own.strength),
                            strength - mostStrengthDrift, strength + mostStrengthDrift);
}

void ColorAdaptation::noteChanges() {
  constexpr double hueChange = fromDegrees(1.5), strengthChange = 0.05, lightChange = 0.04;
  bool changed = std::abs(whiteY() - builtWhite_) > lightChange * builtWhite_ ||
                 std::abs(grayCb_ - builtCb_) > 1 || std::abs(grayCr_ - builtCr_) > 1;
  for (const KnownTone& known : knownTones) {
    const Tone &now = tones_[known.color], &then = builtTones_[known.color];
    changed = changed || std::abs(normalize(now.hue - then.hue)) > hueChange ||
              std::abs(now.strength - then.strength) > strengthChange;
  }
  if (!changed) return;
  builtWhite_ = whiteY();
  builtTones_ = tones_;
  builtCb_ = grayCb_;
  builtCr_ = grayCr_;
  planesLeft_ = 64;
}

void ColorAdaptation::refresh() {
  constexpr int planesAtOnce = 8;
  for (int i = 0; i < planesAtOnce && planesLeft_ > 0; ++i, --planesLeft_) {
    for (int cr = 0; cr < 64; ++cr) refreshColumn(nextPlane_, cr);
    nextPlane_ = (nextPlane_ + 1) % 64;
  }
}

}  // namespace gt
