#include "schema.hpp"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "process.hpp"

namespace surpass::test {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

struct Schema::Parsed {
  valijson::Schema schema;
};

Schema::Schema(const std::string& path) : parsed_(std::make_unique<Parsed>()) {
  const json text = json::parse(slurp(path));
  valijson::SchemaParser(valijson::SchemaParser::kDraft7)
      .populateSchema(Adapter(text), parsed_->schema);
}

Schema::~Schema() = default;

std::string Schema::complaint(const std::string& json_text) const {
  const json document = json::parse(json_text);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(parsed_->schema, Adapter(document), &results)) return "";
  std::string text = "refused:";
  valijson::ValidationResults::Error error;
  while (results.popError(error)) text += "\n" + error.description;
  return text;
}

}  // namespace surpass::test
