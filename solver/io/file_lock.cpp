// SPDX-License-Identifier: MIT
#include "solver/io/file_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace bake {
namespace {

/// "process 1234", as the process that holds the lock has written it.
std::string holder(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  return std::getline(in, line) && line.starts_with("process ") ? line : "another process";
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file) : file_(file), descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) throw OutputError(fmt::format("{}: cannot create: {}", file.string(), std::generic_category().message(errno)));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(descriptor_);
    throw InputError(fmt::format("{}: a run of {} writes here, allowed: another folder, or this one when that run has ended",
                                 file.parent_path().string(), holder(file)));
  }
  const std::string text = fmt::format("process {}\n", ::getpid());
  // the number is for people only: on a full disk the lock holds without it
  if (::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, text.data(), text.size(), 0) < 0) errno = 0;
}

FileLock::~FileLock() { ::close(descriptor_); }

bool FileLock::stands() const {
  struct stat locked {
  }, there{};
  return ::fstat(descriptor_, &locked) == 0 && ::stat(file_.c_str(), &there) == 0 && locked.st_dev == there.st_dev &&
         locked.st_ino == there.st_ino;
}

}  // namespace bake
