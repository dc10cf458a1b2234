// SPDX-License-Identifier: MIT
// Shows how far a run has come: one line that is redrawn on a terminal, a plain line now and then in a log, or nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace bake {

/// The state of a run that the progress line shows.
struct Standing {
  int frame = 0;   ///< frames written so far
  int frames = 0;  ///< frames of the whole run
  double time_s = 0;
  double end_s = 0;
  double dt_s = 0;
  std::uint64_t particle_steps = 0;  ///< since the program started; rises
};

/// The speed of the run, measured over about the last half minute; 0 while unknown.
struct Pace {
  double particle_steps_per_s = 0;
  double left_s = 0;
};

enum class ProgressStyle { quiet, bar, lines };

/// Where the progress is shown. Clock and width are functions so that tests can replace them.
struct ProgressOutput {
  std::ostream& to;
  ProgressStyle style;
  std::function<double()> seconds;  ///< a clock that never runs backwards
  std::function<int()> width;       ///< of the terminal, in characters
};

/// A clock that never runs backwards.
double steady_seconds();

/// Shows it on standard error: as a bar if that is a terminal, else as lines; not at all if `quiet`.
ProgressOutput progress_on_stderr(bool quiet);

/// The line for a terminal. To fit into `width` characters it omits first the bar, then the least important parts.
std::string bar_line(const Standing& standing, const Pace& pace, int width);
/// The line for a log.
std::string log_line(const Standing& standing, const Pace& pace);
/// "0:07", "12:34", "3:04:05"; "-:--" if the number is not a time.
std::string clock_text(double seconds);

class Progress {
 public:
  explicit Progress(ProgressOutput output);
  /// Ends the line on the terminal, also when an exception ends the run.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Call it after every step. It redraws the bar at most 10 times a second. In a log it writes a line at a finished frame if 10 s have
  /// passed since the last line or another tenth of the frames is done, and at the last frame.
  void update(const Standing& standing);

 private:
  void measure(const Standing& standing, double now);
  void draw_bar(const Standing& standing, double now);
  void print_line(const Standing& standing, double now);
  Pace pace(const Standing& standing) const;

  ProgressOutput output_;
  Standing last_;           ///< at the update before
  double last_update_;      ///< [s of the clock]
  double last_shown_;       ///< [s of the clock]
  int shown_tenths_ = 0;    ///< of the frames
  bool line_open_ = false;  ///< a bar stands on the terminal's last line
  bool first_ = true;
  // decaying sums over the recent past
  double recent_wall_s_ = 0;
  double recent_time_s_ = 0;
  double recent_particle_steps_ = 0;
};

/// Shows the progress of work without frames: a redrawn line on a terminal; in a log a line for each phase
/// that begins after two seconds, and of a share every ten seconds.
class Meter {
 public:
  explicit Meter(std::string what, ProgressOutput output = progress_on_stderr(false));
  ~Meter() { clear(); }
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;
  void operator()(double share);
  void phase(const std::string& doing);  ///< begins the phase `doing`, whose share is unknown
  void clear();                          ///< clears the line, before something else is printed

 private:
  void draw(const std::string& line);

  std::string what_;
  ProgressOutput output_;
  double start_s_;
  double last_s_ = -1e9;    ///< when a share was shown
  bool line_open_ = false;  ///< on the terminal
};

}  // namespace bake
