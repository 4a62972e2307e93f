#include "logs/LogPlayer.h"

#include <algorithm>

namespace gt {
namespace {

Time timeOf(const McapMessage& message) {
  return Time{static_cast<std::int64_t>(message.time / 1'000'000)};
}

}  // namespace

Result<LogPlayer> LogPlayer::open(const std::string& path) {
  auto log = McapReader::open(path);
  if (!log) return log.error();
  LogPlayer player{path, std::move(*log)};
  while (player.read()) {
    // What was recorded late belongs to the moment in which it came.
    const Time time = timeOf(player.message_);
    if (player.moments_.empty() || time > player.moments_.back().time)
      player.moments_.push_back({time, player.messages_});
    ++player.messages_;
    ++player.messagesOf_[player.message_.channel];
  }
  if (player.moments_.empty()) return Error{.file = path, .what = "the log holds no messages"};
  player.seek(0);
  return player;
}

Time LogPlayer::now() const {
  return position_ == 0 ? begin() : moments_[position_ - 1].time;
}

void LogPlayer::seek(std::size_t moment) {
  position_ = std::min(moment, moments_.size());
  passed_ = static_cast<double>((atEnd() ? end() : moments_[position_].time) - begin());
  hasMessage_ = false;
}

void LogPlayer::seekTime(Time time) {
  const auto found = std::ranges::lower_bound(moments_, time, {}, &Moment::time);
  seek(static_cast<std::size_t>(found - moments_.begin()));
}

void LogPlayer::seekMessage(std::uint64_t message) {
  const auto found = std::ranges::upper_bound(moments_, message, {}, &Moment::first);
  seek(static_cast<std::size_t>(found - moments_.begin()) - 1);
}

void LogPlayer::pass(double ms) {
  if (playing_) passed_ += ms * speed_;
}

bool LogPlayer::due() {
  if (!playing_) return false;
  if (atEnd() && loop_) seek(0);
  return !atEnd() && static_cast<double>(moments_[position_].time - begin()) <= passed_;
}

std::uint64_t LogPlayer::messagesOf(std::uint16_t channel) const {
  const auto found = messagesOf_.find(channel);
  return found == messagesOf_.end() ? 0 : found->second;
}

/// Reads on in the file; false at its end.
bool LogPlayer::read() {
  const auto message = log_.next();
  hasMessage_ = message.has_value();
  if (hasMessage_) message_ = *message;
  return hasMessage_;
}

/// The log ends before the message that is played next, which was there when it was opened.
Error LogPlayer::cutOff() {
  position_ = moments_.size();
  if (log_.damage().empty()) return {.file = path_, .what = "the log was cut off"};
  return log_.damage().back();
}

Result<bool> LogPlayer::next(const Handler& handle) {
  if (atEnd()) return false;
  const Moment moment = moments_[position_++];
  const std::uint64_t behind = atEnd() ? messages_ : moments_[position_].first;
  if (!hasMessage_ || number_ != moment.first) {
    // No earlier message in the file is of its time or a later one.
    log_.seek(nanoseconds(moment.time));
    do {
      if (!read()) return cutOff();
    } while (timeOf(message_) < moment.time);
    number_ = moment.first;
  }
  for (; number_ < behind; ++number_) {
    if (!hasMessage_) return cutOff();
    if (auto done = handle(*log_.channel(message_.channel), message_); !done) return done.error();
    read();
  }
  return true;
}

}  // namespace gt
