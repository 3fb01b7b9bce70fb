// A JSON schema to hold documents against. The validator takes long to compile: schema.cpp alone
// includes it.
#pragma once

#include <memory>
#include <string>

namespace surpass::test {

class Schema {
 public:
  explicit Schema(const std::string& path);
  ~Schema();

  /// "" or what the schema has against the document.
  [[nodiscard]] std::string complaint(const std::string& json) const;

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

}  // namespace surpass::test
