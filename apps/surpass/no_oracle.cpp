// The program `surpass`: OpenSubdiv is in another, or not built in.
#include <algorithm>
#include <cerrno>

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

std::optional<int> become_oracle_if_asked(const std::vector<std::string>& words) {
  constexpr char kName[] = "surpass-oracle";
  const auto asks = [](const std::string& word) {
    return word == "--oracle" || word.starts_with("--oracle=");
  };
  // OpenSubdiv's version is known to the program that has it.
  const bool asked = words.front() == "--version" || std::any_of(words.begin(), words.end(), asks);
  if (!asked) return std::nullopt;
  become_program_beside(kName, words);
  if (errno == ENOENT) return std::nullopt;
  return tell_not_started(kName);
}

}  // namespace surpass::cli
