#include "io/bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace surpass::io {
namespace {

constexpr std::size_t kFirstBlock = std::size_t{1} << 16;

const char* advice(int code) {
  switch (code) {
    case ENOENT: return "; check the name and the folder";
    case EACCES: return "; you have no permission to read it";
    case EISDIR: return "; name a file inside it";
    default: return "";
  }
}

Result<Bytes> refused(ErrorCode code, int reason, const std::string& path) {
  return fail(code, fmt::format("cannot be read: {}{}", std::strerror(reason), advice(reason)),
              {.file = path});
}

// The size is only a first guess: pipes have none and files may grow.
Result<Bytes> read_descriptor(int file, std::size_t size, const std::string& path) {
  Bytes bytes;
  if (!bytes.reserve(size + 1)) return refused(ErrorCode::cannot_read, ENOMEM, path);
  for (;;) {
    std::size_t room = bytes.capacity() - bytes.view().size();
    if (room == 0) {
      room = bytes.capacity();
      if (!bytes.reserve(2 * room)) return refused(ErrorCode::cannot_read, ENOMEM, path);
    }
    const ssize_t count = ::read(file, bytes.free_space(), room);
    if (count == 0) return bytes;
    if (count > 0) {
      bytes.grow_by(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return refused(ErrorCode::cannot_read, errno, path);
    }
  }
}

}  // namespace

bool Bytes::reserve(std::size_t capacity) {
  std::unique_ptr<char[]> larger(new (std::nothrow) char[capacity]);
  if (!larger) return false;
  std::copy_n(data_.get(), size_, larger.get());
  data_ = std::move(larger);
  capacity_ = capacity;
  return true;
}

Result<Bytes> read_bytes(const std::string& path) {
  if (path == "-") return read_descriptor(STDIN_FILENO, kFirstBlock, "standard input");
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return refused(ErrorCode::cannot_open, errno, path);
  struct stat status = {};
  const bool sized = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  Result<Bytes> bytes =
      read_descriptor(file, sized ? static_cast<std::size_t>(status.st_size) : kFirstBlock, path);
  ::close(file);
  return bytes;
}

}  // namespace surpass::io
