#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "exact/integers.h"
#include "exact/statistics.h"
#include "scene/small_list.h"

namespace viewcover::exact {

/// IEEE binary128, in software: 113 bits.
__extension__ using Quad = __float128;

/// What a vector is: a point of the space that cones live in, or a linear functional on it.
enum class Role : std::uint8_t { kRay, kFunctional };

/// Floating-point components of a vector, and how well they are known: for some factor f > 0 each
/// is within `error` of f times the exact one. The largest magnitude is in [1/2, 1).
template <int D, class Float>
struct Approximation {
  std::array<Float, D> x;
  double error = 0;
  double size = 0;  ///< no less than the sum of the magnitudes
};

/// A vector with integer components, known up to a positive factor: a ray of a cone, or a linear
/// functional on such rays.
///
/// It is held as doubles with an error bound, and in more precise forms once somebody needed them.
template <int D>
class LazyVector {
 public:
  /// In the pool's unit of length, see `VectorPool::set_unit`.
  const Approximation<D, double>& approximate() const { return approximate_; }
  /// Points that the line passes through, as bits: see `VectorPool::add`. All lines through one
  /// point are real, meet each other, and so do their combinations.
  std::uint64_t points() const { return points_; }

 private:
  template <int>
  friend class VectorPool;

  void reset() {
    points_ = 0;
    zeros_.clear();
    negated_ = false;
    exact_ = Exact::kUnknown;
    wide_.reset();
    quad_.reset();
    big_.reset();
  }

  enum class Exact : std::uint8_t {
    kUnknown,        // a combination
    kNotFixedWidth,  // a combination, too large for fixed width
    kFixedWidth,
    kWide,  // given, not divided by its gcd yet
    kBig
  };

  Approximation<D, double> approximate_;
  // Where the vector comes from, unless it was given: (first . cut) second - (second . cut) first,
  // or minus that, with first . cut > 0.
  const LazyVector* first_ = nullptr;
  const LazyVector* second_ = nullptr;
  const LazyVector* cut_ = nullptr;
  std::uint64_t points_ = 0;
  SmallList<const LazyVector*, 4> zeros_;  // some of what the scalar product with is known to be 0
  bool negated_ = false;
  Role role_ = Role::kRay;
  Exact exact_ = Exact::kUnknown;
  std::array<std::int64_t, D> fixed_;  // magnitudes below 2^62
  std::unique_ptr<std::array<Wide, D>> wide_;
  std::unique_ptr<Approximation<D, Quad>> quad_;
  std::unique_ptr<std::array<BigInteger, D>> big_;
};

/// All vectors of one query: they live as long as the pool and refer to each other.
///
/// Signs of scalar products go through four levels: double with a proven bound, 128-bit integers
/// where the vectors fit, binary128 with the same bound, integers of any size. "Unsure" is a value
/// inside a level, never an answer. Not thread-safe: one pool a query.
template <int D>
class VectorPool {
 public:
  using Vector = LazyVector<D>;

  explicit VectorPool(ExactStatistics& statistics) : statistics_(statistics) {}
  ~VectorPool() {
    for (std::size_t i = 0; i < count_; ++i) chunks_[i / kChunk][i % kChunk].reset();
    auto& spare = spare_chunks();
    for (Chunk& chunk : chunks_) {
      if (spare.size() < kSpareChunks) spare.push_back(std::move(chunk));
    }
  }
  VectorPool(const VectorPool&) = delete;
  VectorPool& operator=(const VectorPool&) = delete;

  /// In dimension 6, where rays are lines (d, m) and functionals (m, d), floating-point forms stand
  /// for coordinates in units of 2^exponent: lengths d count 2^exponent times as much beside
  /// moments m, which are lengths squared. All scalar products change by that one factor.
  /// Components of like size keep the error bounds tight. Before the first vector.
  void set_unit(int exponent) { unit_ = std::ldexp(1.0, exponent); }

  /// A vector with the given components, a line through some of 64 points if it is one. Returns
  /// nullptr if all components are 0.
  template <class Number>
  const Vector* add(Role role, const std::array<Number, D>& components, std::uint64_t points = 0) {
    if (std::all_of(components.begin(), components.end(),
                    [](const Number& x) { return sign(x) == 0; })) {
      return nullptr;
    }
    Vector& vector = new_vector(role);
    vector.points_ = points;
    set_exact(vector, components);
    approximate_from_exact(vector);
    return &vector;
  }

