// SPDX-License-Identifier: MIT
#include "solver/io/checkpoint.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <fstream>
#include <system_error>

#include "solver/io/checksum.h"
#include "solver/scene/describe.h"

namespace bake {
namespace {

constexpr std::string_view k_magic = "bake checkpoint ";
constexpr std::size_t k_piece = 1 << 20;  ///< bytes checked at a time

InputError refused(const std::filesystem::path& path, const std::string& what) {
  return InputError(fmt::format("{}: {}; resume from another checkpoint or start the run anew", path.string(), what));
}

/// The checksum of everything behind the heading; `read(offset, bytes)` returns how many bytes it has read. Sets `size` to the file's size.
template <class Read>
std::uint64_t body_checksum(Read read, std::uint64_t& size) {
  std::vector<std::byte> piece(k_piece);
  std::uint64_t sum = 0;
  size = k_checkpoint_heading;
  for (auto got = piece.size(); got == piece.size();) {
    got = read(size, std::span(piece));
    size += got;
    sum = checksum(std::span(piece).first(got), sum);
  }
  return sum;
}

/// The format version that a heading states, or 0 if it is not the heading of a checkpoint.
int stated_format(std::string_view heading) {
  if (!heading.starts_with(k_magic)) return 0;
  int format = 0;
  std::from_chars(heading.data() + k_magic.size(), heading.data() + heading.size(), format);
  return format;
}

/// The size in bytes that a heading states, or 0.
std::uint64_t stated_size(std::string_view heading) {
  constexpr std::string_view k_key = "\nbytes ";
  std::uint64_t size = 0;
  const auto at = heading.find(k_key);
  if (at != std::string_view::npos) std::from_chars(heading.data() + at + k_key.size(), heading.data() + heading.size(), size);
  return size;
}

/// Returns `path` if it is a whole, undamaged checkpoint of this format.
const std::filesystem::path& verified(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw refused(path, fmt::format("cannot open the checkpoint: {}", std::generic_category().message(errno)));
  std::string heading(k_checkpoint_heading, '\0');
  in.read(heading.data(), static_cast<std::streamsize>(heading.size()));
  heading.resize(static_cast<std::size_t>(in.gcount()));
  const int format = stated_format(heading);
  if (format == 0) throw refused(path, "not a checkpoint of Bake");
  if (format != k_checkpoint_format) {
    throw refused(path, fmt::format("written in checkpoint format {}, this program reads format {}", format, k_checkpoint_format));
  }
  std::uint64_t size = 0;
  const auto read = [&](std::uint64_t, std::span<std::byte> bytes) {
    in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return static_cast<std::size_t>(in.gcount());
  };
  const auto sum = body_checksum(read, size);
  if (size < stated_size(heading)) throw refused(path, fmt::format("cut short, {} of {} bytes are left", size, stated_size(heading)));
  if (heading != checkpoint_heading(size, sum)) throw refused(path, "damaged, its checksum does not match its contents");
  return path;
}

}  // namespace

std::string checkpoint_heading(std::uint64_t size, std::uint64_t sum) {
  auto text = fmt::format("{}{}\nbytes {}\nxxh64 {:016x}\n", k_magic, k_checkpoint_format, size, sum);
  text.resize(k_checkpoint_heading - 1, ' ');
  return text + '\n';
}

CheckpointWriter::CheckpointWriter(const std::filesystem::path& path, std::string_view fingerprint, Precision precision)
    : file_(path), out_(file_, k_checkpoint_heading) {
  out_.group("arrays");
  out_.group("values");
  out_.attribute("/", "fingerprint", fingerprint);
  out_.attribute("/", "precision", word_of(precision));
}

void CheckpointWriter::commit() {
  out_.close();
  std::uint64_t size = 0;
  const auto sum = body_checksum([&](std::uint64_t offset, std::span<std::byte> bytes) { return file_.read_at(offset, bytes); }, size);
  const auto heading = checkpoint_heading(size, sum);
  file_.write_at(0, std::as_bytes(std::span(heading)));
  file_.commit();
}

CheckpointReader::CheckpointReader(const std::filesystem::path& path) : in_(verified(path)) {}

void CheckpointReader::expect(std::string_view fingerprint, Precision precision, const std::function<std::string()>& difference) const {
  const auto written = in_.attribute<std::string>("/", "precision");
  if (written != word_of(precision)) {
    throw InputError(fmt::format("{}: written in {} precision, the run asks for {}; resume with precision = \"{}\"", in_.path().string(),
                                 written, word_of(precision), written));
  }
  if (in_.attribute<std::string>("/", "fingerprint") == fingerprint) return;
  const std::string where = difference();
  throw refused(in_.path(), "belongs to another scene" + (where.empty() ? where : fmt::format(" ({})", where)));
}

void CheckpointReader::expect_type(const std::string& name, ElementType type) const {
  if (in_.stored_type(name) != type) throw refused(in_.path(), fmt::format("{}: holds numbers of another type than expected", name));
}

}  // namespace bake
