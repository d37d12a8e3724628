#include "serve/lines.hpp"

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <utility>

#include <poll.h>
#include <unistd.h>

namespace moldlight::serve {

namespace {

constexpr int k_wait_ms = 100;
constexpr std::size_t k_chunk_bytes = 65'536;
/// A pipe that poll() calls ready takes so much without waiting (PIPE_BUF).
constexpr std::size_t k_pipe_bytes = 4096;

}  // namespace

bool LineReader::read_more() {
  pollfd ready{.fd = descriptor_, .events = POLLIN, .revents = 0};
  if (::poll(&ready, 1, k_wait_ms) <= 0) return false;
  buffer_.erase(0, std::exchange(begin_, 0));
  const std::size_t kept = buffer_.size();
  buffer_.resize(kept + k_chunk_bytes);
  const ssize_t count = ::read(descriptor_, buffer_.data() + kept, k_chunk_bytes);
  const bool again = count < 0 && (errno == EINTR || errno == EAGAIN);
  buffer_.resize(kept + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  ended_ = count <= 0 && !again;
  return !again;
}

LineReader::Got LineReader::next(std::string& line) {
  // What is kept of a line holds no end of it.
  for (std::size_t from = begin_;;) {
    const std::size_t end = buffer_.find('\n', from);
    const std::size_t size = std::min(end, buffer_.size()) - begin_;
    const bool too_long = size > most_bytes_;
    if (end != std::string::npos || ended_) {
      if (end == std::string::npos && size == 0) return Got::end;
      line.assign(buffer_, begin_, too_long ? 0 : size);
      begin_ = from = std::min(end, buffer_.size() - 1) + 1;
      if (std::exchange(passing_over_, false)) continue;
      return too_long ? Got::too_long : Got::line;
    }
    if (too_long || passing_over_) {
      buffer_.clear();
      begin_ = 0;
      if (!std::exchange(passing_over_, true)) return Got::too_long;
    }
    from = buffer_.size() - begin_;
    if (!read_more()) return Got::nothing;
  }
}

void LineWriter::write(std::string line) {
  line += '\n';
  const std::lock_guard lock(mutex_);
  for (std::string_view rest = line; !rest.empty() && !broken_;) {
    pollfd ready{.fd = descriptor_, .events = POLLOUT, .revents = 0};
    if (::poll(&ready, 1, k_wait_ms) > 0) {
      const ssize_t count = ::write(descriptor_, rest.data(), std::min(rest.size(), k_pipe_bytes));
      if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
      if (count < 0 && errno != EINTR && errno != EAGAIN) broken_ = true;
    }
    if (!rest.empty() && gives_up_()) broken_ = true;
  }
}

bool LineWriter::is_read() const {
  pollfd ready{.fd = descriptor_, .events = 0, .revents = 0};
  return !broken_ && (::poll(&ready, 1, 0) <= 0 || (ready.revents & POLLERR) == 0);
}

}  // namespace moldlight::serve