  /// (first . cut) second - (second . cut) first: the combination on which `cut` vanishes. Requires
  /// first . cut > 0. It is a positive combination iff second . cut <= 0.
  const Vector* combine(const Vector* first, const Vector* second, const Vector* cut) {
    Vector& result = new_vector(first->role_);
    result.points_ = first->points_ & second->points_;
    for (const Vector* zero : first->zeros_) {
      if (is_known_zero(*second, *zero)) result.zeros_.push_back(zero);
    }
    result.first_ = first;
    result.second_ = second;
    result.cut_ = cut;
    if (!combine(first->approximate_, second->approximate_, cut->approximate_, kUnit, kCoarse,
                 result.approximate_)) {
      sharpen(result);
    }
    return &result;
  }

  /// Are all components 0? Exact: what may be 0 was computed exactly.
  static bool is_zero(const Vector& vector) { return vector.approximate_.size == 0; }

  /// The opposite vector.
  const Vector* negated(const Vector* vector) {
    Vector& result = new_vector(vector->role_);
    result.first_ = vector->first_;
    result.second_ = vector->second_;
    result.cut_ = vector->cut_;
    result.negated_ = !vector->negated_;
    result.exact_ = vector->exact_;
    result.approximate_ = vector->approximate_;
    for (double& x : result.approximate_.x) x = -x;
    result.fixed_ = vector->fixed_;
    for (std::int64_t& x : result.fixed_) x = -x;
    if (vector->wide_) {
      result.wide_ = std::make_unique<std::array<Wide, D>>(*vector->wide_);
      negate(*result.wide_);
    }
    if (vector->big_) {
      result.big_ = std::make_unique<std::array<BigInteger, D>>(*vector->big_);
      negate(*result.big_);
    }
    return &result;
  }

  /// Sign of the polar form of the Klein form on two lines (d, m) in dimension 6: the scalar
  /// product with d and m exchanged in one of them. 0 iff real lines meet.
  int sign_of_polar_form(const Vector& a, const Vector& b) {
    if ((a.points_ & b.points_) != 0) return 0;
    return sign_of_product<3>(a, b);
  }

  /// Sign of the scalar product, exact; with Shift, of the sum of a_i b_(i + Shift mod D).
  template <int Shift = 0>
  int sign_of_product(const Vector& a, const Vector& b) {
    const auto [value, bound] = product<Shift>(a, b);
    if (std::fabs(value) > bound) {
      ++statistics_.filtered_signs;
      return value > 0 ? 1 : -1;
    }
    return exact_sign<Shift>(a, b);
  }

  /// The scalar product of two approximations and a bound on its error, for factors > 0 that go
  /// with the two.
  template <class Float>
  struct Product {
    Float value;
    double bound;
  };
  template <int Shift = 0>
  static Product<double> product(const Vector& a, const Vector& b) {
    return product<Shift>(a.approximate_, b.approximate_, kUnit);
  }
  /// The bound, for a floating-point type with unit roundoff u.
  ///
  /// Let a' = a + x, b' = b + y be exact multiples, |x_i| <= ea, |y_i| <= eb. Then
  /// |a'.b' - a.b| <= ea |b|_1 + eb |a|_1 + D ea eb. Evaluating a.b in any order with D <= 6
  /// products errs by at most 6 u / (1 - 6 u) sum |a_i b_i| <= 6.01 u |a|_1, as |b_i| <= 1 (Higham
  /// 2002, section 3.1); underflow adds less than 0.01 u |a|_1, for |a|_1 >= 1/2. The bound itself
  /// is computed in double with fewer than 10 roundings, which kRoundUp covers.
  static double bound(double a_size, double a_error, double b_size, double b_error, double u) {
    return kRoundUp * (a_size * (7 * u + b_error) + a_error * (b_size + D * b_error));
  }
  static constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
  static constexpr double kRoundUp = 1 + 16 * kUnit;

  /// Remembers that the scalar product is 0. It then is for combinations of such vectors too.
  void note_zero(const Vector& vector, const Vector& functional) {
    writable(vector).zeros_.push_back(&functional);
  }
  static bool is_known_zero(const Vector& vector, const Vector& functional) {
    return std::find(vector.zeros_.begin(), vector.zeros_.end(), &functional) !=
           vector.zeros_.end();
  }

