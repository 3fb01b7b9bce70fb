#include "other_program.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <unistd.h>

namespace surpass::cli {

namespace {

namespace fs = std::filesystem;

fs::path beside_this_program(const std::string& name) {
  std::error_code failed;
  const fs::path self = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path() : self.parent_path() / name;
}

/// What exec wants: the program's name, the words, and an end.
class ArgumentList {
 public:
  ArgumentList(const std::string& name, const std::vector<std::string>& words) : texts_{name} {
    texts_.insert(texts_.end(), words.begin(), words.end());
    for (std::string& text : texts_) pointers_.push_back(text.data());
    pointers_.push_back(nullptr);
  }
  [[nodiscard]] char* const* pointers() const { return pointers_.data(); }

 private:
  std::vector<std::string> texts_;
  std::vector<char*> pointers_;
};

bool is_there(const fs::path& program) { return access(program.c_str(), X_OK) == 0; }

// This program itself under that name is no other.
bool is_this_program(const fs::path& program) {
  std::error_code absent;
  return fs::equivalent(program, "/proc/self/exe", absent);
}

}  // namespace

bool is_beside(const std::string& name) {
  const fs::path program = beside_this_program(name);
  return is_there(program) && !is_this_program(program);
}

int tell_not_started(const std::string& name) {
  Console().error(fmt::format("{} cannot be started: {}", name, std::strerror(errno)));
  return exit_status(ErrorCode::not_built_in);
}

bool has_other_program(const CommandEntry& entry) {
  const std::string name = fmt::format("surpass-{}", entry.name);
  if (is_there(beside_this_program(name))) return true;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (is_there(fs::path(folder) / name)) return true;
  }
  return false;
}

void become_program_beside(const std::string& name, const std::vector<std::string>& words) {
  const fs::path program = beside_this_program(name);
  if (is_this_program(program)) {
    errno = ENOENT;
    return;
  }
  execv(program.c_str(), ArgumentList(name, words).pointers());
}

int run_other_program(const CommandEntry& entry, const std::vector<std::string>& words) {
  const std::string name = fmt::format("surpass-{}", entry.name);
  become_program_beside(name, words);
  execvp(name.c_str(), ArgumentList(name, words).pointers());
  if (errno != ENOENT) return tell_not_started(name);
  Console().error(
      fmt::format("'{}' is a program of its own, {}, which is neither beside surpass nor on the "
                  "PATH; it is built with {}",
                  entry.name, name, entry.needs));
  return exit_status(ErrorCode::not_built_in);
}

}  // namespace surpass::cli
