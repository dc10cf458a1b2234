#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: libjson-c-dev 0.16-2.
# Behaviour: a whole number above 2^64 that is written without point and exponent becomes 2^64 - 1, also for who asks for a double, and is
# written back as that. Below -2^63 it becomes -2^63.
# Expected: 2e20, as for the texts 2e20 and 200000000000000000000.0, or an error, as in strict mode at least. JSON knows one kind of number,
# and programs write such ones: JavaScript writes 2e20 as 200000000000000000000. Heats and counts of particles reach that.
# Seen: 2e20 becomes 2e+20; 200000000000000000000, strictly read, becomes 1.84467e+19.
source "$(dirname "$0")/common.sh"
debian_packages libjson-c-dev=0.16-2
cat >numbers.cpp <<'END'
#include <json-c/json.h>
#include <cstdio>
#include <cstring>

int main() {
  for (const char* text : (const char*[]){"2e20", "200000000000000000000.0", "200000000000000000000"}) {
    json_tokener* reader = json_tokener_new();
    json_tokener_set_flags(reader, JSON_TOKENER_STRICT);
    json_object* value = json_tokener_parse_ex(reader, text, static_cast<int>(std::strlen(text)) + 1);
    if (value == nullptr) {
      std::printf("%s refused\n", text);
    } else {
      std::printf("%s is %g;\n", text, json_object_get_double(value));
    }
  }
}
END
compile numbers.cpp -ljson-c
look_at ./program
conclude "2e20 is 2e+20; 200000000000000000000.0 is 2e+20; 200000000000000000000 is 1.84467e+19;" \
  "json-c reads a whole number above 2^64 as 2^64 - 1, in silence"