  /// Makes the doubles as good as doubles can be; true if they were not.
  bool sharpen(const Vector& vector) {
    if (vector.approximate_.error <= 4 * kUnit) return false;
    sharpen(writable(vector));
    return true;
  }

  /// The sign where the filter was not sure.
  template <int Shift = 0>
  int exact_sign(const Vector& a, const Vector& b) {
    if (is_fixed(a) && is_fixed(b)) {
      ++statistics_.fixed_width_signs;
      return sign(fixed_product<Shift>(a, b));
    }
    if (a.exact_ != Vector::Exact::kBig || b.exact_ != Vector::Exact::kBig) {
      const auto [value, bound] = product<Shift>(quad(a), quad(b), kQuadUnit);
      if (magnitude(value) > bound) {
        ++statistics_.quad_signs;
        return value > 0 ? 1 : -1;
      }
    }
    ++statistics_.big_integer_signs;
    return sign(exact_product<Shift>(a, b));
  }

  /// The exact components, as big integers.
  const std::array<BigInteger, D>& exact(const Vector& vector) {
    if (!vector.big_) make_big(writable(vector));
    return *vector.big_;
  }
  /// The scalar product of the exact components.
  template <int Shift = 0>
  BigInteger exact_product(const Vector& a, const Vector& b) {
    const auto &x = exact(a), &y = exact(b);
    BigInteger sum(0);
    for (std::size_t i = 0; i < D; ++i) sum += x[i] * y[(i + Shift) % D];
    return sum;
  }

  ExactStatistics& statistics() { return statistics_; }

 private:
  static constexpr double kQuadUnit = 0x1p-113;
  // A vector known less well than this is computed more precisely at once: what is built on it
  // would soon be known to no digit.
  static constexpr double kCoarse = 0x1p-10;
  static constexpr double kQuadCoarse = 0x1p-30;
  static constexpr int kFixedBits = 62;

  template <int Shift, class Float>
  static Product<Float> product(const Approximation<D, Float>& a, const Approximation<D, Float>& b,
                                double u) {
    Float value = 0;
    for (std::size_t i = 0; i < D; ++i) value += a.x[i] * b.x[(i + Shift) % D];
    return {value, bound(a.size, a.error, b.size, b.error, u)};
  }

  static double magnitude(double x) { return std::fabs(x); }
  static double magnitude(Quad x) { return static_cast<double>(x < 0 ? -x : x); }

  /// False, with `result` unusable, if it would not be known to `coarse`.
  ///
  /// Let p' = p + x and n' = n + y be exact multiples of `first` and `second`, and a' = a + da,
  /// b' = b + db their exact coefficients, |x| <= ep, |y| <= en, |da| <= Ba, |db| <= Bb. Two bounds
  /// hold for the error of a p + b n:
  ///  (1) Ba (|p| + ep) + Bb (|n| + en) + |a| ep + |b| en, against a' p' + b' n';
  ///  (2) where S = a + b > Ba + Bb, with L = a / S and L' = a' / S', against (S / S') (a' p' + b'
  ///  n'):
  ///      S |L (p' - p) + (1 - L) (n' - n) + (L' - L) (p' - n')|, and as L' - L = (da b - db a) /
  ///      (S S'), it is at most |a| ep + |b| en + (Ba |b| + Bb |a|) (|p - n| + ep + en) / (S - Ba -
  ///      Bb).
  /// The second keeps errors small in small cells, where p and n are nearly parallel: it holds for
  /// n / t and b t in place of n and b too, where t makes them of the same length. To either the
  /// rounding of two products and a difference is added, 3 u (|a| + |b|).
  template <class Float>
  static bool combine(const Approximation<D, Float>& first, const Approximation<D, Float>& second,
                      const Approximation<D, Float>& cut, double u, double coarse,
                      Approximation<D, Float>& result) {
    const Product<Float> f = product<0>(first, cut, u), s = product<0>(second, cut, u);
    Float largest = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < D; ++i) {
      result.x[i] = f.value * second.x[i] - s.value * first.x[i];
      const Float size = result.x[i] < 0 ? -result.x[i] : result.x[i];
      if (size > largest) {
        largest = size;
        at = i;
      }
    }
    const double a = -static_cast<double>(s.value), b = static_cast<double>(f.value);
    const double rounding = 3 * u * (std::fabs(a) + std::fabs(b));
    const double carried = std::fabs(a) * first.error + std::fabs(b) * second.error;
    double error = s.bound * (1 + first.error) + f.bound * (1 + second.error);
    double t = static_cast<double>(second.x[at]) / static_cast<double>(first.x[at]);
    if (!(t > 0.25 && t < 4)) t = 1;
    const double sum = a + b * t - s.bound - f.bound * t;
    if (sum > 0x1p-20 * (std::fabs(a) + std::fabs(b * t))) {
      double apart = 0;
      for (std::size_t i = 0; i < D; ++i) {
        apart = std::max(apart, magnitude(first.x[i] - second.x[i] / t));
      }
      // The difference is rounded: u for the quotient, u for the difference.
      apart += first.error + second.error / t + 8 * u;
      const double turn = s.bound * std::fabs(b * t) + f.bound * t * std::fabs(a);
      error = std::min(error, kRoundUp * turn / sum * apart);
    }
    result.error = kRoundUp * (error + carried + rounding);
    if (!(result.error < coarse * magnitude(largest))) return false;
    normalize(result, magnitude(largest));
    return true;
  }

