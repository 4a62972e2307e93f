#include "network/Keys.h"

#include <fcntl.h>
#include <unistd.h>
#include <zmq.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/File.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// A key as text of 40 characters (Z85), and the end.
using KeyText = std::array<char, 41>;

/// Leaves no file behind if it cannot be written: it would be in the way of the next try.
Result<void> writeSecret(const std::string& file, const Keys& keys) {
  const int handle = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (handle < 0) return Error{.file = file, .what = "cannot be created, or is there already"};
  const std::string text = writeConfig(keys);
  errno = ENOSPC;  // what a write of only a part does not set
  const bool written = write(handle, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const std::string why = std::strerror(errno);
  close(handle);
  if (written) return {};
  unlink(file.c_str());
  return Error{.file = file, .what = "cannot be written: " + why};
}

bool isKey(const std::string& text) {
  std::array<std::uint8_t, 32> bytes{};
  return text.size() == 40 && zmq_z85_decode(bytes.data(), text.c_str()) != nullptr;
}

}  // namespace

Result<void> makeKeys(const std::string& folder) {
  std::error_code ignored;  // then creating the files reports what is wrong
  if (std::filesystem::create_directories(folder, ignored))
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all, ignored);
  KeyText serverPublic, serverSecret, clientPublic, clientSecret;
  if (zmq_curve_keypair(serverPublic.data(), serverSecret.data()) != 0 ||
      zmq_curve_keypair(clientPublic.data(), clientSecret.data()) != 0)
    return Error{.file = folder, .what = "ZeroMQ was built without CURVE"};
  const std::filesystem::path path{folder};
  const Keys robot{serverPublic.data(), serverSecret.data(), clientPublic.data(), ""};
  if (auto done = writeSecret((path / "robot.key").string(), robot); !done) return done;
  const Keys tool{serverPublic.data(), "", clientPublic.data(), clientSecret.data()};
  auto done = writeSecret((path / "tool.key").string(), tool);
  if (!done) unlink((path / "robot.key").c_str());
  return done;
}

Result<Keys> loadKeys(const std::string& file) {
  const auto text = readFile(file);
  if (!text) return text.error();
  Keys keys;
  if (const auto done = parseConfig(*text, file, keys); !done) return done.error();
  const auto check = [&](const char* name, const std::string& key) -> Result<void> {
    if (key.empty() || isKey(key)) return {};
    return Error{.file = file, .field = name, .what = "is no key: expected 40 characters of Z85"};
  };
  for (const auto& done :
       {check("serverPublic", keys.serverPublic), check("serverSecret", keys.serverSecret),
        check("clientPublic", keys.clientPublic), check("clientSecret", keys.clientSecret)})
    if (!done) return done.error();
  return keys;
}

}  // namespace gt
