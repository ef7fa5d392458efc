#include <cstdio>
#include <exception>
#include <new>

#include "commands.hpp"
#include "interrupt.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/version.hpp"

namespace {

using namespace lepp;

int status_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::input:
      return cli::bad_input;
    case ErrorKind::refused:
      return cli::refused;
    case ErrorKind::output:
      return cli::output;
  }
  return cli::bug;
}

int run(int argc, char** argv) {
  CLI::App app{"lepp: 2-D meshes that finite elements and finite volumes can trust"};
  app.set_version_flag("--version", std::string("lepp ") + version);
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 done and checked; 1 usage; 2 bad input; 3 valid, but the goal or a\n"
      "claim is not reached; 4 refused or cancelled; 5 cannot write; 6 a bug of ours.");
  int status = cli::done;
  cli::add_mesh_command(app, status);
  cli::add_refine_command(app, status);
  cli::add_check_command(app, status);
  cli::add_convert_command(app, status);
  cli::add_info_command(app, status);
  cli::add_picture_command(app, status);
  cli::add_terrain_command(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? cli::done : cli::usage;
  }
  if (status == cli::bug) {
    std::fputs("lepp: the result failed its own check; please report this input\n", stderr);
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  cli::catch_signals();
  if (!predicates_self_test()) {
    std::fputs("lepp: this build breaks floating-point arithmetic; build without -ffast-math\n",
               stderr);
    return cli::bug;
  }
  try {
    return run(argc, argv);
  } catch (const Error& error) {
    std::fprintf(stderr, "lepp: %s\n      %s\n      %s\n", error.where().c_str(),
                 error.problem().c_str(), error.remedy().c_str());
    return status_of(error.kind());
  } catch (const std::bad_alloc&) {
    std::fputs("lepp: out of memory\n", stderr);
    return cli::refused;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lepp: unexpected: %s\n", error.what());
    return cli::bug;
  }
}
