#include "machine.hpp"

#include <surpass/version.hpp>

#include <fstream>
#include <set>
#include <thread>

#include <CGAL/version.h>
#include <Eigen/Core>
#include <OpenMesh/Core/System/config.h>
#include <assimp/version.h>
#include <cholmod.h>
#include <fmt/format.h>
#include <opensubdiv/version.h>
#include <sys/utsname.h>

namespace surpass::bench {
namespace {

// The rest of the first line that starts with `key`, after its colon.
std::string value_in(const char* path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(key, 0) != 0) continue;
    const auto value = line.find_first_not_of(" \t", line.find(':') + 1);
    return value == std::string::npos ? "" : line.substr(value);
  }
  return "unknown";
}

std::string system_name() {
  utsname name = {};
  return ::uname(&name) == 0 ? fmt::format("{} {}", name.sysname, name.release) : "unknown";
}

// File names of the linear algebra libraries in this process: CHOLMOD's speed is theirs.
std::string blas() {
  std::set<std::string> names;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const auto slash = line.rfind('/');
    if (slash != std::string::npos && line.find("blas", slash) != std::string::npos) {
      names.insert(line.substr(slash + 1));
    }
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::map<std::string, std::string> machine_facts() {
  return {
      {"processor", value_in("/proc/cpuinfo", "model name")},
      {"cores", std::to_string(std::thread::hardware_concurrency())},
      {"memory", value_in("/proc/meminfo", "MemTotal")},
      {"system", system_name()},
      {"compiler", SURPASS_BENCH_COMPILER},
      {"surpass", fmt::format("{}, threads by {}", kVersion, kThreads)},
      {"eigen",
       fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"cholmod",
       fmt::format("{}.{}.{}", CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION)},
      {"blas", blas()},
      {"opensubdiv", fmt::format("{}", OPENSUBDIV_VERSION_NUMBER)},
      {"openmesh", fmt::format("{:x}", OM_VERSION)},
      {"cgal", CGAL_VERSION_STR},
      {"assimp",
       fmt::format("{}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch())},
  };
}

}  // namespace surpass::bench
