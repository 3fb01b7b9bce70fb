// Files on the disk: formats by name and content, replacing, refusing.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "unit/io_support.hpp"

namespace surpass {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  Files() {
    std::string name = (fs::temp_directory_path() / "surpass-io-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~Files() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }

  fs::path folder_;
};

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST_F(Files, WritesAndReadsEveryFormatByItsEnding) {
  for (const char* name : {"a.obj", "b.PLY", "c.off", "d.Stl"}) {
    ASSERT_TRUE(write_mesh(unit_triangle(), path(name)));
    const auto loaded = read_mesh(path(name));
    ASSERT_TRUE(loaded) << describe(loaded.error());
    EXPECT_EQ(loaded->mesh, unit_triangle());
    EXPECT_EQ(loaded->format, format_of_path(name));
    EXPECT_TRUE(loaded->notices.empty());
  }
}

TEST_F(Files, ContentGoesBeforeTheName) {
  ASSERT_TRUE(write_mesh(unit_triangle(), path("a.obj"), {.format = Format::ply}));
  const auto loaded = read_mesh(path("a.obj"));
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->format, Format::ply);
  EXPECT_EQ(loaded->notices,
            (std::vector<std::string>{
                "the name says obj, but the content is ply, and was read as such"}));
}

TEST_F(Files, ReplacesWholeAndKeepsPermissions) {
  ASSERT_TRUE(write_file(path("a"), "a longer text"));
  ASSERT_EQ(::chmod(path("a").c_str(), 0640), 0);
  ASSERT_TRUE(write_file(path("a"), "short"));
  EXPECT_EQ(content(path("a")), "short");
  EXPECT_EQ(entries(), 1U);
  EXPECT_EQ(fs::status(path("a")).permissions(), static_cast<fs::perms>(0640));
}

TEST_F(Files, LinksStayLinks) {
  ASSERT_TRUE(write_file(path("a"), "old"));
  fs::create_symlink("a", path("link"));
  ASSERT_TRUE(write_file(path("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(content(path("a")), "new");
}

TEST_F(Files, PipesAreWrittenInto) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  ASSERT_TRUE(write_file(path("pipe"), "through"));
  char buffer[16] = {};
  EXPECT_EQ(::read(reader, buffer, sizeof buffer), 7);
  EXPECT_STREQ(buffer, "through");
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

void expect_refused(const Result<void>& result, const std::string& sentence) {
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::cannot_write);
  EXPECT_EQ(describe(result.error()), sentence);
}

TEST_F(Files, FullDisksMissingFoldersAndFoldersAreRefused) {
  if (fs::exists("/dev/full")) {
    expect_refused(write_file("/dev/full", "x"),
                   "/dev/full: cannot be written: No space left on device; free some space, or "
                   "write to another disk");
  }
  expect_refused(write_file(path("no/a"), "x"),
                 path("no/a") +
                     ": cannot be written: No such file or directory; create the folder "
                     "first, or correct its name");
  expect_refused(write_file(folder_.string(), "x"),
                 folder_.string() + ": cannot be written: Is a directory; name a file inside it");
  EXPECT_EQ(entries(), 0U);
}

TEST_F(Files, ReadOnlyFilesAndFoldersAreRefused) {
  if (::geteuid() == 0) GTEST_SKIP() << "permissions do not bind the superuser";
  ASSERT_TRUE(write_file(path("a"), "old"));
  ASSERT_EQ(::chmod(path("a").c_str(), 0444), 0);
  EXPECT_FALSE(write_file(path("a"), "new"));
  EXPECT_EQ(content(path("a")), "old");
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  expect_refused(write_file(path("b"), "x"),
                 path("b") +
                     ": cannot be written: Permission denied; choose a folder or file that "
                     "you may write to");
}

TEST_F(Files, MissingFilesAndFoldersCannotBeRead) {
  const auto missing = read_mesh(path("none.obj"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::cannot_open);
  EXPECT_EQ(describe(missing.error()),
            path("none.obj") +
                ": cannot be read: No such file or directory; check the name and the folder");
  const auto folder = read_mesh(folder_.string());
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().code, ErrorCode::cannot_read);
}

TEST_F(Files, UnknownFormatsAreRefused) {
  const auto written = write_mesh(unit_triangle(), path("a.abc"));
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::unknown_format);
  ASSERT_TRUE(write_file(path("a.abc"), "0 0 0\n"));
  const auto loaded = read_mesh(path("a.abc"));
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, ErrorCode::unknown_format);
}

TEST_F(Files, MalformedMeshesAreNotWritten) {
  Mesh mesh = unit_triangle();
  mesh.face_vertices[1] = 7;
  const auto written = write_mesh(mesh, path("a.obj"));
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::invalid_argument);
  EXPECT_EQ(entries(), 0U);
}

TEST(Formats, NamesGoBothWays) {
  EXPECT_EQ(format_of_path("a.b/c"), Format::automatic);
  EXPECT_EQ(format_of_path("a.obj/c.ply"), Format::ply);
  for (const Format format : {Format::obj, Format::ply, Format::off, Format::stl, Format::xyz}) {
    EXPECT_EQ(format_named(name_of(format)), format);
  }
}

}  // namespace
}  // namespace surpass
