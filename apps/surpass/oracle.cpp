// The program `surpass-oracle`: OpenSubdiv is here.
#include <surpass/oracle.hpp>

#include "evaluator.hpp"

namespace surpass::cli {

std::string oracle_version() { return opensubdiv_version(); }

Result<void> check_oracle(bool oracle, const Rules& rules) {
  if (!oracle) return {};
  auto known = opensubdiv_knows(rules);
  if (!known) known.error().message += "; leave out --oracle";
  return known;
}

Result<Certificate> certify_by_oracle(const Mesh& control, std::span<const Point> given,
                                      const Rules& rules) {
  return certify_with_opensubdiv(control, given, rules);
}

std::optional<int> become_oracle_if_asked(const std::vector<std::string>& /*words*/) {
  return std::nullopt;
}

}  // namespace surpass::cli