  template <class Float>
  static void normalize(Approximation<D, Float>& v, double largest) {
    int exponent = 0;
    std::frexp(largest, &exponent);
    const double scale = std::ldexp(1.0, -exponent);
    v.size = 0;
    for (Float& x : v.x) {
      x *= scale;
      v.size += magnitude(x);
    }
    v.size *= kRoundUp;
    v.error *= scale;
  }

  // Vectors are handed out as const; what is lazy about them changes here.
  static Vector& writable(const Vector& vector) { return const_cast<Vector&>(vector); }  // NOLINT

  /// Better doubles for a vector that its parents' doubles leave open.
  void sharpen(Vector& v) {
    if (!is_fixed(v)) {
      // At least as good as kQuadCoarse: what is not was computed exactly.
      const Approximation<D, Quad>& precise = quad(v);
      double largest = 0;
      for (std::size_t i = 0; i < D; ++i) {
        v.approximate_.x[i] = static_cast<double>(precise.x[i]);
        largest = std::max(largest, std::fabs(v.approximate_.x[i]));
      }
      v.approximate_.error = kRoundUp * (precise.error + kUnit);
      normalize(v.approximate_, largest);
      return;
    }
    approximate_from_exact(v);
  }

  /// Does the vector fit fixed width? Finds out, once.
  bool is_fixed(const Vector& vector) {
    if (vector.exact_ == Vector::Exact::kUnknown) make_fixed(writable(vector));
    if (vector.exact_ == Vector::Exact::kWide) reduce(writable(vector));
    return vector.exact_ == Vector::Exact::kFixedWidth;
  }

  /// Divides what was given by its gcd: mostly nobody asks for more than doubles.
  void reduce(Vector& v) {
    const std::unique_ptr<std::array<Wide, D>> given = std::move(v.wide_);
    divide_by_gcd(*given);
    if (std::all_of(given->begin(), given->end(), fits)) {
      set_fixed(v, *given);
      return;
    }
    v.exact_ = Vector::Exact::kBig;
    v.big_ = std::make_unique<std::array<BigInteger, D>>();
    for (std::size_t i = 0; i < D; ++i) (*v.big_)[i] = to_big((*given)[i]);
  }

  void make_fixed(Vector& v) {
    v.exact_ = Vector::Exact::kNotFixedWidth;
    if (!is_fixed(*v.first_) || !is_fixed(*v.second_) || !is_fixed(*v.cut_)) return;
    Wide f = fixed_product(*v.first_, *v.cut_), s = fixed_product(*v.second_, *v.cut_);
    const Wide common = gcd(f, s);
    f /= common;
    s /= common;
    if (!fits(f) || !fits(s)) return;
    std::array<Wide, D> components;
    for (std::size_t i = 0; i < D; ++i) {
      components[i] = f * v.second_->fixed_[i] - s * v.first_->fixed_[i];
    }
    divide_by_gcd(components);
    if (!std::all_of(components.begin(), components.end(), fits)) return;
    if (v.negated_) negate(components);
    set_fixed(v, components);
  }

