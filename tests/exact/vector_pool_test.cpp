#include "exact/vector_pool.h"

#include <gtest/gtest.h>

#include "exact/double_description.h"
#include "exact/real_lines.h"
#include "scene/random_numbers.h"

namespace viewcover::exact {
namespace {

constexpr std::uint64_t kSeed = 7;

using Big6 = std::array<BigInteger, 6>;

/// Components of up to `bits` bits, a quarter of them 0.
Big6 random_components(int bits, RandomNumbers& random) {
  Big6 components;
  for (BigInteger& x : components) {
    x = BigInteger(0);
    if (random.below(4) == 0) continue;
    for (int done = 0; done < bits; done += 30) {
      x = x * BigInteger(1 << 30) + BigInteger(static_cast<int>(random.below(1 << 30)));
    }
    if (random.below(2) == 0) x = -x;
  }
  if (std::all_of(components.begin(), components.end(),
                  [](const BigInteger& x) { return sign(x) == 0; })) {
    components[0] = BigInteger(1);
  }
  return components;
}

/// Is each double within its bound of one positive multiple of the exact component? Checked in
/// cross products, which need no division.
void expect_close(VectorPool<6>& pool, const LazyVector<6>& vector) {
  const auto& a = vector.approximate();
  const Big6 exact = pool.exact(vector);
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 6; ++i) {
    if (std::fabs(a.x[i]) > std::fabs(a.x[largest])) largest = i;
  }
  const CGAL::Gmpq factor = CGAL::Gmpq(a.x[largest]) / CGAL::Gmpq(exact[largest], BigInteger(1));
  EXPECT_GT(factor, 0);
  for (std::size_t i = 0; i < 6; ++i) {
    const CGAL::Gmpq off =
        CGAL::abs(CGAL::Gmpq(a.x[i]) - factor * CGAL::Gmpq(exact[i], BigInteger(1)));
    // The factor itself may be off by the error of the largest component, which is at least 1/2.
    EXPECT_LE(off, CGAL::Gmpq(3 * a.error + 1e-300)) << i;
  }
}

TEST(VectorPool, ApproximationsAreWithinTheirBounds) {
  ExactStatistics statistics;
  int inexact = 0;
  for (std::uint64_t trial = 0; trial < 2000; ++trial) {
    SCOPED_TRACE(trial);
    RandomNumbers random(mixed(kSeed + trial));
    VectorPool<6> pool(statistics);
    const int bits = std::array{30, 60, 90, 150, 300}[trial % 5];
    std::vector<const LazyVector<6>*> vectors;
    for (int i = 0; i < 3; ++i) {
      vectors.push_back(pool.add(Role::kRay, random_components(bits, random)));
    }
    const LazyVector<6>* const cut = pool.add(Role::kFunctional, random_components(bits, random));
    for (int step = 0; step < 12; ++step) {
      const LazyVector<6>*first = vectors[random.below(vectors.size())],
            *second = vectors[random.below(vectors.size())];
      const LazyVector<6>* const functional =
          step % 2 == 0 ? cut : pool.add(Role::kFunctional, random_components(bits, random));
      const int side = pool.sign_of_product(*first, *functional);
      if (side == 0) continue;
      if (side < 0) first = pool.negated(first);
      const LazyVector<6>* const made = pool.combine(first, second, functional);
      if (VectorPool<6>::is_zero(*made)) continue;
      EXPECT_EQ(pool.sign_of_product(*made, *functional), 0);
      vectors.push_back(made);
    }
    for (const LazyVector<6>* vector : vectors) {
      inexact += vector->approximate().error > 0;
      expect_close(pool, *vector);
    }
  }
  EXPECT_GT(inexact, 1000);
}

TEST(VectorPool, SignsAreThoseOfTheExactProductsOnEveryLevel) {
  ExactStatistics statistics;
  std::array<int, 3> occurred{};
  for (std::uint64_t trial = 0; trial < 3000; ++trial) {
    SCOPED_TRACE(trial);
    RandomNumbers random(mixed(kSeed ^ (trial << 20)));
    VectorPool<6> pool(statistics);
    const int bits = std::array{20, 60, 120, 200}[trial % 4];
    const LazyVector<6>* const a = pool.add(Role::kRay, random_components(bits, random));
    const LazyVector<6>* const b = pool.add(Role::kRay, random_components(bits, random));
    const LazyVector<6>* const f = pool.add(Role::kFunctional, random_components(bits, random));
    // On the functional, and a little off it to either side.
    const LazyVector<6>* first = a;
    const int side = pool.sign_of_product(*a, *f);
    if (side == 0) continue;
    if (side < 0) first = pool.negated(a);
    const LazyVector<6>* const on = pool.combine(first, b, f);
    if (VectorPool<6>::is_zero(*on)) continue;
    const Big6 exact_on = pool.exact(*on), exact_f = pool.exact(*f);
    for (const int step : {-1, 0, 1}) {
      Big6 moved = exact_on;
      for (std::size_t i = 0; i < 6; ++i) {
        moved[i] = moved[i] * BigInteger(1 << 30) + BigInteger(step) * exact_f[i];
      }
      const LazyVector<6>* const x = pool.add(Role::kRay, moved);
      BigInteger product(0);
      for (std::size_t i = 0; i < 6; ++i) product += moved[i] * exact_f[i];
      EXPECT_EQ(pool.sign_of_product(*x, *f), sign(product));
      EXPECT_EQ(sign(product), step);
      ++occurred[static_cast<std::size_t>(step + 1)];
    }
  }
  for (const int count : occurred) EXPECT_GT(count, 1000);
  EXPECT_GT(statistics.filtered_signs, 1000u);
  EXPECT_GT(statistics.fixed_width_signs, 10u);
  EXPECT_GT(statistics.quad_signs, 100u);
  EXPECT_GT(statistics.big_integer_signs, 100u);
}

TEST(DoubleDescription, FacetsOfRandomConesHoldTheirGeneratorsExactly) {
  ExactStatistics statistics;
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    RandomNumbers random(mixed(kSeed + 31 * trial));
    VectorPool<6> pool(statistics);
    // Small coordinates on one side of a hyperplane: many coincidences, and a pointed cone.
    std::vector<const LazyVector<6>*> generators;
    for (int i = 0; i < 12; ++i) {
      std::array<Wide, 6> x;
      for (Wide& component : x) component = static_cast<Wide>(random.below(5)) - 2;
      x[0] = 3;
      generators.push_back(pool.add(Role::kRay, x));
    }
    const auto cone = cone_of<6>(pool, generators);
    if (!cone) continue;
    std::size_t facets = 0;
    for (std::size_t f = 0; f < cone->facets().size(); ++f) {
      const LazyVector<6>* const facet = cone->facets()[f];
      if (facet == nullptr) continue;
      ++facets;
      int tight = 0;
      for (const LazyVector<6>* generator : generators) {
        EXPECT_GE(pool.sign_of_product(*generator, *facet), 0);
      }
      for (std::size_t i = 0; i < cone->size(); ++i) {
        const int side = pool.sign_of_product(*cone->ray(i), *facet);
        EXPECT_EQ(side == 0, cone->is_tight(i, f));
        tight += side == 0;
      }
      EXPECT_GE(tight, 5);
    }
    EXPECT_GE(facets, 6u);
    // Each ray is extreme: the facets tight at it are tight at no other ray.
    for (std::size_t i = 0; i < cone->size(); ++i) {
      for (std::size_t j = 0; j < cone->size(); ++j) {
        if (i == j) continue;
        bool contained = true;
        for (std::size_t f = 0; f < cone->facets().size(); ++f) {
          contained = contained && (!cone->is_tight(i, f) || cone->is_tight(j, f));
        }
        EXPECT_FALSE(contained);
      }
    }
  }
}

