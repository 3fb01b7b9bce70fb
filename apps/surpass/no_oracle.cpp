// The program `surpass`: OpenSubdiv is in another, or not built in.
#include <algorithm>

#include "evaluator.hpp"
#include "other_program.hpp"

namespace surpass::cli {

std::string oracle_version() { return "not built in"; }

Result<void> check_oracle(bool oracle, const Rules& /*rules*/) {
  if (!oracle) return {};
  return fail(ErrorCode::not_built_in,
              "there is no OpenSubdiv here: no program surpass-oracle lies beside this one, so "
              "--oracle is not possible; see surpass --version");
}

Result<Certificate> certify_by_oracle(const Mesh& /*control*/, std::span<const Point> /*given*/,
                                      const Rules& rules) {
  return tl::make_unexpected(check_oracle(true, rules).error());
}

void become_oracle_if_asked(const std::vector<std::string>& words) {
  const auto asks = [](const std::string& word) { return word == "--oracle"; };
  // OpenSubdiv's version is known to the program that has it.
  const bool asked = words.front() == "--version" || std::any_of(words.begin(), words.end(), asks);
  if (asked) become_program_beside("surpass-oracle", words);
}

}  // namespace surpass::cli
