# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# For scripts that build without an effect.

# In a copy of the sources: of an effect's file only what a scene may ask of it remains, and what it is called; it can do nothing. Fails if
# there is nothing to take out.
take_out() { # <effect> <root of the copy>
  local file=$2/solver/effects/$1.h
  awk '/^  using (Stored|Moments|Values) / && !gone { print "  template <class Real>\n  struct Constants;\n  template <class... Any>\n  static void fill(Any&&...);"; gone = 1 }
       /^};/ { gone = 0 }
       !gone' "$file" >"$file.less"
  if cmp -s "$file" "$file.less"; then return 1; fi
  mv "$file.less" "$file"
}
