#include "evaluator.hpp"

#ifdef SURPASS_ORACLE
#include <surpass/oracle.hpp>
#endif

#include <fmt/format.h>

namespace surpass::cli {

void add_oracle(Options& options, bool& oracle) {
  options
      .flag("--oracle", oracle,
            "Judge by OpenSubdiv's evaluator too; for edge-only and edge-and-corner")
      .group("Certificate");
}

Result<void> check_oracle(bool oracle, const Rules& rules) {
  if (!oracle) return {};
#ifdef SURPASS_ORACLE
  auto known = opensubdiv_knows(rules);
  if (!known) known.error().message += "; leave out --oracle";
  return known;
#else
  static_cast<void>(rules);
  return fail(ErrorCode::not_built_in,
              "this build has no OpenSubdiv, so --oracle is not possible; see surpass --version");
#endif
}

Result<Certificate> certify_by_oracle(const Mesh& control, std::span<const Point> given,
                                      const Rules& rules) {
#ifdef SURPASS_ORACLE
  return certify_with_opensubdiv(control, given, rules);
#else
  static_cast<void>(control), static_cast<void>(given);
  return tl::make_unexpected(check_oracle(true, rules).error());
#endif
}

Json certificate_json(const Certificate& certificate) {
  return {{"max", certificate.max},
          {"mean", certificate.mean},
          {"worst_vertex", certificate.worst_vertex},
          {"evaluator", certificate.evaluator}};
}

}  // namespace surpass::cli
