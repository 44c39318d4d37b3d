#include <algorithm>

#include "exact/skeleton/sorted_lists.h"
#include "exact/skeleton/swath_search.h"

namespace viewcover::exact {
namespace {

std::size_t bits(const LineComponents& line) {
  std::size_t most = 0;
  for (const BigInteger& x : line) most = std::max(most, mpz_sizeinbase(x.mpz(), 2));
  return most;
}

LineComponents combined(const BigInteger& s, const LineComponents& a, const BigInteger& t,
                        const LineComponents& b) {
  LineComponents sum;
  for (std::size_t k = 0; k < 6; ++k) sum[k] = s * a[k] + t * b[k];
  return sum;
}

}  // namespace

/// A line of the pencil of two lines, between them and not far from the middle.
StabbingLine SwathSearch::mean(const StabbingLine& a, const StabbingLine& b) const {
  const std::size_t of_a = bits(a.a), of_b = bits(b.a), most = std::max(of_a, of_b);
  BigInteger s, t;
  mpz_setbit(s.mpz(), most - of_a);
  mpz_setbit(t.mpz(), most - of_b);
  return arithmetic_.line(combined(s, a.a, t, b.a));
}

bool SwathSearch::add_zero(const StabbingLine& a, const StabbingLine& b,
                           const LineVector& functional) {
  if (arithmetic_.sign(a, functional) * arithmetic_.sign(b, functional) >= 0) return false;
  const auto& f = arithmetic_.pool().exact(functional);
  BigInteger at_a(0), at_b(0);
  for (std::size_t k = 0; k < 6; ++k) {
    at_a += a.a[k] * f[k];
    at_b += b.a[k] * f[k];
  }
  return add(arithmetic_.line(combined(CGAL::abs(at_b), a.a, CGAL::abs(at_a), b.a)));
}

/// On a pencil functionals are linear. What is touched changes with
///  - edges of a face, unless two of them have opposite signs on all lines: then all miss it
///  - in a face's plane, with its corners, and with crossings
///  - planes of edges through the pencil's point
bool SwathSearch::add_zeros_in_pencil(const Key& key, const StabbingLine& a,
                                      const StabbingLine& b) {
  bool found = false;
  const auto signs = [&](const LineVector* functional) {
    return std::pair(arithmetic_.sign(a, *functional), arithmetic_.sign(b, *functional));
  };
  for (const FeatureFace& face : features_.faces()) {
    bool positive = false, negative = false, in_plane = true;
    std::vector<const LineVector*> changing;
    for (std::size_t k = 0; k < face.lines.size() && !(positive && negative); ++k) {
      const auto [at_a, at_b] = signs(face.lines[k]);
      if (at_a == 0 && at_b == 0) continue;
      in_plane = false;
      positive |= at_a >= 0 && at_b >= 0;
      negative |= at_a <= 0 && at_b <= 0;
      if (at_a * at_b < 0 && face.edges[k] != kNone) changing.push_back(face.lines[k]);
    }
    if (positive && negative) continue;
    if (in_plane) changing = face.normals;
    for (const LineVector* functional : changing) found |= add_zero(a, b, *functional);
  }
  for (const std::size_t p : features_.crossings()) {
    const FeaturePoint& crossing = features_.points()[p];
    for (const LineVector* functional : crossing.star) found |= add_zero(a, b, *functional);
  }
  if (key.kind == Kind::kPointAndEdge || key.kind == Kind::kPointAndPlane) {
    for (const EdgePair& pair : features_.points()[key.features[0]].pairs) {
      found |= add_zero(a, b, *pair.plane);
    }
  }
  return found;
}

/// On a regulus functionals are quadratic. What is touched changes with edges of a face, unless two
/// of them have opposite signs on all lines. An edge touched at both ends of the interval has its
/// two zeros there.
bool SwathSearch::add_zeros_in_regulus(const Group& group, const Entry& from, const Entry& to) {
  const Regulus& regulus = *group.regulus;
  const Regulus::Interval interval(from.place, to.place);
  const auto closed_from = nodes_[from.node].closed_edges, closed_to = nodes_[to.node].closed_edges;
  bool found = false;
  for (const FeatureFace& face : features_.faces()) {
    bool positive = false, negative = false;
    std::vector<std::size_t> unsure;
    for (std::size_t k = 0; k < face.lines.size() && !(positive && negative); ++k) {
      const int sign = regulus.sign_on(interval, *face.lines[k]);
      positive |= sign > 0;
      negative |= sign < 0;
      if (sign == 0 && face.edges[k] != kNone) unsure.push_back(k);
    }
    if (positive && negative) continue;
    for (const std::size_t k : unsure) {
      const bool at_low = contains(closed_from, face.edges[k]),
                 at_high = contains(closed_to, face.edges[k]);
      if (at_low && at_high) continue;
      const LineVector& functional = *face.lines[k];
      if (at_low != at_high && regulus.has_no_other_zero(interval, functional, at_low)) continue;
      for (StabbingLine& line : regulus.zeros(arithmetic_, interval, functional)) {
        found |= add(std::move(line));
      }
    }
  }
  return found;
}

}  // namespace viewcover::exact
