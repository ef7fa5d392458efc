#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "convergence.hpp"
#include "lepp/io/plot.hpp"
#include "lepp/io/vtu.hpp"

namespace lepp::demo {
namespace {

// What the methods must show: two in L2, one in H1, less the noise of unstructured meshes.
constexpr ConvergenceOrders required{1.95, 0.97, 1.9};

void print_head(const SolvedProblem& solved) {
  fmt::print("Convergence on {}, each mesh a fresh run of the whole pipeline.\n",
             solved.pslg.source);
  fmt::print(
      "FE: P1 elements. FV: two-point fluxes on Voronoi boxes, measured as their linear "
      "interpolant.\n");
  fmt::print("{:>9} {:>9} {:>11} {:>11} {:>11} {:>9} {:>9}\n", "h", "unknowns", "FE L2", "FE H1",
             "FV L2", "FE [s]", "FV [s]");
}

void print_row(const ConvergenceLevel& level) {
  fmt::print("{:>9.4g} {:>9} {:>11.4e} {:>11.4e} {:>11.4e} {:>9.3f} {:>9.3f}\n", level.h,
             level.unknowns, level.fe_l2, level.fe_h1, level.fv_l2, level.fe_seconds,
             level.fv_seconds);
}

void print_orders(const ConvergenceOrders& orders) {
  fmt::print("{:>9} {:>9} {:>11.3f} {:>11.3f} {:>11.3f}\n", "order", "", orders.fe_l2, orders.fe_h1,
             orders.fv_l2);
  fmt::print("{:>9} {:>9} {:>11} {:>11} {:>11}\n", "at least", "", required.fe_l2, required.fe_h1,
             required.fv_l2);
}

void write_solutions(const std::filesystem::path& file, const AdmissibleMesh& made,
                     const SolvedProblem& solved, const Solution& fe, const Solution& fv) {
  std::vector<double> exact;
  for (const Point p : made.mesh.points()) exact.push_back(solved.exact.value(p));
  write_vtu(made.mesh, file,
            {{{"u_fe", {fe.u.begin(), fe.u.end()}},
              {"u_fv", {fv.u.begin(), fv.u.end()}},
              {"u_exact", exact}},
             {}});
}

LogLogPlot plot_of(const Convergence& convergence) {
  LogLogPlot plot;
  plot.title = "Errors on two materials with a hole";
  plot.x_label = "(free unknowns)^(-1/2)";
  plot.y_label = "error";
  plot.series = {{"FE, L2", {}, {}}, {"FE, H1", {}, {}}, {"FV, L2", {}, {}}};
  for (const ConvergenceLevel& level : convergence.levels) {
    const double x = 1 / std::sqrt(static_cast<double>(level.unknowns));
    for (PlotSeries& series : plot.series) series.x.push_back(x);
    plot.series[0].y.push_back(level.fe_l2);
    plot.series[1].y.push_back(level.fe_h1);
    plot.series[2].y.push_back(level.fv_l2);
  }
  plot.slopes = {{1, "slope 1"}, {2, "slope 2"}};
  return plot;
}

std::string json_of(const Convergence& convergence) {
  nlohmann::ordered_json report{{"levels", nlohmann::ordered_json::array()}};
  for (const ConvergenceLevel& level : convergence.levels) {
    report["levels"].push_back({{"h", level.h},
                                {"unknowns", level.unknowns},
                                {"fe_l2", level.fe_l2},
                                {"fe_h1", level.fe_h1},
                                {"fv_l2", level.fv_l2},
                                {"fe_seconds", level.fe_seconds},
                                {"fv_seconds", level.fv_seconds}});
  }
  const ConvergenceOrders& orders = convergence.orders;
  report["orders"] = {{"fe_l2", orders.fe_l2}, {"fe_h1", orders.fe_h1}, {"fv_l2", orders.fv_l2}};
  return report.dump(2) + "\n";
}

}  // namespace

ExitStatus run_convergence_study(const CommandLine& line) {
  const bool talks = line.json != "-";
  const std::filesystem::path folder = make_folder(line.folder);
  const SolvedProblem solved = two_materials_with_hole();
  if (talks) print_head(solved);
  int number = 0;
  const Convergence convergence = run_convergence(
      solved, {},
      [&](const ConvergenceLevel& level, const AdmissibleMesh& made, const Solution& fe,
          const Solution& fv) {
        if (talks) print_row(level);
        ++number;
        write_solutions(folder / fmt::format("convergence_{}.vtu", number), made, solved, fe, fv);
      });
  write_plot(plot_of(convergence), folder / "convergence.svg");
  if (talks) {
    print_orders(convergence.orders);
    fmt::print("wrote {} and convergence_1.vtu to convergence_{}.vtu\n",
               (folder / "convergence.svg").string(), number);
  }
  if (!line.json.empty()) write_json(line.json, json_of(convergence));
  const ConvergenceOrders& orders = convergence.orders;
  const bool reached = orders.fe_l2 >= required.fe_l2 && orders.fe_h1 >= required.fe_h1 &&
                       orders.fv_l2 >= required.fv_l2;
  return reached ? done : goal_missed;
}

}  // namespace lepp::demo
