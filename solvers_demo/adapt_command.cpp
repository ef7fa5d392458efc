#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "adaptive.hpp"
#include "commands.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/plot.hpp"
#include "lepp/io/vtu.hpp"

namespace lepp::demo {
namespace {

namespace fs = std::filesystem;

AdaptiveOptions options_of(const CommandLine& line) {
  AdaptiveOptions options;
  options.by = line.by == "delaunay" ? RefineBy::delaunay : RefineBy::bisect;
  options.estimator = line.estimator == "zz" ? Estimator::zz : Estimator::residual;
  options.solver = line.solver == "direct" ? LinearSolver::direct : LinearSolver::multigrid;
  options.theta = line.theta;
  options.error_quadrature =
      line.error_quadrature == "centroids" ? ErrorQuadrature::centroids : ErrorQuadrature::graded;
  options.max_unknowns = line.max_unknowns;
  return options;
}

void print_head(const CommandLine& line, const AdaptiveProblem& problem) {
  fmt::print("{}\n", problem.title);
  const bool boxes = line.by == "delaunay";
  fmt::print("{}, {} estimator; marked: {}; solver: {}\n",
             boxes ? "Finite volumes on LEPP-Delaunay meshes, each certified"
                   : "P1 elements on meshes of LEPP-bisection",
             line.estimator,
             line.theta >= 1 ? "all" : fmt::format("the fewest with {:g} of eta^2", line.theta),
             line.solver);
  if (line.error_quadrature == "centroids") {
    fmt::print(
        "error by the centroids of 16 equal parts of each triangle: a part of it is missed\n");
  }
  fmt::print("{:>5} {:>9} {:>9} {:>7} {:>11} {:>11} {:>9} {:>10} {:>9}\n", "step", "unknowns",
             "triangles", "angle", "error", "estimate", "est./err.", "iterations", "solve [s]");
}

void print_row(std::size_t number, const AdaptiveStep& step) {
  fmt::print("{:>5} {:>9} {:>9} {:>7.2f} {:>11.4e} {:>11.4e} {:>9.3f} {:>10} {:>9.3f}\n", number,
             step.unknowns, step.triangles, step.min_angle_deg, step.error, step.estimate,
             step.estimate / step.error, step.iterations, step.solve_seconds);
}

fs::path file_of_step(std::size_t number) { return fmt::format("step_{:03}.vtu", number); }

void write_step(const fs::path& folder, std::size_t number, const AdaptiveProblem& problem,
                const Mesh& mesh, const Eigen::VectorXd& u, const std::vector<double>& indicators) {
  std::vector<double> exact, eta;
  for (const Point p : mesh.points()) exact.push_back(problem.exact.value(p));
  for (const double squared : indicators) eta.push_back(std::sqrt(squared));
  write_vtu(mesh, folder / file_of_step(number),
            {{{"u", {u.begin(), u.end()}}, {"u_exact", exact}}, {{"indicator", eta}}});
}

/// The list of files that ParaView plays as a film; the time is the number of the step.
void write_series(const fs::path& file, std::size_t steps) {
  AtomicFiles files;
  OutputFile& out = files.add(file);
  out << "<?xml version=\"1.0\"?>\n"
      << "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      << "<Collection>\n";
  for (std::size_t i = 0; i < steps; ++i) {
    out << "<DataSet timestep=\"" << i << "\" part=\"0\" file=\"" << file_of_step(i).string()
        << "\"/>\n";
  }
  out << "</Collection>\n</VTKFile>\n";
  files.commit();
}

LogLogPlot plot_of(const AdaptiveProblem& problem, const std::vector<AdaptiveStep>& steps,
                   bool uniform) {
  LogLogPlot plot;
  plot.title = problem.title;
  plot.x_label = "unknowns";
  plot.y_label = "energy norm";
  plot.series = {{"error", {}, {}}, {"estimate", {}, {}}};
  for (const AdaptiveStep& step : steps) {
    for (PlotSeries& series : plot.series) {
      series.x.push_back(static_cast<double>(step.unknowns));
    }
    plot.series[0].y.push_back(step.error);
    plot.series[1].y.push_back(step.estimate);
  }
  plot.slopes = {{-0.5, "unknowns^(-1/2)"}};
  if (uniform && problem.singular) {
    const double rate = problem.singular->exponent / 2;
    plot.slopes.push_back({-rate, fmt::format("unknowns^(-{:.3g})", rate)});
  }
  return plot;
}

nlohmann::ordered_json json_of_rate(std::optional<double> rate) {
  return rate ? nlohmann::ordered_json(*rate) : nlohmann::ordered_json(nullptr);
}

/// \param failure  what ended the loop, if it did not end well
std::string json_of(const CommandLine& line, const std::vector<AdaptiveStep>& steps,
                    const std::string& failure) {
  nlohmann::ordered_json report{{"schema_version", 1},
                                {"problem", line.adapt},
                                {"by", line.by},
                                {"estimator", line.estimator},
                                {"solver", line.solver},
                                {"theta", line.theta},
                                {"error_quadrature", line.error_quadrature},
                                {"steps", nlohmann::ordered_json::array()}};
  for (const AdaptiveStep& step : steps) {
    report["steps"].push_back({{"vertices", step.vertices},
                               {"unknowns", step.unknowns},
                               {"triangles", step.triangles},
                               {"min_angle_deg", step.min_angle_deg},
                               {"error", step.error},
                               {"estimate", step.estimate},
                               {"iterations", step.iterations},
                               {"solve_seconds", step.solve_seconds}});
  }
  report["rates"] = {{"error", json_of_rate(observed_rate(steps, &AdaptiveStep::error))},
                     {"estimate", json_of_rate(observed_rate(steps, &AdaptiveStep::estimate))}};
  if (!failure.empty()) report["failure"] = failure;
  return report.dump(2) + "\n";
}

void check_folder(const fs::path& folder, bool overwrite) {
  std::error_code ignored;  // nothing there yet
  if (!overwrite && fs::exists(folder / "series.pvd", ignored)) {
    throw OutputError((folder / "series.pvd").string(), "exists already",
                      "choose another folder, or add --force");
  }
}

/// Of an earlier series that had more steps.
void remove_steps_from(std::size_t number, const fs::path& folder) {
  std::error_code error;  // none left: false
  const auto is_there = [&] { return fs::is_regular_file(folder / file_of_step(number), error); };
  while (is_there() && fs::remove(folder / file_of_step(number), error)) ++number;
}

/// A report that would replace a file of the series is refused before any work is done.
void check_report(const std::string& json, const fs::path& folder) {
  if (json.empty() || json == "-") return;
  const fs::path report = fs::absolute(json);
  const std::string name = report.filename().string();
  const bool is_ours = name == "series.pvd" || name == "errors.svg" ||
                       (name.starts_with("step_") && name.ends_with(".vtu"));
  if (is_same_place(report, folder) || (is_ours && is_same_place(report.parent_path(), folder))) {
    throw OutputError(json, "is named for two outputs", "give --json another name");
  }
}

/// What the loop leaves behind. The series grows with each step, so that hours of work can be
/// looked at however the loop ends.
class Outputs {
 public:
  Outputs(const CommandLine& line, const AdaptiveProblem& problem)
      : line_(line), problem_(problem), talks_(line.json != "-"), writes_(!line.output.empty()) {
    if (!writes_) return;
    check_folder(line.output, line.force);
    check_report(line.json, line.output);
    folder_ = make_folder(line.output);
  }

