#include "benchmarks/streams/Streams.h"

#include <benchmark/benchmark.h>

#include <ctime>
#include <stdexcept>

#include "base/Random.h"
#include "benchmarks/streams/Protobuf.h"
#include "streams/Binary.h"
#include "streams/Type.h"

namespace gt {
namespace {

constexpr int rounds = 9;
constexpr double roundTime = 20e6;  // ns

double processorTime() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e9 + static_cast<double>(t.tv_nsec);
}

/// The nanoseconds that something takes, measured over a while.
template <typename Work>
double timeOf(Work&& work) {
  for (int n = 16;; n *= 2) {
    const double begin = processorTime();
    for (int i = 0; i < n; ++i) work();
    const double time = processorTime() - begin;
    if (time >= roundTime) return time / n;
  }
}

/// Measures ours and the other's in turns, and how many times ours is as fast.
template <typename Ours, typename Other>
void compare(Figures& figures, const std::string& name, Aim aim, Ours&& ours, Other&& other) {
  std::vector<double> oursTimes, otherTimes, ratios;
  for (int round = 0; round < rounds; ++round) {
    oursTimes.push_back(timeOf(ours));
    otherTimes.push_back(timeOf(other));
    ratios.push_back(otherTimes.back() / oursTimes.back());
  }
  figures.add(name + ".binary", "ns", oursTimes);
  figures.add(name + ".protobuf", "ns", otherTimes);
  figures.add(name + ".faster", "times", ratios, aim);
}

void demand(bool condition, const char* what) {
  if (!condition) throw std::runtime_error(what);
}

/// Streams one value in both formats. It must survive both, or the comparison is void.
template <typename T, typename Rival>
void measureSpeed(Figures& figures, const std::string& name, const T& value, Aim aim) {
  Rival message, received;
  T read = value, readByRival = value;
  std::vector<std::byte> bytes(encodedSize(value));
  protobuf::set(value, message);
  std::string rivalBytes(message.ByteSizeLong(), '\0');

  const auto encodeOurs = [&] {
    bytes.resize(encodedSize(value));
    encodeTo(value, bytes.data());
    benchmark::DoNotOptimize(bytes.data());
    benchmark::ClobberMemory();
  };
  const auto encodeRival = [&] {
    protobuf::set(value, message);
    rivalBytes.resize(message.ByteSizeLong());
    message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(rivalBytes.data()));
    benchmark::DoNotOptimize(rivalBytes.data());
    benchmark::ClobberMemory();
  };
  const auto decodeOurs = [&] {
    demand(static_cast<bool>(decode(bytes, read)), "the binary stream is not read");
    benchmark::DoNotOptimize(&read);
    benchmark::ClobberMemory();
  };
  const auto decodeRival = [&] {
    demand(received.ParseFromString(rivalBytes), "the message is not read");
    protobuf::get(received, readByRival);
    benchmark::DoNotOptimize(&readByRival);
    benchmark::ClobberMemory();
  };
  compare(figures, name + ".encode", aim, encodeOurs, encodeRival);
  compare(figures, name + ".decode", aim, decodeOurs, decodeRival);

  std::vector<std::byte> again, byRival;
  encode(read, again);
  encode(readByRival, byRival);
  demand(again == bytes && byRival == bytes, "a value does not survive being streamed");
}

/// Sets a value to one as a robot might have it: numbers are measured ones, all lists are full.
void fill(Value value, Random& random) {
  const Type& type = *value.type;
  if (type.kind == Kind::record)
    for (const Part& part : type.parts) fill(value.part(part), random);
  else if (type.kind == Kind::array || type.kind == Kind::list)
    for (std::size_t i = 0; i < value.size(); ++i) fill(value.element(i), random);
  else if (type.kind == Kind::number && type.number == Number::float64)
    *static_cast<double*>(value.data) = random.uniform(-2000, 2000);
  else
    setOrdinal(value, static_cast<std::int64_t>(
                          random.index(type.kind == Kind::boolean       ? 2
                                       : type.kind == Kind::enumeration ? type.names.size()
                                       : type.number == Number::int64   ? 1'200'000
                                                                        : 256)));
}

/// The sizes of many values, as that of a message depends on what is in it, and the speed for one.
template <typename T, typename Rival>
void measure(Figures& figures, const std::string& type, Aim aim, T value = {}) {
  Random random{1};
  std::vector<double> sizes, rivalSizes, ratios;
  for (int i = 0; i < 200; ++i) {
    fill(valueOf(value), random);
    Rival message;
    protobuf::set(value, message);
    sizes.push_back(static_cast<double>(encodedSize(value)));
    rivalSizes.push_back(static_cast<double>(message.ByteSizeLong()));
    ratios.push_back(sizes.back() / rivalSizes.back());
  }
  const std::string name = "speed.stream." + type;
  figures.add(name + ".size.binary", "bytes", sizes);
  figures.add(name + ".size.protobuf", "bytes", rivalSizes);
  figures.add(name + ".size.ratio", "times", ratios, Aim::atMost(1.1));
  measureSpeed<T, Rival>(figures, name, value, aim);
}

}  // namespace

void measureStreams(Figures& figures) {
  Image image;
  image.allocate();
  measure<Image, rival::Image>(figures, "Image", Aim::atLeast(2), image);
  measure<LandmarksPercept, rival::LandmarksPercept>(figures, "LandmarksPercept", Aim::atLeast(4));
  measure<BallPercept, rival::BallPercept>(figures, "BallPercept", Aim::atLeast(4));
  measure<PsdPercept, rival::PsdPercept>(figures, "PsdPercept", Aim::atLeast(4));
  ObstaclesPercept obstacles;
  obstacles.lines.resize(20);
  measure<ObstaclesPercept, rival::ObstaclesPercept>(figures, "ObstaclesPercept", Aim::atLeast(4),
                                                     obstacles);
  measure<JointData, rival::JointData>(figures, "JointData", {});
}

}  // namespace gt
