#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/Result.h"
#include "representations/infrastructure/Player.h"
#include "streams/mcap/Mcap.h"

namespace gt {

/// One of the files from which a robot is made.
struct SetupFile {
  std::string name;  ///< As in config/modules.cfg.
  std::vector<std::uint8_t> content;

  static constexpr auto fields() {
    return Fields{field<&SetupFile::name>(), field<&SetupFile::content>()};
  }
};
static_assert(complete<SetupFile>);

/// The data from which a robot is made: its identity, its random seed, and the files of its
/// configuration, motions, behavior and layout. A log contains it, so that a replay only needs the
/// log. A robot's answer to a SetupRequest.
struct RecordedSetup {
  Player player;
  std::string address;  ///< Hardware address.
  std::uint64_t seed = 0;
  std::string layout, behavior, commit;
  std::vector<SetupFile> files;

  static constexpr auto fields() {
    return Fields{field<&RecordedSetup::player>(),
                  field<&RecordedSetup::address>("hardware address of the robot"),
                  field<&RecordedSetup::seed>(),
                  field<&RecordedSetup::layout>("name of the layout file"),
                  field<&RecordedSetup::behavior>("name of the agents file"),
                  field<&RecordedSetup::commit>("commit of the robot's program"),
                  field<&RecordedSetup::files>(
                      "files of the setup: config/..., motions/..., behavior/..., robot.layout")};
  }
};
static_assert(complete<RecordedSetup>);

/// Asks a robot for its RecordedSetup.
struct SetupRequest {
  std::string why;

  static constexpr auto fields() {
    return Fields{field<&SetupRequest::why>("reason of the request, for readers of the messages")};
  }
};
static_assert(complete<SetupRequest>);

/// Adds a setup to a log: files as attachments, the rest as metadata.
void attach(const RecordedSetup& setup, McapWriter& log);

/// The setup in a log. Returns an error if there is none, or it is damaged.
Result<RecordedSetup> recordedSetup(const McapReader& log, const std::string& file);

}  // namespace gt
