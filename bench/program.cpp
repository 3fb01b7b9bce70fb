#include "program.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace surpass::bench {

void run_program(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), SURPASS_BENCH_PROGRAM);
  arguments.insert(arguments.end(), {"--threads", "1", "--quiet"});
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  ::unsetenv("GLIBC_TUNABLES");  // malloc has read them; the program decides for itself
  pid_t child = 0;
  if (::posix_spawn(&child, pointers[0], nullptr, nullptr, pointers.data(), environ) != 0) {
    throw std::runtime_error("cannot start " SURPASS_BENCH_PROGRAM);
  }
  int status = 0;
  if (::waitpid(child, &status, 0) != child || status != 0) {
    throw std::runtime_error("surpass " + arguments[1] + " failed");
  }
}

nlohmann::json report_of_program(std::vector<std::string> arguments) {
  const std::string report = arguments.at(1) + ".report.json";
  arguments.insert(arguments.end(), {"--report", report});
  run_program(std::move(arguments));
  auto json = nlohmann::json::parse(std::ifstream(report));
  ::unlink(report.c_str());
  return json;
}

}  // namespace surpass::bench
