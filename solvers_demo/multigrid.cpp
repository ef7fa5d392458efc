#include "multigrid.hpp"

#include <utility>

#include "lepp/geometry/error.hpp"

namespace lepp::demo {

// The matrix of the present level, in the place that the finest one needs: rows lose entries, or
// exchange them, as vertices are removed.
//
//        c                 v = (a + b) / 2: its row and column are added by halves to those of a
//      / | \               and b. Those have entries for c and d already, and where they had one
//     a--v--b              for v they now have one for each other; c and d lose theirs.
//      \ | /
//        d
class Multigrid::Elimination {
 public:
  Elimination(const SparseMatrix& K, std::span<const NewVertex> made);

  /// The vertices that the next level lacks: as numbers in `made`.
  std::vector<std::uint32_t> next();
  void remove(std::uint32_t v, std::uint32_t a, std::uint32_t b);
  std::span<const Entry> row(std::uint32_t k) const {
    return std::span(entries_).subspan(begin_[k], length_[k]);
  }
  double diagonal(std::uint32_t k) const { return diagonal_[k]; }
  bool is_left(std::uint32_t k) const { return left_[k] != 0; }
  std::size_t size() const { return diagonal_.size(); }

 private:
  Entry& at(std::uint32_t k, std::uint32_t column) {
    std::size_t i = begin_[k];
    while (entries_[i].column != column) ++i;  // ends: neighbours have entries for each other
    return entries_[i];
  }
  void drop(std::uint32_t k, std::uint32_t column) {
    at(k, column) = entries_[begin_[k] + length_[k] - 1];
    --length_[k];
  }

  std::vector<Entry> entries_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> length_;
  // Vertices are made one by one, roots before all others.
  bool is_newer(std::uint32_t k, std::uint32_t l) const { return made_[k] > made_[l]; }
  void lose_newer(std::uint32_t k) {
    if (--newer_[k] == 0 && made_[k] > 0) ready_.push_back(made_[k] - 1);
  }

  std::vector<double> diagonal_;
  std::vector<char> left_;
  std::vector<std::uint32_t> made_;   // when: 0 for the vertices of roots
  std::vector<std::uint32_t> newer_;  // how many newer ones are next to it
  std::vector<std::uint32_t> ready_;  // without any, in the next level: numbers in `made`
};

Multigrid::Elimination::Elimination(const SparseMatrix& K, std::span<const NewVertex> made)
    : diagonal_(static_cast<std::size_t>(K.cols()), 0.0) {
  const std::size_t n = diagonal_.size();
  begin_.reserve(n);
  length_.reserve(n);
  left_.assign(n, 1);
  entries_.reserve(static_cast<std::size_t>(K.nonZeros()));
  for (std::size_t k = 0; k < n; ++k) {
    begin_.push_back(entries_.size());
    for (SparseMatrix::InnerIterator entry(K, static_cast<Eigen::Index>(k)); entry; ++entry) {
      const auto l = static_cast<std::uint32_t>(entry.row());
      if (l == k) diagonal_[k] = entry.value();
      else entries_.push_back({l, entry.value()});
    }
    length_.push_back(static_cast<std::uint32_t>(entries_.size() - begin_.back()));
  }
  made_.assign(n, 0);
  for (std::uint32_t i = 0; i < made.size(); ++i) made_[made[i].vertex.index()] = i + 1;
  newer_.assign(n, 0);
  for (std::uint32_t k = 0; k < n; ++k) {
    for (const Entry& entry : row(k)) newer_[k] += is_newer(entry.column, k) ? 1 : 0;
  }
  for (std::uint32_t i = 0; i < made.size(); ++i) {
    if (newer_[made[i].vertex.index()] == 0) ready_.push_back(i);
  }
}

std::vector<std::uint32_t> Multigrid::Elimination::next() { return std::exchange(ready_, {}); }

void Multigrid::Elimination::remove(std::uint32_t v, std::uint32_t a, std::uint32_t b) {
  const double quarter = diagonal_[v] / 4, to_a = at(v, a).value, to_b = at(v, b).value;
  diagonal_[a] += to_a + quarter;
  diagonal_[b] += to_b + quarter;
  const double between = (to_a + to_b) / 2 + quarter;
  at(a, v) = {b, between};
  at(b, v) = {a, between};
  for (const auto& [c, value] : row(v)) {
    if (c == a || c == b) continue;
    drop(c, v);
    lose_newer(c);
    for (const std::uint32_t end : {a, b}) {
      at(end, c).value += value / 2;
      at(c, end).value += value / 2;
    }
  }
  ++newer_[is_newer(a, b) ? b : a];  // now next to each other
  lose_newer(a);
  lose_newer(b);
  left_[v] = 0;
}

Multigrid::Multigrid(const SparseMatrix& K, std::span<const char> free,
                     std::span<const NewVertex> made, SparseMatrix modes)
    : deflation_(K, free, std::move(modes)) {
  Elimination rest(K, made);
  std::vector<std::uint32_t> listed(free.size(), 0);  // the last level that has a row of it, + 1
  std::uint32_t number = 0;
  const auto add_row = [&](VertexId v) {
    const std::uint32_t k = v.value;
    if (free[k] == 0 || listed[k] == number) return;
    listed[k] = number;
    rows_.push_back({k, entries_.size(), rest.diagonal(k)});
    for (const Entry& entry : rest.row(k)) {
      if (free[entry.column] != 0) entries_.push_back(entry);
    }
  };
  for (auto removed = rest.next(); !removed.empty(); removed = rest.next()) {
    ++number;
    Level level{rows_.size(), 0, removed_.size(), 0};
    for (const std::uint32_t i : removed) {
      add_row(made[i].vertex);
      add_row(made[i].a);
      add_row(made[i].b);
    }
    for (const std::uint32_t i : removed) {
      const auto& [v, a, b] = made[i];
      rest.remove(v.value, a.value, b.value);
      if (free[v.index()] != 0) removed_.push_back({v.value, a.value, b.value});
    }
    level.rows_end = rows_.size();
    level.removed_end = removed_.size();
    levels_.push_back(level);
  }
  rows_.push_back({0, entries_.size(), 1});
  for (std::uint32_t k = 0; k < free.size(); ++k) {
    if (free[k] != 0 && rest.is_left(k)) coarsest_.push_back(k);
  }
  factorise_coarsest(rest);
}

void Multigrid::factorise_coarsest(const Elimination& rest) {
  if (coarsest_.empty()) return;
  std::vector<int> number(rest.size(), -1);
  for (std::size_t i = 0; i < coarsest_.size(); ++i) number[coarsest_[i]] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (const std::uint32_t k : coarsest_) {
    entries.emplace_back(number[k], number[k], rest.diagonal(k));
    for (const auto& [l, value] : rest.row(k)) {
      if (number[l] >= 0) entries.emplace_back(number[k], number[l], value);
    }
  }
  const auto n = static_cast<Eigen::Index>(coarsest_.size());
  SparseMatrix A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  coarsest_factors_.compute(A);
  if (coarsest_factors_.info() != Eigen::Success || coarsest_factors_.vectorD().minCoeff() <= 0) {
    throw InputError("the linear system", "is not positive definite",
                     "check the coefficients, and that each part has a Dirichlet or Robin value");
  }
}

void Multigrid::apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) const {
  residual_ = r;
  if (deflation_.is_empty()) return cycle(z);
  const Eigen::VectorXd found = deflation_.take_out(residual_);
  cycle(z);
  deflation_.put_back(found, z);
}

