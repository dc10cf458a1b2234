// SPDX-License-Identifier: MIT
#include "solver/io/provenance.h"

#include <H5public.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "bake_build.h"   // made at configuration: flags and versions
#include "bake_commit.h"  // made at every build: state of the sources

namespace bake {
namespace {

/// The value of the first line "key <separator> value" of a file like /proc/cpuinfo; "unknown" without.
std::string looked_up(const char* file, const std::string& key, char separator) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    const auto at = line.find(separator);
    const auto from = at == std::string::npos ? at : line.find_first_not_of(" \t\"", at + 1);
    if (from != std::string::npos) return line.substr(from, line.find_last_not_of(" \t\"") + 1 - from);
  }
  return "unknown";
}

std::string operating_system() {
  utsname kernel{};
  uname(&kernel);
  return fmt::format("{}, {} {} {}", looked_up("/etc/os-release", "PRETTY_NAME", '='), kernel.sysname, kernel.release, kernel.machine);
}

std::string date_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[sizeof "2000-01-01T00:00:00Z"];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

std::string fmt_version() { return fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100); }

nlohmann::json dirty() {
  const std::string state = BAKE_SOURCES;
  return state == "unknown" ? nlohmann::json(nullptr) : nlohmann::json(state == "dirty");
}

}  // namespace

std::int64_t memory_bytes() { return std::int64_t{sysconf(_SC_PHYS_PAGES)} * sysconf(_SC_PAGESIZE); }

nlohmann::json provenance() {
  return {
      {"program",
       {{"version", BAKE_VERSION},
        {"commit", BAKE_COMMIT},
        {"dirty", dirty()},
        {"solver", BAKE_SOLVER},
        {"compiler", compiler()},
        {"flags", BAKE_FLAGS},
        {"build_type", BAKE_BUILD_TYPE}}},
      {"libraries", {{"hdf5", hdf5_version()}, {"eigen", BAKE_EIGEN_VERSION}, {"fmt", fmt_version()}}},
      {"machine",
       {{"cpu", looked_up("/proc/cpuinfo", "model name", ':')},
        {"logical_cores", std::thread::hardware_concurrency()},
        {"memory_bytes", memory_bytes()},
        {"os", operating_system()}}},
      {"date", date_utc()},
  };
}

}  // namespace bake
