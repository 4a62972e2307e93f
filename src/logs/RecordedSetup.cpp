#include "logs/RecordedSetup.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>

#include "base/Enum.h"
#include "base/Number.h"

namespace gt {
namespace {

constexpr const char* metadataName = "gt2003 robot";

/// Whether a name stays in the folder that it is unpacked to.
bool staysInside(const std::filesystem::path& name) {
  return !name.empty() && name.is_relative() &&
         std::none_of(name.begin(), name.end(), [](const auto& part) { return part == ".."; });
}

template <typename E>
std::optional<E> enumOf(const std::string& name) {
  for (std::size_t i = 0; i < enumCount<E>; ++i)
    if (enumNames<E>[i] == name) return static_cast<E>(i);
  return std::nullopt;
}

}  // namespace

void attach(const RecordedSetup& setup, McapWriter& log) {
  log.metadata(metadataName, {{"team", std::string{enumName(setup.player.teamColor)}},
                              {"role", std::string{enumName(setup.player.role)}},
                              {"seed", std::to_string(setup.seed)},
                              {"address", setup.address},
                              {"layout", setup.layout},
                              {"behavior", setup.behavior},
                              {"commit", setup.commit}});
  for (const SetupFile& file : setup.files)
    log.attachment(file.name, "application/octet-stream", Time{},
                   std::as_bytes(std::span{file.content}));
}

Result<RecordedSetup> recordedSetup(const McapReader& log, const std::string& file) {
  const auto& all = log.metadata();
  const auto metadata = std::ranges::find(all, metadataName, &McapReader::Metadata::name);
  if (metadata == all.end())
    return Error{.file = file,
                 .field = metadataName,
                 .what = "the log does not tell how its robot was made"};
  const auto entry = [&](const char* name) {
    const auto at = metadata->entries.find(name);
    return at == metadata->entries.end() ? std::string{} : at->second;
  };
  RecordedSetup setup;
  const auto team = enumOf<TeamColor>(entry("team"));
  const auto role = enumOf<PlayerRole>(entry("role"));
  const auto seed = numberFrom<std::uint64_t>(entry("seed"));
  if (!team || !role || !seed)
    return Error{.file = file, .field = metadataName, .what = "does not tell team, role and seed"};
  setup.player = {*team, *role};
  setup.seed = *seed;
  setup.address = entry("address");
  setup.layout = entry("layout");
  setup.behavior = entry("behavior");
  setup.commit = entry("commit");
  if (!staysInside(setup.behavior))
    return Error{.file = file, .field = metadataName, .what = "has a wrong behavior"};
  for (const McapReader::Attachment& attachment : log.attachments()) {
    if (!staysInside(attachment.name))
      return Error{.file = file,
                   .field = attachment.name,
                   .what = "this attachment's name leads out of its folder"};
    SetupFile& copy = setup.files.emplace_back(SetupFile{attachment.name, {}});
    copy.content.resize(attachment.data.size());
    if (!attachment.data.empty())
      std::memcpy(copy.content.data(), attachment.data.data(), attachment.data.size());
  }
  return setup;
}

}  // namespace gt
