#pragma once
#include "streams/Reflection.h"

namespace gt {

/// Noise of the sensors and motions of all robots. Element `noise`.
struct NoiseParameters {
  double joints = 0.2;
  double acceleration = 200;
  double psd = 10;
  double slip = 0.06;
  double motion = 1;
  double psdReflections = 0;

  static constexpr auto fields() {
    return Fields{
        field<&NoiseParameters::joints>(Unit::deg, "standard deviation of a measured angle",
                                        {0, 90}),
        field<&NoiseParameters::acceleration>(Unit::mmPerS2, "standard deviation", {0, 1e5}),
        field<&NoiseParameters::psd>(Unit::mm, "standard deviation at 900 mm, less when nearer",
                                     {0, 1000}),
        field<&NoiseParameters::slip>(
            "a robot's steps are that share longer or shorter at most, each direction its own",
            {0, 0.9}),
        field<&NoiseParameters::motion>(
            "noise of steps, kept for 0.25 s; 1: 20 mm and 1 degree over 1 m, 5 degrees over a "
            "turn",
            {0, 100}),
        field<&NoiseParameters::psdReflections>(
            "share of the distance sensor's readings that are random, because of reflections",
            {0, 1})};
  }
};

}  // namespace gt