/// A cell whose rays are given, with no facets known: as many as the test for real lines needs.
LineCell cell_of(LinePool& pool, const std::vector<std::array<Wide, 6>>& rays) {
  std::vector<const LineVector*> generators;
  for (const auto& ray : rays) generators.push_back(pool.add(Role::kRay, ray));
  return *cone_of<6>(pool, generators);
}

TEST(RealLines, OfConesRoundAVectorAreFoundByItsSurroundings) {
  // Directions m = d have d . m > 0, m = -d the opposite: e_i + e_(i+3) and e_i - e_(i+3).
  ExactStatistics statistics;
  LinePool pool(statistics);
  const auto axis = [](int i, int m) {
    std::array<Wide, 6> x{};
    x[static_cast<std::size_t>(i)] = 1;
    x[static_cast<std::size_t>(i) + 3] = m;
    return x;
  };
  std::vector<std::array<Wide, 6>> rays = {axis(0, 1), axis(1, 1), axis(2, 1),
                                           axis(0, 2), axis(1, 2), axis(2, 2)};
  EXPECT_FALSE(find_real_lines(pool, cell_of(pool, rays)).has_value());  // the form is > 0 on it
  rays.push_back(axis(2, -1));
  EXPECT_TRUE(find_real_lines(pool, cell_of(pool, rays)).has_value());
  // Real lines on the boundary only: all rays have form 0 and none of the pairs a negative one.
  rays = {axis(0, 0), axis(1, 0), axis(2, 0)};
  for (int i = 0; i < 3; ++i) {
    std::array<Wide, 6> moment{};
    moment[static_cast<std::size_t>(i) + 3] = 1;
    rays.push_back(moment);
  }
  EXPECT_FALSE(find_real_lines(pool, cell_of(pool, rays)).has_value());
}

TEST(RealLines, AreFoundInsideFacesWherePairsShowNone) {
  // h = [[1, -c, -c], [-c, 1, -c], [-c, -c, 1]] with 1/2 < c < 1 is negative only inside its
  // triangle. Realized on three rays by d . m with the other three rays far on the positive side.
  ExactStatistics statistics;
  LinePool pool(statistics);
  const auto cell_for = [&](int numerator) {
    // d_i = e_i; m_i solves d_i . m_j + m_i . d_j = 2 h_ij (times 10).
    std::vector<std::array<Wide, 6>> rays;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<Wide, 6> x{};
      x[i] = 1;
      for (std::size_t j = 0; j < 3; ++j) x[j + 3] = i == j ? 10 : -numerator;
      rays.push_back(x);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<Wide, 6> x{};
      for (std::size_t j = 0; j < 3; ++j) x[j] = 1;
      x[i + 3] = 1000;
      for (std::size_t j = 0; j < 3; ++j) x[j + 3] += 100;
      rays.push_back(x);
    }
    return cell_of(pool, rays);
  };
  EXPECT_TRUE(find_real_lines(pool, cell_for(6)).has_value());
  EXPECT_FALSE(find_real_lines(pool, cell_for(5)).has_value());  // 0 at the centre: touches only
  EXPECT_FALSE(find_real_lines(pool, cell_for(4)).has_value());
}

}  // namespace
}  // namespace viewcover::exact
