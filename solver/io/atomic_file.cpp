// SPDX-License-Identifier: MIT
#include "solver/io/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace bake {
namespace {

std::string failure(const std::filesystem::path& file, const char* failed, int reason) {
  return fmt::format("{}: {}: {}", file.string(), failed, std::generic_category().message(reason));
}

/// Repeats a system call that a signal interrupted.
template <class Call>
auto uninterrupted(Call call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target) : target_(std::move(target)), aside_(target_.string() + ".part") {
  std::error_code unknown;  // then it is told below
  const auto there = std::filesystem::status(target_, unknown).type();
  using std::filesystem::file_type;
  if (there == file_type::character || there == file_type::block || there == file_type::fifo || there == file_type::socket)
    throw OutputError(fmt::format("{}: found a device or a pipe, allowed: a file", target_.string()));
  descriptor_ = ::open(aside_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw OutputError(failure(target_, "cannot create", errno));
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(aside_.c_str());
}

void AtomicFile::note_failure() noexcept {
  if (first_error_ == 0) first_error_ = errno;
}

void AtomicFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) noexcept {
  while (!bytes.empty() && first_error_ == 0) {
    const auto written = uninterrupted([&] { return ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset)); });
    if (written < 0) return note_failure();
    offset += static_cast<std::uint64_t>(written);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

std::size_t AtomicFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) noexcept {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const auto got =
        uninterrupted([&] { return ::pread(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done)); });
    if (got < 0) note_failure();
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

void AtomicFile::resize(std::uint64_t size) noexcept {
  if (uninterrupted([&] { return ::ftruncate(descriptor_, static_cast<off_t>(size)); }) != 0) note_failure();
}

void AtomicFile::check() const {
  if (first_error_ != 0) throw UnfinishedOutputError(failure(target_, "cannot write", first_error_));
}

void AtomicFile::put_in_place() {
  check();
  if (uninterrupted([&] { return ::fsync(descriptor_); }) != 0)
    throw UnfinishedOutputError(failure(target_, "cannot flush to disk", errno));
  if (::rename(aside_.c_str(), target_.c_str()) != 0) throw OutputError(failure(target_, "cannot put the new file in place", errno));
  ::close(descriptor_);
  descriptor_ = -1;
}

void AtomicFile::commit() {
  put_in_place();
  flush_folder(target_.parent_path());
}

void flush_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  bool flushed = false;
  if (descriptor >= 0) flushed = uninterrupted([&] { return ::fsync(descriptor); }) == 0 || errno == EINVAL;  // of network file systems
  const int reason = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!flushed) throw UnfinishedOutputError(failure(folder, "what was written there cannot be flushed to disk", reason));
}

void write_text_atomically(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write_at(0, std::as_bytes(std::span(text)));
  file.commit();
}

}  // namespace bake
