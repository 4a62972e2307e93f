#include <algorithm>
#include <set>
#include <utility>

#include "streams/mcap/Mcap.h"
#include "streams/mcap/McapContent.h"
#include "streams/mcap/McapRecords.h"

namespace gt {

using namespace mcap;

std::string timeText(std::uint64_t time) {
  const std::string thousandths = std::to_string(time / 1'000'000 % 1000);
  return std::to_string(time / 1'000'000'000) + "." + std::string(3 - thousandths.size(), '0') +
         thousandths + " s";
}

std::string mcap::stretchText(std::uint64_t first, std::uint64_t last) {
  return first == last ? timeText(first) : timeText(first) + " to " + timeText(last);
}

/// What a reader holds: what is known of the log's content, and the segment that is being read.
struct McapReader::State {
  std::unique_ptr<LogContent> content;
  std::size_t nextSegment = 0;
  Segment* segment = nullptr;  ///< Which is being read.
  bool collects = false;       ///< What the segment holds beside messages is not yet known.
  bool ended = false;          ///< Another program has changed the file.
  std::uint64_t lastTime = 0;  ///< Of the message that was read last.
  bool anyMessage = false;
  std::set<std::uint16_t> undescribed{};  ///< Channels without a record.
  Bytes record{}, unpacked{};
  Taker messages{{}};

  void enter(Segment& next);
  std::optional<McapMessage> takeMessage();
};

/// Makes the messages of a segment the ones that are read next.
void McapReader::State::enter(Segment& next) {
  messages = Taker{{}};
  segment = &next;
  collects = !std::exchange(next.looked, true);
  if (next.lost) return;
  const auto records = content->load(next, record, unpacked);
  if (content->file.hasChanged(!content->complete)) {
    ended = true;
    content->note(anyMessage ? "after " + timeText(lastTime) : "",
                  "the log was changed by another program; what followed is left out");
  } else if (!records) {
    content->note(next, records.error().what);
    next.lost = true;
  } else {
    messages = Taker{*records};
  }
}

/// The next message of the segment; nothing at its end.
std::optional<McapMessage> McapReader::State::takeMessage() {
  while (!messages.empty()) {
    const auto opcode = messages.number<Opcode>();
    const auto bytes = messages.bytes(messages.number<std::uint64_t>());
    if (!messages.ok()) {
      messages = Taker{{}};
      if (!std::exchange(segment->damaged, true))
        content->note(
            stretchText(std::min(std::max(lastTime, segment->firstTime), segment->lastTime),
                        segment->lastTime),
            "the chunk holds a damaged message; what follows in it is lost");
      return std::nullopt;
    }
    if (opcode != Opcode::message) {
      if (collects && !isKnown(opcode))
        content->unknown.push_back(
            {static_cast<std::uint8_t>(opcode), Bytes{bytes.begin(), bytes.end()}});
      continue;
    }
    Taker fields{bytes};
    McapMessage m;
    m.channel = fields.number<std::uint16_t>();
    m.sequence = fields.number<std::uint32_t>();
    m.time = fields.number<std::uint64_t>();
    m.publishTime = fields.number<std::uint64_t>();
    m.data = fields.bytes(fields.left());
    if (!fields.ok()) {
      if (!std::exchange(segment->damaged, true))
        content->note(stretchText(segment->firstTime, segment->lastTime),
                      "a message is damaged; it is lost");
    } else if (!content->channel(m.channel)) {
      if (undescribed.insert(m.channel).second)
        content->note("from " + timeText(m.time) + " on",
                      "messages of channel " + std::to_string(m.channel) +
                          ", which the log does not describe, are lost");
    } else {
      lastTime = m.time;
      anyMessage = true;
      return m;
    }
  }
  return std::nullopt;
}

McapReader::McapReader(std::unique_ptr<State> state) : state_{std::move(state)} {}
McapReader::McapReader(McapReader&&) noexcept = default;
McapReader& McapReader::operator=(McapReader&&) noexcept = default;
McapReader::~McapReader() = default;

Result<McapReader> McapReader::open(const std::string& path) {
  auto content = LogContent::survey(path);
  if (!content) return content.error();
  auto state = std::make_unique<State>();
  state->content = std::move(*content);
  return McapReader{std::move(state)};
}

const McapHeader& McapReader::header() const {
  return state_->content->header;
}

const std::vector<McapSchema>& McapReader::schemas() const {
  return state_->content->schemas;
}

const std::vector<McapChannel>& McapReader::channels() const {
  return state_->content->channels;
}

const McapChannel* McapReader::channel(std::uint16_t id) const {
  return state_->content->channel(id);
}

const std::vector<McapReader::Metadata>& McapReader::metadata() const {
  return state_->content->metadata;
}

const std::vector<McapReader::Attachment>& McapReader::attachments() const {
  return state_->content->attachments;
}

const std::vector<McapUnknownRecord>& McapReader::unknown() const {
  return state_->content->unknown;
}

std::size_t McapReader::unknownInIndex() const {
  return state_->content->unknownInIndex;
}

bool McapReader::complete() const {
  return state_->content->complete;
}

bool McapReader::indexed() const {
  return state_->content->indexed;
}

bool McapReader::hasDataChecksum() {
  return state_->content->hasDataChecksum();
}

const std::optional<McapStatistics>& McapReader::statistics() const {
  return state_->content->statistics;
}

std::size_t McapReader::chunks() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(state_->content->segments, &Segment::isChunk));
}

const std::vector<Error>& McapReader::damage() const {
  return state_->content->damage;
}

std::optional<McapMessage> McapReader::next() {
  State& s = *state_;
  for (;;) {
    if (auto message = s.takeMessage()) return message;
    if (s.ended || s.nextSegment >= s.content->segments.size()) return std::nullopt;
    s.enter(s.content->segments[s.nextSegment++]);
  }
}

void McapReader::seek(std::uint64_t time) {
  State& s = *state_;
  s.messages = Taker{{}};
  s.nextSegment = 0;
  while (s.nextSegment < s.content->segments.size() && time > 0 &&
         s.content->segments[s.nextSegment].lastTime < time)
    ++s.nextSegment;
}

}  // namespace gt
