// lepp_theorem2 [FILE.svg]
// Theorem 2 of [rivara1999]: the vertices that are made inside and outside of a disc of fixed
// radius r when its triangles get a diameter below eps, n = 2 r / eps, as eps is halved six times.

#include <cmath>
#include <cstdio>

#include "bisection/disc_counts.hpp"
#include "lepp/io/plot.hpp"

namespace {

using namespace lepp;

constexpr int halvings = 6;

}  // namespace

int main(int argc, char** argv) {
  const Disc disc{{0.3, 0.4}, 0.1};
  Forest forest(test::quality_square());
  PlotSeries inside{"N_in / n^2", {}, {}}, outside{"N_out / (n log2 n)", {}, {}};
  std::printf(
      "| eps | n | N_in | N_out | N_in / n^2 | N_out / (n log2 n) |\n|---|---|---|---|---|---|\n");
  double eps = 0.04;
  for (int i = 0; i <= halvings; ++i, eps /= 2) {
    const test::DiscCounts counts = test::refine_disc(forest, disc, eps);
    const double n = 2 * disc.radius / eps;
    const double in = static_cast<double>(counts.inside) / (n * n);
    const double out = static_cast<double>(counts.outside) / (n * std::log2(n));
    for (PlotSeries* series : {&inside, &outside}) series->x.push_back(n);
    inside.y.push_back(in);
    outside.y.push_back(out);
    std::printf("| %g | %g | %zu | %zu | %.3f | %.3f |\n", eps, n, counts.inside, counts.outside,
                in, out);
  }
  if (argc < 2) return 0;
  write_plot({"Theorem 2: vertices made in and around a disc",
              "n = 2 r / eps",
              "ratio",
              {inside, outside},
              {}},
             argv[1]);
}
