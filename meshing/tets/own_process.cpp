// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/tets/own_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>

#include "solver/core/errors.h"

namespace bake {
namespace {

constexpr char k_tells = 'T', k_failed = 'F';  // first character of a line from the child

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

void send(int pipe, char kind, std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  text = kind + text + '\n';
  if (::write(pipe, text.data(), text.size()) < 0) ::_exit(1);
}

template <class T>
void write_all(std::FILE* file, const std::vector<T>& values) {
  const std::uint64_t count = values.size();
  std::fwrite(&count, sizeof count, 1, file);
  std::fwrite(values.data(), sizeof(T), values.size(), file);
}

template <class T>
bool read_all(std::FILE* file, std::vector<T>& values) {
  std::uint64_t count = 0;
  if (std::fread(&count, sizeof count, 1, file) != 1) return false;
  values.resize(count);
  return std::fread(values.data(), sizeof(T), count, file) == count;
}

/// Address space in use, which counts against the limit, too.
[[maybe_unused]] double bytes_in_use() {
  double pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

void limit_memory([[maybe_unused]] double bytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const auto most = static_cast<rlim_t>(bytes_in_use() + bytes);
  const rlimit limit{most, most};
  ::setrlimit(RLIMIT_AS, &limit);
#endif
}

[[noreturn]] void work_and_exit(const std::function<TetMesh(const Tell&)>& work, double bytes, int pipe, std::FILE* result) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody else ends it if the program is killed
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  limit_memory(bytes);
  try {
    const TetMesh mesh = work([&](const std::string& doing) { send(pipe, k_tells, doing); });
    write_all(result, mesh.points);
    write_all(result, mesh.tets);
    if (std::fflush(result) != 0 || std::ferror(result) != 0) send(pipe, k_failed, "its result could not be stored");
    ::_exit(0);
  } catch (const std::bad_alloc&) {
    send(pipe, k_failed, fmt::format("it took more than {:.3g} GB of memory", bytes / 1e9));
  } catch (const InputError& error) {
    send(pipe, k_failed, error.what());
  } catch (const std::exception&) {  // a library's, whose text tells the user nothing
    send(pipe, k_failed, "it met a case that it cannot handle");
  }
  ::_exit(1);
}

/// Passes on what the child tells until it closes its end or time is over; returns false then.
bool listen(int pipe, double seconds, const Tell& tell, std::string& failure) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  std::string line;
  for (;;) {
    const double left_s = std::chrono::duration<double>(end - Clock::now()).count();
    if (left_s <= 0) return false;
    pollfd waiting{pipe, POLLIN, 0};
    if (::poll(&waiting, 1, static_cast<int>(std::min(left_s, 1e5) * 1e3) + 1) <= 0) continue;
    std::array<char, 512> text;
    const ssize_t count = ::read(pipe, text.data(), text.size());
    if (count < 0) continue;
    if (count == 0) return true;
    for (const char c : std::string_view(text.data(), static_cast<std::size_t>(count))) {
      if (c != '\n') {
        line += c;
        continue;
      }
      if (line[0] == k_failed) failure = line.substr(1);
      if (line[0] == k_tells) tell(line.substr(1));
      line.clear();
    }
  }
}

}  // namespace

std::variant<TetMesh, NoMesh> in_own_process(const std::function<TetMesh(const Tell&)>& work, const WorkBounds& bounds, const Tell& tell) {
  const auto fail = [] { throw RunError(fmt::format("no process can be made for the mesh: {}", std::strerror(errno))); };
  const File result(std::tmpfile(), std::fclose);
  int ends[2];
  if (!result || ::pipe2(ends, O_CLOEXEC) != 0) fail();
  const pid_t child = ::fork();
  if (child < 0) fail();
  if (child == 0) work_and_exit(work, bounds.bytes, ends[1], result.get());
  ::close(ends[1]);
  std::string failure;
  const bool in_time = listen(ends[0], bounds.seconds, tell, failure);
  ::close(ends[0]);
  if (!in_time) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!in_time) return NoMesh{fmt::format("it did not end within {:.0f} s", bounds.seconds)};
  if (!failure.empty()) return NoMesh{failure};
  TetMesh mesh;
  std::rewind(result.get());
  if (status != 0 || !read_all(result.get(), mesh.points) || !read_all(result.get(), mesh.tets)) return NoMesh{"it died"};
  return mesh;
}

}  // namespace bake