  void make_big(Vector& v) {
    if (v.exact_ == Vector::Exact::kWide) reduce(v);
    if (v.big_) return;
    std::array<BigInteger, D> components;
    if (v.exact_ == Vector::Exact::kFixedWidth) {
      for (std::size_t i = 0; i < D; ++i) components[i] = to_big(v.fixed_[i]);
      v.big_ = std::make_unique<std::array<BigInteger, D>>(components);
      return;
    }
    BigInteger f = exact_product(*v.first_, *v.cut_), s = exact_product(*v.second_, *v.cut_);
    const BigInteger common = gcd(f, s);
    f = divided(f, common);
    s = divided(s, common);
    const auto &a = exact(*v.first_), &b = exact(*v.second_);
    for (std::size_t i = 0; i < D; ++i) components[i] = f * b[i] - s * a[i];
    divide_by_gcd(components);
    if (v.negated_) negate(components);
    set_exact(v, components);
    if (!v.big_) v.big_ = std::make_unique<std::array<BigInteger, D>>(components);
  }

  const Approximation<D, Quad>& quad(const Vector& vector) {
    if (!vector.quad_) make_quad(writable(vector));
    return *vector.quad_;
  }

  void make_quad(Vector& v) {
    v.quad_ = std::make_unique<Approximation<D, Quad>>();
    if (v.exact_ == Vector::Exact::kUnknown || v.exact_ == Vector::Exact::kNotFixedWidth) {
      if (combine(quad(*v.first_), quad(*v.second_), quad(*v.cut_), kQuadUnit, kQuadCoarse,
                  *v.quad_)) {
        if (v.negated_) {
          for (Quad& x : v.quad_->x) x = -x;
        }
        return;
      }
      make_big(v);
    }
    if (v.exact_ == Vector::Exact::kFixedWidth || v.exact_ == Vector::Exact::kWide) {
      double largest = 0;
      for (std::size_t i = 0; i < D; ++i) {
        const Wide x = v.wide_ ? (*v.wide_)[i] : v.fixed_[i];
        v.quad_->x[i] = static_cast<Quad>(x) * weight(v.role_, i);
        largest = std::max(largest, magnitude(v.quad_->x[i]));
      }
      v.quad_->error = v.wide_ ? kQuadUnit * largest : 0;
      normalize(*v.quad_, largest);
    } else {
      approximate_from_big(v, *v.quad_, kQuadUnit);
    }
  }

  static bool fits(Wide x) { return x < (Wide{1} << kFixedBits) && -x < (Wide{1} << kFixedBits); }

  // Magnitudes below 2^62: six products fit 2^(124 + 2.6).
  template <int Shift = 0>
  static Wide fixed_product(const Vector& a, const Vector& b) {
    Wide sum = 0;
    for (std::size_t i = 0; i < D; ++i) sum += Wide{a.fixed_[i]} * b.fixed_[(i + Shift) % D];
    return sum;
  }

  template <class Number>
  static void negate(std::array<Number, D>& components) {
    for (Number& x : components) x = -x;
  }
  static Wide divided(Wide x, Wide by) { return x / by; }
  static BigInteger divided(const BigInteger& x, const BigInteger& by) {
    BigInteger quotient;
    mpz_divexact(quotient.mpz(), x.mpz(), by.mpz());
    return quotient;
  }
  template <class Number>
  static void divide_by_gcd(std::array<Number, D>& x) {
    Number common(0);
    for (const Number& value : x) {
      common = gcd(common, value);
      if (common == Number(1)) return;
    }
    if (sign(common) == 0) return;
    for (Number& value : x) value = divided(value, common);
  }

  static Wide wide(Wide x) { return x; }
  static Wide wide(CheckedWide x) { return x.value(); }

  template <class Number>
  void set_exact(Vector& vector, const std::array<Number, D>& components) {
    std::array<Wide, D> wide_components;
    if constexpr (std::is_same_v<Number, BigInteger>) {
      for (std::size_t i = 0; i < D; ++i) {
        if (mpz_sizeinbase(components[i].mpz(), 2) > kFixedBits) {
          vector.exact_ = Vector::Exact::kBig;
          vector.big_ = std::make_unique<std::array<BigInteger, D>>(components);
          return;
        }
        wide_components[i] = mpz_get_si(components[i].mpz());
      }
    } else {
      for (std::size_t i = 0; i < D; ++i) wide_components[i] = wide(components[i]);
      if (!std::all_of(wide_components.begin(), wide_components.end(), fits)) {
        vector.exact_ = Vector::Exact::kWide;
        vector.wide_ = std::make_unique<std::array<Wide, D>>(wide_components);
        return;
      }
    }
    set_fixed(vector, wide_components);
  }

