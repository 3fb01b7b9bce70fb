// surpass convert IN OUT
#include "command.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"

namespace surpass::cli {

namespace {

class Convert : public Command {
 public:
  void define(Options& options) override {
    input_.define(options, "IN", "The mesh to read");
    output_.define(options, "-o,--output,OUT", "The file to write, named with or without -o");
    options.examples(
        "What the output's format cannot hold is said on stderr.\n\n"
        "Examples:\n"
        "  surpass convert scan.stl scan.ply --single\n"
        "  surpass convert polygons.obj triangles.off --triangulate\n"
        "  surpass convert - - --from off --to obj < in.off > out.obj\n");
  }

  Result<void> run(Session& session) override {
    const auto prepared = output_.prepare(session, {input_.path()});
    if (!prepared) return prepared;
    const Result<LoadedMesh> loaded = input_.load(session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    output_.default_format(loaded->format);
    if (const auto fits = output_.check_as_read(loaded->mesh); !fits) return fits;
    return output_.write(loaded->mesh, session);
  }

 private:
  MeshInput input_;
  MeshOutput output_;
};

}  // namespace

std::unique_ptr<Command> make_convert() { return std::make_unique<Convert>(); }

}  // namespace surpass::cli
