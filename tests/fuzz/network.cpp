#include <span>

#include "Fuzz.h"
#include "framework/Package.h"
#include "framework/Requests.h"
#include "network/Frame.h"
#include "network/Keys.h"
#include "network/RobotList.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/SensorData.h"

namespace {

/// As a wire hands a frame's package to a receiver of its type.
template <typename T>
void receive(const gt::Frame& frame) {
  T value;
  gt::PackageReceiver receiver{gt::representation<T>(), &value};
  (void)!receiver.deliverBytes(frame.bytes);
  receiver.receive();
}

}  // namespace

/// What comes in over the network: frames, the packages and message queues in them, and the
/// router's command line.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto frame = gt::parseFrame(std::as_bytes(std::span{data, size}));
  if (frame) {
    receive<gt::Image>(*frame);
    receive<gt::SensorDataBuffer>(*frame);
    receive<gt::TeamMessages>(*frame);
    receive<gt::MessageQueue>(*frame);
    gt::MessageQueue queue;
    if (queue.assign(frame->bytes))
      queue.handleAllMessages([](const gt::Message& message) {
        gt::TeamMessage team;
        (void)!message.read(team);
        gt::WatchRequest watch;
        (void)!message.read(watch);
      });
  }
  std::vector<std::string> words{""};
  for (const char c : gt::textOf(data, size))
    if (c == ' ')
      words.emplace_back();
    else
      words.back() += c;
  if (words.size() < 100) (void)!gt::RobotList::parse(words, {});
  return 0;
}