  static void set_fixed(Vector& vector, const std::array<Wide, D>& components) {
    vector.exact_ = Vector::Exact::kFixedWidth;
    for (std::size_t i = 0; i < D; ++i) vector.fixed_[i] = static_cast<std::int64_t>(components[i]);
  }

  void approximate_from_exact(Vector& vector) {
    if (vector.exact_ == Vector::Exact::kBig) {
      approximate_from_big(vector, vector.approximate_, kUnit);
      return;
    }
    bool rounded = false;
    double largest = 0;
    for (std::size_t i = 0; i < D; ++i) {
      const Wide given = vector.wide_ ? (*vector.wide_)[i] : vector.fixed_[i];
      const auto x = static_cast<double>(given);
      rounded = rounded || vector.wide_ || static_cast<Wide>(x) != given;
      vector.approximate_.x[i] = x * weight(vector.role_, i);
      largest = std::max(largest, std::fabs(vector.approximate_.x[i]));
    }
    vector.approximate_.error = rounded ? kUnit * largest : 0;
    normalize(vector.approximate_, largest);
  }

  template <class Float>
  void approximate_from_big(const Vector& vector, Approximation<D, Float>& result, double u) const {
    // Each component as a double, and for Quad what is left of it as another; exponents apart.
    std::array<long, D> exponents{};
    long highest = std::numeric_limits<long>::min();
    for (std::size_t i = 0; i < D; ++i) {
      const BigInteger& x = (*vector.big_)[i];
      result.x[i] = 0;
      if (sign(x) == 0) continue;
      const auto bits = static_cast<long>(mpz_sizeinbase(x.mpz(), 2));
      const long drop = std::max(bits - 112, 0L);
      BigInteger top;
      mpz_tdiv_q_2exp(top.mpz(), x.mpz(), static_cast<mp_bitcnt_t>(drop));
      BigInteger high;
      mpz_tdiv_q_2exp(high.mpz(), top.mpz(), 56);
      BigInteger low;
      mpz_tdiv_r_2exp(low.mpz(), top.mpz(), 56);
      result.x[i] = static_cast<Float>(mpz_get_si(high.mpz())) * static_cast<Float>(0x1p56) +
                    static_cast<Float>(mpz_get_si(low.mpz()));
      exponents[i] = drop;
      highest = std::max(highest, drop);
    }
    double largest = 0;
    for (std::size_t i = 0; i < D; ++i) {
      const long below = std::min(highest - exponents[i], 1000L);
      result.x[i] *= std::ldexp(weight(vector.role_, i), static_cast<int>(-below));
      largest = std::max(largest, magnitude(result.x[i]));
    }
    // Truncated to 112 bits, then at most three roundings; what lies 2^1000 below the largest
    // exponent is far less than that.
    result.error = (4 * u + 2 * kQuadUnit) * largest;
    normalize(result, largest);
  }

  double weight(Role role, std::size_t i) const {
    return D == 6 && (i < 3) == (role == Role::kRay) ? unit_ : 1;
  }

  Vector& new_vector(Role role) {
    if (count_ == kChunk * chunks_.size()) chunks_.push_back(take_chunk());
    Vector& vector = chunks_[count_ / kChunk][count_ % kChunk];
    vector.role_ = role;
    ++count_;
    return vector;
  }

  // Addresses stay, as vectors refer to each other. Chunks go from one query to the next of the
  // same thread.
  static constexpr std::size_t kChunk = 64, kSpareChunks = 256;
  using Chunk = std::unique_ptr<Vector[]>;
  static std::vector<Chunk>& spare_chunks() {
    thread_local std::vector<Chunk> spare;
    return spare;
  }
  static Chunk take_chunk() {
    auto& spare = spare_chunks();
    if (spare.empty()) return std::make_unique_for_overwrite<Vector[]>(kChunk);
    Chunk chunk = std::move(spare.back());
    spare.pop_back();
    return chunk;
  }

  ExactStatistics& statistics_;
  double unit_ = 1;
  std::vector<Chunk> chunks_;
  std::size_t count_ = 0;
};

}  // namespace viewcover::exact
