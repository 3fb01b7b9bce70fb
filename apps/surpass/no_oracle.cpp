// The program `surpass`: OpenSubdiv is in another, or not built in.
#include <algorithm>
#include <cerrno>

#include "evaluator.hpp"
#include "other_program.hpp"

namespace surpass::cli {

namespace {
constexpr char kOracle[] = "surpass-oracle";
}  // namespace

std::string oracle_version() { return is_beside(kOracle) ? kOracle : "not built in"; }

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
  const auto asks = [](const std::string& word) {
    return word == "--oracle" || word.starts_with("--oracle=");
  };
  if (std::none_of(words.begin(), words.end(), asks)) return std::nullopt;
  become_program_beside(kOracle, words);
  if (errno == ENOENT) return std::nullopt;
  return tell_not_started(kOracle);
}

}  // namespace surpass::cli
