#pragma once
#include "framework/SolutionTable.h"

/// A tiny robot for the framework's own tests: a sensor, a filter, a controller.
namespace gt::testing {

struct Reading {
  Time time;
  double value = 0;
  static constexpr auto fields() {
    return Fields{field<&Reading::time>(), field<&Reading::value>()};
  }
};
struct Estimate {
  double value = 0;
  static constexpr auto fields() { return Fields{field<&Estimate::value>()}; }
};
struct Command {
  double value = 0;
  int cycles = 0;
  static constexpr auto fields() {
    return Fields{field<&Command::value>(), field<&Command::cycles>()};
  }
};

/// What only some platforms send.
struct Secret {
  double value = 0;
  static constexpr auto fields() { return Fields{field<&Secret::value>()}; }
};

struct Filter {
  using Outputs = std::tuple<Estimate>;
};
struct Controller {
  using Outputs = std::tuple<Command>;
};

class SmoothFilter {
 public:
  struct Parameters {
    double gain = 0.5;
    static constexpr auto fields() {
      return Fields{field<&Parameters::gain>("trust in the reading", {0, 1})};
    }
  };
  Parameters parameters;
  void update(const Reading& reading, Previous<Estimate> before, Estimate& estimate) {
    estimate.value = before->value + parameters.gain * (reading.value - before->value);
  }
};

class DirectFilter {
 public:
  void update(const Reading& reading, Estimate& estimate) { estimate.value = reading.value; }
};

/// In no table but that of a test which adds it.
class SecretFilter {
 public:
  void update(const Secret& secret, Estimate& estimate) { estimate.value = secret.value; }
};

inline const DebugKey drawCommand{"Controller/command"};

class NegatingController {
 public:
  void update(const Estimate& estimate, Command& command, Random&, Debug& debug) {
    command.value = -estimate.value;
    ++command.cycles;
    if (auto canvas = debug.onField(drawCommand)) canvas.circle({command.value, 0}, 10);
  }
};

inline SolutionTable table() {
  SolutionTable solutions;
  solutions.add<Filter, SmoothFilter>("Smooth");
  solutions.add<Filter, DirectFilter>("Direct");
  solutions.add<Controller, NegatingController>("Negating");
  return solutions;
}

}  // namespace gt::testing