void Multigrid::cycle(Eigen::VectorXd& z) const {
  z.setZero(residual_.size());
  for (const Level& level : levels_) go_down(level);
  if (!coarsest_.empty()) {
    Eigen::VectorXd right(static_cast<Eigen::Index>(coarsest_.size()));
    for (std::size_t i = 0; i < coarsest_.size(); ++i) {
      right[static_cast<Eigen::Index>(i)] = residual_[coarsest_[i]];
    }
    const Eigen::VectorXd values = coarsest_factors_.solve(right);
    for (std::size_t i = 0; i < coarsest_.size(); ++i) {
      z[coarsest_[i]] = values[static_cast<Eigen::Index>(i)];
    }
  }
  for (std::size_t i = levels_.size(); i-- > 0;) go_up(levels_[i], z);
}

// Gauss-Seidel that keeps the residual up to date: a row is a column too.
void Multigrid::go_down(const Level& level) const {
  for (std::size_t i = level.rows_begin; i < level.rows_end; ++i) {
    rows_[i].right = residual_[rows_[i].vertex];
  }
  for (std::size_t i = level.rows_begin; i < level.rows_end; ++i) {
    Row& row = rows_[i];
    row.before = residual_[row.vertex] / row.diagonal;
    residual_[row.vertex] = 0;
    for (const auto& [l, value] : entries(i)) residual_[l] -= value * row.before;
  }
  for (std::size_t i = level.removed_begin; i < level.removed_end; ++i) {
    const auto& [v, a, b] = removed_[i];
    residual_[a] += residual_[v] / 2;
    residual_[b] += residual_[v] / 2;
  }
}

void Multigrid::go_up(const Level& level, Eigen::VectorXd& z) const {
  for (std::size_t i = level.removed_begin; i < level.removed_end; ++i) {
    const auto& [v, a, b] = removed_[i];
    z[v] = (z[a] + z[b]) / 2;
  }
  for (std::size_t i = level.rows_begin; i < level.rows_end; ++i) {
    z[rows_[i].vertex] += rows_[i].before;
  }
  for (std::size_t i = level.rows_end; i-- > level.rows_begin;) {
    const Row& row = rows_[i];
    double sum = row.right;
    for (const auto& [l, value] : entries(i)) sum -= value * z[l];
    z[row.vertex] = sum / row.diagonal;
  }
}

}  // namespace lepp::demo
