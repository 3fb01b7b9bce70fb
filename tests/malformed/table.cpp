// Every nasty file of the given folder against expect.tsv: read and of sound topology (0), refused
// for its text or bytes (2), or for the mesh that they describe (3).
#include <surpass/io.hpp>
#include <surpass/topology.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

namespace surpass {
namespace {

namespace fs = std::filesystem;

struct Expected {
  int exit_code = 0;
  std::string error = {};
};

std::map<std::string, Expected> read_table() {
  std::map<std::string, Expected> table;
  std::ifstream file(SURPASS_MALFORMED_TABLE);
  std::string line;
  std::getline(file, line);  // the names of the columns
  while (std::getline(file, line)) {
    std::istringstream columns(line);
    std::string name;
    std::string exit_code;
    Expected expected;
    std::string reason;
    std::getline(columns, name, '\t');
    std::getline(columns, exit_code, '\t');
    std::getline(columns, expected.error, '\t');
    std::getline(columns, reason);
    EXPECT_FALSE(reason.empty()) << name << " has no reason";
    expected.exit_code = std::stoi(exit_code);
    table[name] = expected;
  }
  return table;
}

// The group of an error's code, as in result.hpp.
int exit_code_of(ErrorCode code) { return code < ErrorCode::empty_mesh ? 2 : 3; }

void expect_helpful(const Error& error, const std::string& path) {
  const bool of_file = exit_code_of(error.code) == 2;
  EXPECT_FALSE(error.message.empty());
  if (of_file) {
    EXPECT_EQ(error.place.file, path);
    const bool whole_file =
        error.code == ErrorCode::unknown_format || error.message == "the file is empty";
    EXPECT_TRUE(error.place.line || error.place.byte || whole_file) << describe(error);
    EXPECT_EQ(error.place.line.has_value(), error.place.column.has_value());
  } else if (error.code != ErrorCode::empty_mesh) {
    EXPECT_TRUE(error.place.face || error.place.edge || error.place.vertex) << describe(error);
  }
}

void expect_outcome(const std::string& path, const Expected& expected) {
  const auto loaded = read_mesh(path);
  Result<void> outcome;
  if (!loaded) {
    outcome = tl::make_unexpected(loaded.error());
  } else if (loaded->mesh.face_count() == 0) {
    outcome = fail(ErrorCode::empty_mesh, "no faces");
  } else if (const auto topology = Topology::build(loaded->mesh); !topology) {
    outcome = tl::make_unexpected(topology.error());
  }
  if (outcome) {
    EXPECT_EQ(expected.exit_code, 0);
    EXPECT_EQ(expected.error, "-");
    return;
  }
  EXPECT_EQ(expected.exit_code, exit_code_of(outcome.error().code)) << describe(outcome.error());
  EXPECT_EQ(expected.error, name_of(outcome.error().code)) << describe(outcome.error());
  expect_helpful(outcome.error(), path);
}

TEST(NastyFiles, EndAsTheTableSays) {
  const std::map<std::string, Expected> table = read_table();
  ASSERT_GT(table.size(), 150U);
  const char* data = std::getenv("SURPASS_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "SURPASS_TEST_DATA names no folder of nasty files";
  const fs::path folder = fs::path(data) / "nasty";
  ASSERT_TRUE(fs::is_directory(folder)) << folder;
  std::size_t met = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (!entry.is_regular_file() || entry.path().extension() == ".tsv") continue;
    SCOPED_TRACE(name);
    const auto row = table.find(name);
    ASSERT_NE(row, table.end()) << "the table has no row for this file";
    expect_outcome(entry.path().string(), row->second);
    ++met;
  }
  EXPECT_EQ(met, table.size()) << "the table has rows for files that are not there";
}

}  // namespace
}  // namespace surpass
