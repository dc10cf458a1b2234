// SPDX-License-Identifier: MIT
// Whatever the bytes: reading a checkpoint returns, or throws InputError. The first byte of the input chooses
//   0  the rest is the file
//   1  the rest are edits of a good checkpoint: two bytes of position, one of change, again and again
// (A forged file whose heading fits makes HDF5 1.10 itself leak and ask for absurd amounts of memory; no promise covers that.)
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>

#include "solver/io/checkpoint.h"

namespace {

using namespace bake;

std::string good_checkpoint() {
  const auto path = std::filesystem::temp_directory_path() / ("checkpoint_fuzzer." + std::to_string(getpid()));
  CheckpointWriter out(path, "scene", Precision::single_precision);
  out.add<float>("position", std::array{1.0f, 2.0f, 3.0f});
  out.add<std::int64_t>("id", std::array<std::int64_t, 1>{7});
  out.set("time_s", 0.5);
  out.set("random", "state");
  out.commit();
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(path);
  return text;
}

std::string edited(std::string text, std::span<const std::uint8_t> edits) {
  for (; edits.size() >= 3; edits = edits.subspan(3)) {
    const auto at = static_cast<std::size_t>(edits[0] | edits[1] << 8) % text.size();
    text[at] = static_cast<char>(text[at] ^ edits[2]);
  }
  return text;
}

std::string file_from(std::span<const std::uint8_t> input) {
  static const std::string good = good_checkpoint();
  const auto rest = input.subspan(1);
  return input[0] == 1 ? edited(good, rest) : std::string(rest.begin(), rest.end());
}

void read_everything(const std::string& path) {
  try {
    const CheckpointReader in(path);
    in.expect("scene", Precision::single_precision);
    in.array<float>("position");
    in.array<std::int64_t>("id");
    in.value<double>("time_s");
    in.value<std::string>("random");
  } catch (const InputError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto text = file_from({data, size});
  const int file = memfd_create("checkpoint", MFD_CLOEXEC);
  if (file < 0 || write(file, text.data(), text.size()) != static_cast<ssize_t>(text.size())) std::abort();
  read_everything("/proc/self/fd/" + std::to_string(file));
  close(file);
  return 0;
}
