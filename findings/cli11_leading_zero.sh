#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: libcli11-dev 2.1.2+ds-1.
# Behaviour: an option that fills an integer takes a leading zero for octal, so 010 is 8 and 08 is refused; the same text for an option
# that fills a double is 10.
# Expected: 10 and 8. Numbers of frames and steps are often padded with zeros in the names of files, scripts pass them on, and the usual
# readers of decimal numbers (std::from_chars, operator>>) give 10. A table in the manual names octal numbers among those that are
# accepted; that a zero is enough for one, and only where the variable is an integer, it does not say.
# Seen: "8 10", and for 08 exit code 104.
source "$(dirname "$0")/common.sh"
debian_packages libcli11-dev=2.1.2+ds-1
cat >options.cpp <<'END'
#include <CLI/CLI.hpp>
#include <iostream>
int main(int count, char** words) {
  CLI::App app;
  int frame = 0;
  double time = 0;
  app.add_option("--frame", frame);
  app.add_option("--time", time);
  CLI11_PARSE(app, count, words);
  std::cout << frame << ' ' << time << '\n';
}
END
compile options.cpp
both() { ./program --frame 010 --time 010; ./program --frame 08 >/dev/null || echo "exit code $?"; }
look_at both
conclude "8 10 exit code 104" "CLI11 reads 010 as 8 where an integer is asked for, as 10 where a double is, and refuses 08"
