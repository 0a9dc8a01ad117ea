// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace mikromakro {
namespace {

// Prefix of the frames in which a finding was looked for; texts of notes are printable.
const std::string judged = "\x01";

std::string line_of(const std::string& text, const std::map<std::int64_t, std::int64_t>& counts) {
  const auto frames = std::ssize(counts) - static_cast<std::int64_t>(counts.count(Notes::whole));
  const auto times =
      std::accumulate(counts.begin(), counts.end(), std::int64_t{0},
                      [](std::int64_t sum, const auto& at_step) { return sum + at_step.second; });
  if (frames == 0) return text;
  const std::string first = fmt::format("step {}", counts.upper_bound(Notes::whole)->first);
  if (times == 1) return fmt::format("{} ({})", text, first);
  if (frames == 1) return fmt::format("{} ({} times in {})", text, times, first);
  if (times == frames) return fmt::format("{} ({} frames, first {})", text, frames, first);
  return fmt::format("{} ({} times in {} frames, first {})", text, times, frames, first);
}

}  // namespace

void Notes::add(std::string_view text, std::int64_t step, std::int64_t count) {
  const std::scoped_lock lock(mutex_);
  auto found = notes_.find(text);
  if (found == notes_.end()) found = notes_.emplace(text, CountByStep()).first;
  found->second[step] = count;
}

void Notes::judge(std::string_view text, bool found, std::int64_t step, std::int64_t count) {
  if (found) add(text, step, count);
  add(judged + std::string(text), step);
}

void Notes::add(const Notes& other) {
  if (&other != this) add_packed(other.packed());
}

std::vector<std::string> Notes::lines() const {
  const std::scoped_lock lock(mutex_);
  std::vector<std::pair<std::int64_t, std::string>> by_step;
  for (const auto& [text, counts] : notes_) {
    if (text.starts_with(judged)) continue;
    const auto of_all = notes_.find(judged + text);
    if (of_all != notes_.end() && 2 * counts.size() < of_all->second.size()) continue;
    by_step.emplace_back(counts.begin()->first, line_of(text, counts));
  }
  std::sort(by_step.begin(), by_step.end());
  std::vector<std::string> all;
  all.reserve(by_step.size());
  for (auto& [step, line] : by_step) all.push_back(std::move(line));
  return all;
}

// STEP COUNT TEXT, terminated by a zero byte, which no text contains.
std::string Notes::packed() const {
  const std::scoped_lock lock(mutex_);
  std::string bytes;
  for (const auto& [text, counts] : notes_)
    for (const auto& [step, count] : counts) bytes += fmt::format("{} {} {}{}", step, count, text, '\0');
  return bytes;
}

void Notes::add_packed(std::string_view bytes) {
  for (std::size_t end = bytes.find('\0'); end != std::string_view::npos; end = bytes.find('\0')) {
    const std::string note(bytes.substr(0, end));
    std::size_t at = 0;
    const std::int64_t step = std::stoll(note, &at);
    const std::string rest = note.substr(at + 1);
    const std::int64_t count = std::stoll(rest, &at);
    add(rest.substr(at + 1), step, count);
    bytes.remove_prefix(end + 1);
  }
}

}  // namespace mikromakro
