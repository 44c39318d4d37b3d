#include "exact/real_lines.h"

#include <CGAL/number_utils.h>

#include <vector>

namespace viewcover::exact {
namespace {

using Components = std::array<double, 6>;

/// Searches the cell for vectors on which the form has one given sign.
class SignSearch {
 public:
  SignSearch(LinePool& pool, const LineCell& cell, int wanted)
      : pool_(pool), cell_(cell), wanted_(wanted), n_(cell.size()) {}

  std::optional<Components> run() {
    // With h = -wanted * (polar form on the rays) we look for c >= 0 with c' h c < 0.
    form_.assign(n_ * n_, 0);
    for (std::size_t i = 0; i < n_; ++i) {
      form_[i * n_ + i] = exact_sign(i, i);
      if (form_[i * n_ + i] < 0) return cell_.ray(i)->approximate().x;
    }
    bool any_negative = false;
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        form_[i * n_ + j] = form_[j * n_ + i] = exact_sign(i, j);
        any_negative |= form_[i * n_ + j] < 0;
        if (form_[i * n_ + j] >= 0) continue;
        if (auto found = critical_point<2>({i, j})) return found;
      }
    }
    if (!any_negative) return std::nullopt;
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          if (auto found = critical_point<3>({i, j, k})) return found;
        }
      }
    }
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          if (!share_two_facets(std::array{i, j, k})) continue;
          for (std::size_t l = 0; l < k; ++l) {
            if (auto found = critical_point<4>({i, j, k, l})) return found;
          }
        }
      }
    }
    return std::nullopt;
  }

 private:
  int exact_sign(std::size_t i, std::size_t j) {
    return -wanted_ * pool_.sign_of_polar_form(*cell_.ray(i), *cell_.ray(j));
  }
  BigInteger value(std::size_t i, std::size_t j) {
    const BigInteger b = pool_.exact_product<3>(*cell_.ray(i), *cell_.ray(j));
    return wanted_ > 0 ? -b : b;
  }

  /// A least value below 0 lies in the relative interior of a face of dimension at most 4, whose
  /// rays share at least two facets.
  template <std::size_t K>
  bool share_two_facets(const std::array<std::size_t, K>& rays) const {
    int common = 0;
    for (std::size_t w = 0; w < cell_.tight(0).size(); ++w) {
      LineCell::Word word = ~LineCell::Word{0};
      for (const std::size_t ray : rays) word &= cell_.tight(ray)[w];
      common += std::popcount(word);
    }
    return common >= 2;
  }

  /// The point c > 0 of the simplex over the rays with h c = const, if c' h c < 0 there. Requires
  /// that no smaller subset has one.
  template <std::size_t K>
  std::optional<Components> critical_point(const std::array<std::size_t, K>& rays) {
    // Row i of h c = const < 0 needs a negative entry besides h_ii >= 0.
    for (const std::size_t i : rays) {
      bool negative = false;
      for (const std::size_t j : rays) negative |= form_[i * n_ + j] < 0;
      if (!negative) return std::nullopt;
    }
    if (K > 2 && !share_two_facets(rays)) return std::nullopt;
    std::vector<std::vector<BigInteger>> h(K, std::vector<BigInteger>(K));
    for (std::size_t a = 0; a < K; ++a) {
      for (std::size_t b = 0; b <= a; ++b) h[a][b] = h[b][a] = value(rays[a], rays[b]);
    }
    if (sign(determinant(h)) >= 0) return std::nullopt;
    // c = adj(h) 1 by Cramer's rule; c' h c = det(h) (sum of c).
    std::array<BigInteger, 6> point;
    for (BigInteger& x : point) x = BigInteger(0);
    for (std::size_t a = 0; a < K; ++a) {
      auto column = h;
      for (std::size_t b = 0; b < K; ++b) column[b][a] = BigInteger(1);
      const BigInteger c = determinant(column);
      if (sign(c) <= 0) return std::nullopt;
      const auto& ray = pool_.exact(*cell_.ray(rays[a]));
      for (std::size_t i = 0; i < 6; ++i) point[i] += c * ray[i];
    }
    return pool_.add(Role::kRay, point)->approximate().x;
  }

  static BigInteger determinant(const std::vector<std::vector<BigInteger>>& m) {
    const std::size_t k = m.size();
    if (k == 1) return m[0][0];
    BigInteger sum(0);
    for (std::size_t column = 0; column < k; ++column) {
      std::vector<std::vector<BigInteger>> minor;
      for (std::size_t row = 1; row < k; ++row) {
        minor.push_back(m[row]);
        minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(column));
      }
      const BigInteger term = m[0][column] * determinant(minor);
      sum += column % 2 == 0 ? term : -term;
    }
    return sum;
  }

  LinePool& pool_;
  const LineCell& cell_;
  int wanted_;
  std::size_t n_;
  std::vector<int> form_;  // signs of h
};

}  // namespace

std::optional<RealLineBracket> find_real_lines(LinePool& pool, const LineCell& cell) {
  const std::size_t n = cell.size();
  std::optional<Components> positive, negative;
  const auto note = [&](double value, double bound, const Components& a, const Components* b) {
    if (!(std::fabs(value) > bound)) return;
    auto& found = value > 0 ? positive : negative;
    if (found) return;
    found = a;
    if (b == nullptr) return;
    for (std::size_t i = 0; i < 6; ++i) (*found)[i] += (*b)[i];
  };
  for (std::size_t i = 0; i < n; ++i) {
    const auto q = LinePool::product<3>(*cell.ray(i), *cell.ray(i));
    note(q.value, q.bound, cell.ray(i)->approximate().x, nullptr);
  }
  // q(x + y) = q(x) + 2 b(x, y) + q(y); the bounds add up, and so does a rounding of each sum.
  for (std::size_t i = 0; i < n && !(positive && negative); ++i) {
    const auto qi = LinePool::product<3>(*cell.ray(i), *cell.ray(i));
    for (std::size_t j = 0; j < i && !(positive && negative); ++j) {
      const auto qj = LinePool::product<3>(*cell.ray(j), *cell.ray(j));
      const auto b = LinePool::product<3>(*cell.ray(i), *cell.ray(j));
      const double value = qi.value + 2 * b.value + qj.value;
      const double bound = 2 * (qi.bound + 2 * b.bound + qj.bound);
      note(value, bound, cell.ray(i)->approximate().x, &cell.ray(j)->approximate().x);
    }
  }
  if (!positive) positive = SignSearch(pool, cell, 1).run();
  if (!positive) return std::nullopt;
  if (!negative) negative = SignSearch(pool, cell, -1).run();
  if (!negative) return std::nullopt;
  return RealLineBracket{*positive, *negative};
}

bool takes_sign(LinePool& pool, const LineCell& cell, int sign) {
  return SignSearch(pool, cell, sign).run().has_value();
}

}  // namespace viewcover::exact
