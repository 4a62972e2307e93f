#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/Result.h"
#include "representations/infrastructure/Player.h"
#include "streams/mcap/Mcap.h"

namespace gt {

/// A file that makes a robot.
struct SetupFile {
  std::string name;  ///< As in config/modules.cfg.
  std::vector<std::uint8_t> content;

  static constexpr auto fields() {
    return Fields{field<&SetupFile::name>(), field<&SetupFile::content>()};
  }
};
static_assert(complete<SetupFile>);

/// What makes a robot: who it is, its seed, and the files of its configuration, motions, behavior
/// and layout. A log keeps it, so that a replay needs nothing but the log. A robot's answer to a
/// SetupRequest.
struct RecordedSetup {
  Player player;
  std::string address;  ///< Hardware address.
  std::uint64_t seed = 0;
  std::string layout, behavior, commit;
  std::vector<SetupFile> files;

  static constexpr auto fields() {
    return Fields{
        field<&RecordedSetup::player>(),
        field<&RecordedSetup::address>("the hardware's address"),
        field<&RecordedSetup::seed>(),
        field<&RecordedSetup::layout>("the layout file's name"),
        field<&RecordedSetup::behavior>("the agents file's name"),
        field<&RecordedSetup::commit>("of the robot's program"),
        field<&RecordedSetup::files>("config/..., motions/..., behavior/..., robot.layout")};
  }
};
static_assert(complete<RecordedSetup>);

/// Asks a robot for its RecordedSetup.
struct SetupRequest {
  std::string why;

  static constexpr auto fields() {
    return Fields{field<&SetupRequest::why>("for whoever reads the messages")};
  }
};
static_assert(complete<SetupRequest>);

/// Puts a setup into a log: files as attachments, the rest as metadata.
void attach(const RecordedSetup& setup, McapWriter& log);

/// The setup that a log holds; an error if it does not hold one, or a damaged one.
Result<RecordedSetup> recordedSetup(const McapReader& log, const std::string& file);

}  // namespace gt
