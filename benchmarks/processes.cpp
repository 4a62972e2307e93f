// What it costs to pass an image from one process to another: by senders and receivers, and by the
// bare means below them.
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <zmq.hpp>

#include "Parts.h"
#include "framework/Process.h"
#include "network/Wire.h"
#include "representations/infrastructure/Image.h"

namespace gt {
namespace {

/// A process that sends an image in each cycle.
class Camera : public Process {
 public:
  Camera() : Process{"Camera"} { picture.allocate(); }
  Sender<Image> picture{*this, true};

 protected:
  int main() override {
    ++picture.time.ms;
    picture.send();
    return 0;
  }
};

/// A process that waits for images.
class Viewer : public Process {
 public:
  Viewer() : Process{"Viewer"} {}
  Receiver<Image> picture{*this, true};

 protected:
  int main() override {
    benchmark::DoNotOptimize(picture.pixels.data());
    return 0;
  }
};

/// Both in one program: a cycle of each.
void processCycle(benchmark::State& state) {
  Camera camera;
  Viewer viewer;
  camera.picture.connect(viewer.picture);
  for ([[maybe_unused]] auto _ : state)
    if (!camera.step(Time{}) || !viewer.step(Time{})) throw std::logic_error("no package");
}

/// The same two processes joined by wires, a cycle of each; each image is asked for.
void wireCycle(benchmark::State& state, Network& cameraNetwork, Network& viewerNetwork,
               const std::string& endpoint) {
  Camera camera;
  Viewer viewer;
  Wire cameraWire{cameraNetwork, "Camera"}, viewerWire{viewerNetwork, "Viewer"};
  if (!cameraWire.listen(endpoint) || !viewerWire.connect("Camera", endpoint))
    throw std::runtime_error(endpoint);
  cameraWire.provide(camera.picture);
  viewerWire.receive("Camera", viewer.picture);
  const auto exchange = [&] {
    while (true) {
      cameraWire.takeIn();
      camera.step(Time{});
      viewerWire.takeIn();
      const bool came = viewer.step(Time{});
      viewerWire.askForMore();
      if (came) return;
    }
  };
  exchange();  // they have found each other
  for ([[maybe_unused]] auto _ : state) exchange();
}

void wireInProgram(benchmark::State& state) {
  Network network;
  wireCycle(state, network, network, "inproc://pictures");
}

void wireBetweenPrograms(benchmark::State& state) {
  aim(state, 6);
  const auto file =
      std::filesystem::temp_directory_path() / ("gt2003-bench-" + std::to_string(getpid()));
  Network camera, viewer;
  wireCycle(state, camera, viewer, "ipc://" + file.string());
  std::filesystem::remove(file);
}

/// What ZeroMQ alone needs to do the same: a request, and the image's bytes copied into a message
/// and out of it. `looksForMore` is what a process has to do that never waits in a socket, as more
/// may come: it takes messages until there are none. ZeroMQ then has to wake it for the next one.
void bareZeroMq(benchmark::State& state, bool looksForMore) {
  zmq::context_t context;
  zmq::socket_t server{context, zmq::socket_type::router},
      client{context, zmq::socket_type::dealer};
  server.bind("inproc://bare");
  client.connect("inproc://bare");
  Image picture, received;
  picture.allocate();
  received.allocate();
  const std::size_t size = picture.pixels.size() * sizeof(Pixel);
  const std::array<char, Frame::headerSize> request{};
  const auto demandNoMore = [looksForMore](zmq::socket_t& socket) {
    zmq::message_t more;
    if (looksForMore && socket.recv(more, zmq::recv_flags::dontwait))
      throw std::logic_error("one message too many");
  };
  for ([[maybe_unused]] auto _ : state) {
    client.send(zmq::buffer(request), zmq::send_flags::none);
    zmq::message_t peer, question, answer{size}, arrived;
    if (!server.recv(peer) || !server.recv(question)) throw std::logic_error("no request");
    demandNoMore(server);
    std::memcpy(answer.data(), picture.pixels.data(), size);
    server.send(peer, zmq::send_flags::sndmore);
    server.send(answer, zmq::send_flags::none);
    if (!client.recv(arrived)) throw std::logic_error("no image");
    demandNoMore(client);
    std::memcpy(received.pixels.data(), arrived.data(), size);
    benchmark::DoNotOptimize(received.pixels.data());
  }
}

/// What a Unix socket alone needs to pass the image's bytes.
void bareUnixSocket(benchmark::State& state) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends) != 0)
    throw std::runtime_error("socketpair");
  Image picture, received;
  picture.allocate();
  received.allocate();
  const std::size_t size = picture.pixels.size() * sizeof(Pixel);
  for ([[maybe_unused]] auto _ : state) {
    std::size_t sent = 0, arrived = 0;
    while (arrived < size) {
      const auto out = reinterpret_cast<const char*>(picture.pixels.data());
      const auto in = reinterpret_cast<char*>(received.pixels.data());
      if (const auto n = write(ends[0], out + sent, size - sent); n > 0)
        sent += static_cast<std::size_t>(n);
      if (const auto n = read(ends[1], in + arrived, size - arrived); n > 0)
        arrived += static_cast<std::size_t>(n);
    }
    benchmark::DoNotOptimize(received.pixels.data());
  }
  close(ends[0]);
  close(ends[1]);
}

BENCHMARK(processCycle)->Name("speed.process.cycle")->Apply(inMicroseconds);
BENCHMARK_CAPTURE(bareZeroMq, blocking, false)
    ->Name("speed.process.zeromq.bare")
    ->Apply(inMicroseconds);
BENCHMARK_CAPTURE(bareZeroMq, looking, true)
    ->Name("speed.process.zeromq.bareLooking")
    ->Apply(inMicroseconds);
BENCHMARK(wireInProgram)->Name("speed.process.zeromq.wire")->Apply(inMicroseconds);
// Between programs other threads work, too: the time of them all. Two messages, the request and the
// notice, are four calls of the operating system, which alone take longer than the aim where a bare
// Unix socket does, too; the image is copied three times, as nobody reads what may change
// meanwhile.
BENCHMARK(wireBetweenPrograms)
    ->Name("speed.process.ipc.wire")
    ->Apply(inMicroseconds)
    ->MeasureProcessCPUTime();
BENCHMARK(bareUnixSocket)
    ->Name("speed.process.ipc.bareUnixSocket")
    ->Apply(inMicroseconds)
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace gt