  bool talks() const { return talks_; }
  const std::vector<AdaptiveStep>& steps() const { return steps_; }

  void add(const AdaptiveStep& step, const Mesh& mesh, const Eigen::VectorXd& u,
           const std::vector<double>& indicators) {
    if (talks_) print_row(steps_.size(), step);
    if (writes_) {
      write_step(folder_, steps_.size(), problem_, mesh, u, indicators);
      write_series(folder_ / "series.pvd", steps_.size() + 1);
    }
    steps_.push_back(step);
  }

  void write_summary(const std::string& failure) const {
    if (writes_) {
      remove_steps_from(steps_.size(), folder_);
      write_plot(plot_of(problem_, steps_, line_.theta >= 1), folder_ / "errors.svg");
      if (talks_) {
        fmt::print("wrote {} and {}\n", (folder_ / "series.pvd").string(),
                   (folder_ / "errors.svg").string());
      }
    }
    if (!line_.json.empty()) write_json(line_.json, json_of(line_, steps_, failure));
  }

 private:
  const CommandLine& line_;
  const AdaptiveProblem& problem_;
  bool talks_, writes_;
  fs::path folder_;
  std::vector<AdaptiveStep> steps_;
};

bool has_ended_early(const CommandLine& line, const std::vector<AdaptiveStep>& steps) {
  return steps.back().unknowns < line.max_unknowns;
}

void print_rates(const CommandLine& line, const std::vector<AdaptiveStep>& steps) {
  if (has_ended_early(line, steps)) {
    fmt::print("stopped: no marked triangle can be made smaller\n");
  }
  const auto error = observed_rate(steps, &AdaptiveStep::error);
  const auto estimate = observed_rate(steps, &AdaptiveStep::estimate);
  if (error && estimate) {
    fmt::print("over the last tenfold of unknowns: error ~ unknowns^-{:.3f}, estimate ^-{:.3f}\n",
               *error, *estimate);
  } else {
    fmt::print("not enough steps to tell a rate\n");
  }
}

/// The first error is the one to tell of, whatever becomes of what is saved.
void save_what_there_is(const Outputs& outputs, const Error& error) {
  if (outputs.steps().empty()) return;
  try {
    outputs.write_summary(error.what());
  } catch (const OutputError&) {
  }
}

}  // namespace

ExitStatus run_adapt(const CommandLine& line) {
  const AdaptiveProblem problem = adaptive_problem(line.adapt);
  Outputs outputs(line, problem);
  if (outputs.talks()) print_head(line, problem);
  try {
    run_adaptive(
        problem, options_of(line),
        [&](const AdaptiveStep& step, const Mesh& mesh, const Eigen::VectorXd& u,
            const std::vector<double>& indicators) { outputs.add(step, mesh, u, indicators); });
  } catch (const Error& error) {
    save_what_there_is(outputs, error);
    throw;
  }
  if (outputs.talks()) print_rates(line, outputs.steps());
  outputs.write_summary("");
  return has_ended_early(line, outputs.steps()) ? goal_missed : done;
}

}  // namespace lepp::demo
