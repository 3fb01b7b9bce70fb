// clang's libFuzzer: fuzz_obj CORPUS_FOLDER, and so on for the other formats.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/parse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const surpass::Format format = surpass::format_named(SURPASS_FUZZ_FORMAT);
  const std::string complaint = surpass::complaint_about(bytes, format);
  if (!complaint.empty()) {
    std::fprintf(stderr, "%s\n", complaint.c_str());
    std::abort();
  }
  return 0;
}
