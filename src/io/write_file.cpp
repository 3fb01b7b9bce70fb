// Bytes into a file so that there is the whole new file or the old one: written to a neighbour,
// flushed to the disk, renamed.
#include <surpass/io.hpp>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace surpass {
namespace {

constexpr mode_t kNewFile = 0666;  // less the umask
constexpr int kNamesTried = 100;

const char* advice(int code) {
  switch (code) {
    case ENOSPC:
    case EDQUOT: return "; free some space, or write to another disk";
    case EACCES:
    case EPERM: return "; choose a folder or file that you may write to";
    case EROFS: return "; choose a folder that is not read-only";
    case ENOENT:
    case ENOTDIR: return "; create the folder first, or correct its name";
    case EISDIR: return "; name a file inside it";
    case EPIPE: return "; the program that reads our output has ended";
    default: return "";
  }
}

Result<void> refused(int code, const std::string& path) {
  return fail(ErrorCode::cannot_write,
              fmt::format("cannot be written: {}{}", std::strerror(code), advice(code)),
              {.file = path});
}

// 0, or the error's number.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

int write_and_close(int file, std::string_view bytes, bool flush) {
  int code = write_all(file, bytes);
  if (code == 0 && flush && ::fsync(file) != 0) code = errno;
  if (::close(file) != 0 && code == 0) code = errno;
  return code;
}

// Behind links, so that they stay links.
std::string real_path(const std::string& path) {
  char* resolved = ::realpath(path.c_str(), nullptr);
  if (resolved == nullptr) return path;
  std::string result = resolved;
  std::free(resolved);
  return result;
}

// A file of ours alone beside `path`, hidden while it is not complete.
int open_neighbour(const std::string& path, std::string& neighbour) {
  const std::size_t name = path.find_last_of('/') + 1;
  for (int k = 0; k < kNamesTried; ++k) {
    neighbour =
        fmt::format("{}.{}.{}-{}.tmp", path.substr(0, name), path.substr(name), ::getpid(), k);
    const int file = ::open(neighbour.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFile);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

Result<void> replace(const std::string& path, const struct stat* old, std::string_view bytes) {
  if (old != nullptr && ::access(path.c_str(), W_OK) != 0) return refused(errno, path);
  std::string neighbour;
  const int file = open_neighbour(path, neighbour);
  if (file < 0) return refused(errno, path);
  int code = 0;
  if (old != nullptr && ::fchmod(file, old->st_mode & 07777U) != 0) code = errno;
  const int written = write_and_close(file, bytes, true);
  if (code == 0) code = written;
  if (code == 0 && ::rename(neighbour.c_str(), path.c_str()) != 0) code = errno;
  if (code == 0) return {};
  ::unlink(neighbour.c_str());
  return refused(code, path);
}

// Devices and pipes are no files to be replaced.
Result<void> write_into(const std::string& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return refused(errno, path);
  const int code = write_and_close(file, bytes, false);
  if (code != 0) return refused(code, path);
  return {};
}

}  // namespace

Result<void> write_file(const std::string& path, std::string_view bytes) {
  if (path == "-") {
    const int code = write_all(STDOUT_FILENO, bytes);
    if (code != 0) return refused(code, "standard output");
    return {};
  }
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return replace(path, nullptr, bytes);
  if (S_ISDIR(status.st_mode)) return refused(EISDIR, path);
  if (!S_ISREG(status.st_mode)) return write_into(path, bytes);
  return replace(real_path(path), &status, bytes);
}

}  // namespace surpass
