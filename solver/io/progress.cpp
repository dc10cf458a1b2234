// SPDX-License-Identifier: MIT
#include "solver/io/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <utility>

namespace bake {
namespace {

constexpr double k_redraw_s = 0.1;
constexpr double k_log_s = 10;
constexpr double k_memory_s = 20;  ///< time after which a past speed counts 1/e
constexpr int k_narrowest_bar = 10, k_widest_bar = 40;

double share(const Standing& standing) { return standing.end_s > 0 ? std::clamp(standing.time_s / standing.end_s, 0.0, 1.0) : 0; }

std::string frame_text(const Standing& s) { return fmt::format("frame {}/{}", s.frame, s.frames); }
std::string speed_text(const Pace& pace) { return fmt::format("{:.1f} M/s", pace.particle_steps_per_s * 1e-6); }

std::string bar_text(double share, int width) {
  const auto filled = static_cast<std::size_t>(std::lround(share * width));
  return '[' + std::string(filled, '#') + std::string(static_cast<std::size_t>(width) - filled, '.') + ']';
}

int stderr_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

double steady_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

ProgressOutput progress_on_stderr(bool quiet) {
  const auto style = quiet ? ProgressStyle::quiet : isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::lines;
  return {std::cerr, style, steady_seconds, stderr_width};
}

std::string clock_text(double seconds) {
  if (!(seconds >= 0 && seconds < 1e9)) return "-:--";
  const auto whole = std::llround(seconds);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string bar_line(const Standing& s, const Pace& pace, int width) {
  const std::string parts[] = {frame_text(s), fmt::format("left {}", clock_text(pace.left_s)), speed_text(pace),
                               fmt::format("{:.3f} s", s.time_s), fmt::format("dt {:.1e} s", s.dt_s)};  // most important first
  std::string line;
  for (const auto& part : parts) {
    const auto longer = line.empty() ? part : fmt::format("{}  {}", line, part);
    if (longer.size() > static_cast<std::size_t>(std::max(width, 0))) return line;
    line = longer;
  }
  const int room = width - static_cast<int>(line.size()) - 4;  // two brackets, two blanks
  return room < k_narrowest_bar ? line : bar_text(share(s), std::min(room, k_widest_bar)) + "  " + line;
}

std::string log_line(const Standing& s, const Pace& pace) {
  return fmt::format("{}  time {:.4g} of {:.4g} s  dt {:.2e} s  {}  left {}", frame_text(s), s.time_s, s.end_s, s.dt_s, speed_text(pace),
                     clock_text(pace.left_s));
}

Progress::Progress(ProgressOutput output)
    : output_(std::move(output)), last_update_(output_.seconds()), last_shown_(last_update_ - k_log_s) {}

Progress::~Progress() {
  if (line_open_) output_.to << '\n' << std::flush;
}

void Progress::update(const Standing& standing) {
  if (output_.style == ProgressStyle::quiet) return;
  const double now = output_.seconds();
  measure(standing, now);
  output_.style == ProgressStyle::bar ? draw_bar(standing, now) : print_line(standing, now);
  last_ = standing;
}

void Progress::measure(const Standing& standing, double now) {
  const double passed = now - std::exchange(last_update_, now);
  if (std::exchange(first_, false)) return;  // a resumed run does not start at time 0
  const double fade = std::exp(-passed / k_memory_s);
  recent_wall_s_ = recent_wall_s_ * fade + passed;
  recent_time_s_ = recent_time_s_ * fade + (standing.time_s - last_.time_s);
  recent_particle_steps_ = recent_particle_steps_ * fade + static_cast<double>(standing.particle_steps - last_.particle_steps);
}

Pace Progress::pace(const Standing& standing) const {
  if (recent_wall_s_ <= 0) return {0, -1};
  const double left_s = std::max(standing.end_s - standing.time_s, 0.0);
  return {recent_particle_steps_ / recent_wall_s_, left_s == 0 ? 0 : left_s * recent_wall_s_ / recent_time_s_};
}

void Progress::draw_bar(const Standing& standing, double now) {
  const bool last = standing.frame >= standing.frames;
  if (now - last_shown_ < k_redraw_s && !(last && last_.frame < standing.frame)) return;
  // one less than the width: the last column would wrap on some terminals; ESC [ K clears what an older, longer line left
  output_.to << '\r' << bar_line(standing, pace(standing), output_.width() - 1) << "\x1b[K" << std::flush;
  last_shown_ = now;
  line_open_ = true;
}

void Progress::print_line(const Standing& standing, double now) {
  if (standing.frame == last_.frame) return;
  const int tenths = standing.frames > 0 ? static_cast<int>(10LL * standing.frame / standing.frames) : 0;
  if (now - last_shown_ < k_log_s && tenths <= shown_tenths_) return;
  output_.to << log_line(standing, pace(standing)) << std::endl;
  last_shown_ = now;
  shown_tenths_ = tenths;
}

Meter::Meter(std::string what, ProgressOutput output) : what_(std::move(what)), output_(std::move(output)), start_s_(output_.seconds()) {}

void Meter::clear() {
  if (line_open_) output_.to << "\r\x1b[K" << std::flush;
  line_open_ = false;
}

void Meter::draw(const std::string& line) {
  output_.to << '\r' << line << "\x1b[K" << std::flush;
  line_open_ = true;
}

void Meter::phase(const std::string& doing) {
  constexpr double k_brief_s = 2;
  if (output_.style == ProgressStyle::bar) draw(fmt::format("{}  {}", what_, doing));
  if (output_.style == ProgressStyle::lines && output_.seconds() - start_s_ >= k_brief_s)
    output_.to << fmt::format("{}: {}", what_, doing) << std::endl;
}

void Meter::operator()(double share) {
  constexpr double k_between_s = 0.2;
  const double now = output_.seconds();
  const bool is_bar = output_.style == ProgressStyle::bar;
  if (output_.style == ProgressStyle::quiet || now - std::max(last_s_, is_bar ? -1e9 : start_s_) < (is_bar ? k_between_s : k_log_s)) return;
  last_s_ = now;
  const double left_s = share > 0 ? (now - start_s_) * (1 / share - 1) : -1;
  const std::string line = fmt::format("{}  {:3.0f} %  left {}", what_, 100 * share, clock_text(left_s));
  if (is_bar)
    draw(line);
  else
    output_.to << line << std::endl;
}

}  // namespace bake
