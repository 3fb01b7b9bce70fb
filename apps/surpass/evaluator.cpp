#include "evaluator.hpp"

namespace surpass::cli {

void add_oracle(Options& options, bool& oracle) {
  options
      .flag("--oracle", oracle,
            "Judge by OpenSubdiv's evaluator too; for edge-only and edge-and-corner")
      .group("Certificate");
}

Json certificate_json(const Certificate& certificate) {
  return {{"max", certificate.max},
          {"mean", certificate.mean},
          {"worst_vertex", certificate.worst_vertex},
          {"evaluator", certificate.evaluator}};
}

}  // namespace surpass::cli
