#include "LogSpeed.h"

#include <zstd.h>

#include <ctime>
#include <filesystem>
#include <functional>

#include "match/Match.h"

namespace gt {
namespace {

constexpr int runs = 5;
constexpr double megabyte = 1e6;

struct Recorded {
  std::uint16_t channel;
  std::uint64_t time;
  std::vector<std::byte> bytes;
};

/// A log in memory.
struct Messages {
  std::vector<McapSchema> schemas;
  std::vector<McapChannel> channels;
  std::vector<Recorded> all;
  std::size_t size = 0;
};

double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Result<void> playMatch(const DataRoot& root, const std::filesystem::path& folder) {
  MatchOptions options{root};
  options.logs = folder.string();
  options.inputs = true;
  auto match = Match::make(options);
  if (!match) return match.error();
  while ((*match)->time().ms < 12'000) (*match)->step();
  return (*match)->close();
}

Result<Messages> load(const std::string& path) {
  auto log = McapReader::open(path);
  if (!log) return log.error();
  Messages messages;
  messages.schemas = log->schemas();
  messages.channels = log->channels();
  while (const auto m = log->next()) {
    messages.all.push_back({m->channel, m->time, {m->data.begin(), m->data.end()}});
    messages.size += m->data.size();
  }
  if (!log->damage().empty()) return log->damage().front();
  return messages;
}

Result<void> write(const Messages& messages, const std::string& path, bool compress) {
  auto log = McapWriter::open(path, {compress});
  if (!log) return log.error();
  std::vector<McapWriter::ChannelId> ids(1u << 16);
  for (const McapSchema& schema : messages.schemas) log->addSchema(schema);
  for (const McapChannel& channel : messages.channels) ids[channel.id] = log->addChannel(channel);
  for (const Recorded& m : messages.all) log->write(ids[m.channel], m.time, m.bytes);
  return log->close();
}

Result<void> read(const std::string& path) {
  auto log = McapReader::open(path);
  if (!log) return log.error();
  while (log->next()) {
  }
  if (!log->damage().empty()) return log->damage().front();
  return {};
}

/// zstd alone, in pieces as large as a log's chunks.
class Zstd {
 public:
  explicit Zstd(const Messages& messages) {
    for (const Recorded& m : messages.all)
      plain_.insert(plain_.end(), m.bytes.begin(), m.bytes.end());
    packed_.resize(ZSTD_compressBound(piece));
  }
  void compress() {
    pieces_.clear();
    for (std::size_t at = 0; at < plain_.size(); at += piece) {
      const std::size_t n =
          ZSTD_compressCCtx(context_.get(), packed_.data(), packed_.size(), plain_.data() + at,
                            std::min(piece, plain_.size() - at), McapOptions{}.level);
      pieces_.emplace_back(packed_.begin(), packed_.begin() + static_cast<std::ptrdiff_t>(n));
    }
  }
  void decompress() {
    unpacked_.resize(piece);
    for (const auto& packed : pieces_)
      ZSTD_decompress(unpacked_.data(), unpacked_.size(), packed.data(), packed.size());
  }

 private:
  static inline const std::size_t piece = McapOptions{}.chunkSize;
  std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context_{ZSTD_createCCtx(),
                                                                   &ZSTD_freeCCtx};
  std::vector<std::byte> plain_, packed_, unpacked_;
  std::vector<std::vector<std::byte>> pieces_;
};

Result<void> measure(Figures& figures, const std::string& name, std::size_t size,
                     const std::function<Result<void>()>& work) {
  std::vector<double> speeds;
  for (int i = 0; i < runs; ++i) {
    const double begin = processorSeconds();
    if (auto done = work(); !done) return done;
    speeds.push_back(static_cast<double>(size) / megabyte / (processorSeconds() - begin));
  }
  figures.add(name, "MB/s", speeds);
  return {};
}

}  // namespace

Result<void> measureLogSpeed(Figures& figures, const DataRoot& root) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "gt2003-log-speed";
  std::filesystem::create_directories(folder);
  if (auto done = playMatch(root, folder); !done) return done;
  const auto messages = load((folder / "red1.mcap").string());
  if (!messages) return messages.error();
  const std::string plain = (folder / "plain.mcap").string();
  const std::string packed = (folder / "packed.mcap").string();
  Zstd zstd{*messages};
  struct Measurement {
    const char* name;
    std::function<Result<void>()> work;
  };
  const Measurement measurements[] = {
      {"speed.log.write.plain", [&] { return write(*messages, plain, false); }},
      {"speed.log.write.zstd", [&] { return write(*messages, packed, true); }},
      {"speed.log.zstd.compress", [&] { return zstd.compress(), Result<void>{}; }},
      {"speed.log.read.plain", [&] { return read(plain); }},
      {"speed.log.read.zstd", [&] { return read(packed); }},
      {"speed.log.zstd.decompress", [&] { return zstd.decompress(), Result<void>{}; }}};
  for (const Measurement& measurement : measurements)
    if (auto done = measure(figures, measurement.name, messages->size, measurement.work); !done)
      return done;
  figures.add("speed.log.size.zstd", "%",
              {100 * static_cast<double>(std::filesystem::file_size(packed)) /
               static_cast<double>(messages->size)});
  std::filesystem::remove_all(folder);
  return {};
}

}  // namespace gt
