// Runs the built executable as a user's shell would, and collects what it says.
#pragma once

#include <surpass/mesh.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace surpass::test {

struct Outcome {
  int status = -1;  ///< exit code; 128 + signal where one ended it
  std::string out = {};
  std::string err = {};
};

struct Surroundings {
  std::string input = {};                        ///< bytes of the standard input
  std::string output_to = {};                    ///< the standard output goes to this file
  std::optional<unsigned long> file_limit = {};  ///< bytes that a file may have
  bool closed_pipe = false;                      ///< nobody reads the standard output
  std::string program = SURPASS_EXECUTABLE;      ///< another one
};

/// surpass with these arguments.
Outcome surpass(const std::vector<std::string>& arguments, const Surroundings& around = {});

/// Runs surpass with a terminal as its stderr, sends `signal` as soon as `sign` was drawn there,
/// and waits for the end. `err` holds what the terminal received.
Outcome surpass_interrupted(const std::vector<std::string>& arguments, const std::string& sign,
                            int signal);

/// A fresh folder, removed with all that is in it.
class TempFolder {
 public:
  TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  ~TempFolder();

  /// The path of a file in it.
  [[nodiscard]] std::string operator/(const std::string& name) const;
  /// Writes such a file; its path.
  std::string file(const std::string& name, const std::string& text) const;
  /// Names of all files in it, hidden ones too, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

/// The report of surpass with these arguments; it has to end with this status.
nlohmann::json report_of(std::vector<std::string> words, int status = 0);

/// Whether --version names this optional part ("oracle") as there.
bool is_built_in(const std::string& part);

std::string slurp(const std::string& path);

/// What read_mesh() finds; throws where it finds none.
Mesh mesh_of(const std::string& path);

/// A mesh of the committed data.
std::string data(const std::string& name);

/// A flat grid of n by n vertices as OFF, bent a little so that it has something to solve.
std::string grid_off(unsigned n);

}  // namespace surpass::test
