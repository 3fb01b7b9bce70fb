#include "process.hpp"

#include <surpass/io.hpp>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace surpass::test {

namespace {

namespace fs = std::filesystem;

int open_or_throw(const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0600);
  if (file < 0) throw std::runtime_error("cannot open " + path);
  return file;
}

/// In the child: never returns.
[[noreturn]] void become_surpass(const std::vector<std::string>& arguments, int in, int out,
                                 int err, const Surroundings& around) {
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (around.file_limit) {
    const rlimit limit = {*around.file_limit, *around.file_limit};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  std::vector<std::string> words = {around.program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(around.program.c_str(), pointers.data());
  ::_exit(127);
}

int wait_for(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int pipe_without_reader() {
  int ends[2] = {};
  if (::pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
  ::close(ends[0]);
  return ends[1];
}

}  // namespace

Outcome surpass(const std::vector<std::string>& arguments, const Surroundings& around) {
  const TempFolder folder;
  const std::string out_path = around.output_to.empty() ? folder / "out" : around.output_to;
  const int in = open_or_throw(folder.file("in", around.input), O_RDONLY);
  const int out =
      around.closed_pipe ? pipe_without_reader() : open_or_throw(out_path, O_WRONLY | O_CREAT);
  const int err = open_or_throw(folder / "err", O_WRONLY | O_CREAT);
  const pid_t child = ::fork();
  if (child == 0) become_surpass(arguments, in, out, err, around);
  for (const int file : {in, out, err}) ::close(file);
  Outcome outcome;
  outcome.status = wait_for(child);
  if (around.output_to.empty() && !around.closed_pipe) outcome.out = slurp(out_path);
  outcome.err = slurp(folder / "err");
  return outcome;
}

Outcome surpass_interrupted(const std::vector<std::string>& arguments, const std::string& sign,
                            int signal) {
  int terminal = -1;
  int screen = -1;
  if (::openpty(&terminal, &screen, nullptr, nullptr, nullptr) != 0) {
    throw std::runtime_error("cannot make a terminal");
  }
  const pid_t child = ::fork();
  if (child == 0) {
    const int nothing = open_or_throw("/dev/null", O_RDWR);
    ::close(terminal);
    become_surpass(arguments, nothing, nothing, screen, {});
  }
  ::close(screen);
  Outcome outcome;
  bool sent = false;
  char buffer[4096];
  for (ssize_t count = 0; (count = ::read(terminal, buffer, sizeof buffer)) > 0;) {
    outcome.err.append(buffer, static_cast<std::size_t>(count));
    if (!sent && outcome.err.find(sign) != std::string::npos) {
      ::kill(child, signal);
      sent = true;
    }
  }
  outcome.status = wait_for(child);
  ::close(terminal);
  return outcome;
}

TempFolder::TempFolder() {
  std::string name = (fs::temp_directory_path() / "surpass-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder");
  path_ = name;
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string TempFolder::operator/(const std::string& name) const { return path_ / name; }

std::string TempFolder::file(const std::string& name, const std::string& text) const {
  const std::string path = *this / name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::vector<std::string> TempFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

nlohmann::json report_of(std::vector<std::string> words, int status) {
  const TempFolder folder;
  words.insert(words.end(), {"--report", folder / "report.json"});
  const Outcome outcome = surpass(words);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  return nlohmann::json::parse(slurp(folder / "report.json"));
}

bool is_built_in(const std::string& part) {
  std::istringstream lines(surpass({"--version"}).out);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  " + part + " ")) return !line.ends_with("not built in");
  }
  return false;
}

std::string slurp(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

Mesh mesh_of(const std::string& path) {
  const Result<LoadedMesh> loaded = read_mesh(path);
  if (!loaded) throw std::runtime_error(describe(loaded.error()));
  return loaded->mesh;
}

std::string data(const std::string& name) { return std::string(SURPASS_DATA_DIR "/") + name; }

std::string grid_off(unsigned n) {
  std::string text = fmt::format("OFF\n{} {} 0\n", n * n, 2 * (n - 1) * (n - 1));
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned j = 0; j < n; ++j) {
      text += fmt::format("{} {} {}\n", i, j, std::sin(0.9 * i) * std::cos(1.3 * j));
    }
  }
  for (unsigned i = 0; i + 1 < n; ++i) {
    for (unsigned j = 0; j + 1 < n; ++j) {
      const unsigned a = i * n + j;
      text += fmt::format("3 {} {} {}\n3 {} {} {}\n", a, a + n, a + 1, a + 1, a + n, a + n + 1);
    }
  }
  return text;
}

}  // namespace surpass::test
