#include "optim/check_cover_proof.h"

#include <openssl/evp.h>

#include <algorithm>
#include <charconv>
#include <istream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace viewcover {
namespace {

__extension__ using Int128 = __int128;
using Number = std::uint64_t;

/// Numbers of the file stay below; with fewer than 2^32 rows and columns no sum of products of a
/// number with a count reaches 2^126.
constexpr Number kNumberLimit = Number{1} << 62;

struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void require(bool condition, const std::string& otherwise) {
  if (!condition) throw Refused(otherwise);
}

Number number_of(std::string_view word) {
  Number number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  require(!word.empty() && error == std::errc() && end == word.data() + word.size() &&
              number < kNumberLimit,
          "not a number below 2^62: '" + std::string(word) + "'");
  return number;
}

/// Of columns with the same rows the first, and only those that have rows: rows of each.
std::vector<std::vector<std::size_t>> canonical_columns(const BitRows& matrix) {
  std::set<std::vector<std::size_t>> seen;
  std::vector<std::vector<std::size_t>> columns;
  for (std::size_t column = 0; column < matrix.columns(); ++column) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < matrix.rows(); ++row) {
      if (matrix.test(row, column)) rows.push_back(row);
    }
    if (!rows.empty() && seen.insert(rows).second) columns.push_back(std::move(rows));
  }
  return columns;
}

/// A dual as the file has it; it belongs to the component in which it stands.
struct Dual {
  std::size_t component = 0;
  Int128 denominator = 1;
  std::vector<std::pair<std::size_t, Int128>> prices;
};

class Checker {
 public:
  Checker(const BitRows& matrix, std::istream& in)
      : in_(in),
        row_count_(matrix.rows()),
        columns_(canonical_columns(matrix)),
        columns_of_(row_count_),
        row_remains_(row_count_, true),
        column_remains_(columns_.size(), true),
        component_of_(row_count_, 0) {
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      for (const std::size_t row : columns_[column]) columns_of_[row].push_back(column);
    }
  }

  CoverProofVerdict verdict() {
    try {
      const Number bound = header();
      reductions();
      Number proved = taken_;
      while (keyword_ == "component") proved += component();
      require(keyword_ == "end" && words_.empty(), "expected 'component' or 'end'");
      require(proved == bound, "the parts prove " + std::to_string(proved) + ", not the bound " +
                                   std::to_string(bound));
      require(in_.peek() == std::istream::traits_type::eof(), "something follows 'end'");
      return {true, bound, 0, {}};
    } catch (const Refused& refused) {
      return {false, 0, line_, refused.what()};
    }
  }

 private:
  enum class Row : std::uint8_t { kFree, kChosen, kExcluded };

  void next_line() {
    std::string line;
    ++line_;
    require(static_cast<bool>(std::getline(in_, line)), "the file ends before 'end'");
    std::istringstream in(line);
    keyword_.clear();
    words_.clear();
    in >> keyword_;
    for (std::string word; in >> word;) words_.push_back(word);
  }
  void require_words(std::size_t count) const {
    require(words_.size() == count, "'" + keyword_ + "' has " + std::to_string(words_.size()) +
                                        " words after it, not " + std::to_string(count));
  }
  std::size_t index(std::string_view word, std::size_t count, const char* what) const {
    const Number number = number_of(word);
    require(number >= 1 && number <= count,
            "there is no " + std::string(what) + " " + std::to_string(number));
    return static_cast<std::size_t>(number - 1);
  }
  std::size_t row_at(std::size_t word) const { return index(words_[word], row_count_, "row"); }
  std::size_t remaining_row(std::size_t word) const {
    const std::size_t row = row_at(word);
    require(row_remains_[row], "row " + words_[word] + " is gone already");
    return row;
  }
  std::size_t remaining_column(std::size_t word) const {
    const std::size_t column = index(words_[word], columns_.size(), "column");
    require(column_remains_[column], "column " + words_[word] + " is gone already");
    return column;
  }
  bool covers(std::size_t row, std::size_t column) const {
    return std::ranges::binary_search(columns_[column], row);
  }

  Number header() {
    next_line();
    require(keyword_ == "viewcover-cover-proof" && words_ == std::vector<std::string>{"1"},
            "not a cover proof of version 1");
    next_line();
    require(keyword_ == "matrix", "expected 'matrix'");
    require_words(3);
    BitRows canonical(row_count_, columns_.size());
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      for (const std::size_t row : columns_[column]) canonical.set(row, column);
    }
    require(number_of(words_[0]) == row_count_ && number_of(words_[1]) == columns_.size() &&
                words_[2] == matrix_hash(canonical),
            "the proof is of another matrix");
    next_line();
    require(keyword_ == "bound", "expected 'bound'");
    require_words(1);
    return number_of(words_[0]);
  }

  void reductions() {
    for (next_line(); keyword_ == "column" || keyword_ == "row" || keyword_ == "take";
         next_line()) {
      require_words(2);
      if (keyword_ == "column") {
        const std::size_t column = remaining_column(0), reason = remaining_column(1);
        require(column != reason, "a column cannot imply itself");
        for (const std::size_t row : columns_[reason]) {
          require(!row_remains_[row] || covers(row, column), "row " + std::to_string(row + 1) +
                                                                 " covers column " + words_[1] +
                                                                 " but not " + words_[0]);
        }
        column_remains_[column] = false;
        continue;
      }
      const std::size_t row = remaining_row(0);
      if (keyword_ == "row") {
        const std::size_t reason = remaining_row(1);
        require(row != reason, "a row cannot stand in for itself");
        for (const std::size_t column : columns_of_[row]) {
          require(!column_remains_[column] || covers(reason, column),
                  "column " + std::to_string(column + 1) + " is covered by row " + words_[0] +
                      " but not by " + words_[1]);
        }
      } else {
        const std::size_t reason = remaining_column(1);
        require(covers(row, reason), "row " + words_[0] + " does not cover column " + words_[1]);
        for (const std::size_t other : columns_[reason]) {
          require(other == row || !row_remains_[other],
                  "row " + std::to_string(other + 1) + " covers column " + words_[1] + " too");
        }
        for (const std::size_t column : columns_of_[row]) column_remains_[column] = false;
        ++taken_;
      }
      row_remains_[row] = false;
    }
  }

  /// Returns the bound of the component; its tree proves it.
  Number component() {
    require(!words_.empty(), "a component has a bound");
    const Number bound = number_of(words_[0]);
    ++component_;
    for (std::size_t word = 1; word < words_.size(); ++word) {
      const std::size_t row = remaining_row(word);
      require(component_of_[row] == 0, "row " + words_[word] + " is in a component already");
      component_of_[row] = component_;
    }
    rows_.assign(row_count_, Row::kExcluded);
    for (std::size_t row = 0; row < row_count_; ++row) {
      if (component_of_[row] == component_) rows_[row] = Row::kFree;
    }
    times_covered_.assign(columns_.size(), 0);
    chosen_ = 0;
    next_line();
    tree(bound);
    next_line();
    return bound;
  }

  /// Reads the trees below a place one by one; open branches wait on a stack.
  void tree(Number bound) {
    struct Undo {
      std::size_t row;
      bool is_branch;  ///< the row is chosen and its other side still to come
    };
    std::vector<Undo> undo;
    for (;; next_line()) {
      if (keyword_ == "dual") {
        read_dual();
      } else if (keyword_ == "without") {
        require(!words_.empty(), "'without' needs a dual");
        const Value value = value_of(dual_at(0));
        for (std::size_t word = 1; word < words_.size(); ++word) {
          const std::size_t row = free_row(word);
          const Int128 more = std::max<Int128>(0, value.denominator - value.row_prices[row]);
          require(value.proves(bound, more), "the dual does not rule out row " + words_[word]);
          rows_[row] = Row::kExcluded;
          undo.push_back({row, false});
        }
      } else if (keyword_ == "branch") {
        require_words(1);
        const std::size_t row = free_row(0);
        choose(row, +1);
        undo.push_back({row, true});
      } else if (keyword_ == "leaf") {
        require_words(1);
        require(value_of(dual_at(0)).proves(bound, 0),
                "the dual does not prove " + std::to_string(bound));
        while (!undo.empty() && !undo.back().is_branch) {
          rows_[undo.back().row] = Row::kFree;
          undo.pop_back();
        }
        if (undo.empty()) return;
        undo.back().is_branch = false;
        choose(undo.back().row, -1);
      } else {
        throw Refused("expected 'dual', 'without', 'branch' or 'leaf'");
      }
    }
  }

  std::size_t free_row(std::size_t word) const {
    const std::size_t row = row_at(word);
    require(component_of_[row] == component_, "row " + words_[word] + " is not in the component");
    require(rows_[row] == Row::kFree, "row " + words_[word] + " is decided already");
    return row;
  }

  /// Chooses a free row (+1), or excludes a chosen one (-1).
  void choose(std::size_t row, int change) {
    rows_[row] = change > 0 ? Row::kChosen : Row::kExcluded;
    chosen_ += change;
    for (const std::size_t column : columns_of_[row]) times_covered_[column] += change;
  }

  void read_dual() {
    require(!words_.empty(), "a dual has a denominator");
    Dual dual;
    dual.component = component_;
    dual.denominator = number_of(words_[0]);
    require(dual.denominator > 0, "a denominator is not 0");
    for (std::size_t word = 1; word < words_.size(); ++word) {
      const std::size_t colon = words_[word].find(':');
      require(colon != std::string::npos, "expected COLUMN:NUMBER, not '" + words_[word] + "'");
      const std::string_view text = words_[word];
      const std::size_t column = index(text.substr(0, colon), columns_.size(), "column");
      require(column_remains_[column], "column " + std::to_string(column + 1) + " is gone already");
      require(dual.prices.empty() || dual.prices.back().first < column,
              "the columns of a dual ascend");
      for (const std::size_t row : columns_[column]) {
        require(!row_remains_[row] || component_of_[row] == component_,
                "column " + std::to_string(column + 1) + " is not of this component: row " +
                    std::to_string(row + 1) + " covers it too");
      }
      dual.prices.emplace_back(column, number_of(text.substr(colon + 1)));
    }
    duals_.push_back(std::move(dual));
  }

  const Dual& dual_at(std::size_t word) const {
    const Dual& dual = duals_[index(words_[word], duals_.size(), "dual")];
    require(dual.component == component_, "dual " + words_[word] + " is of another component");
    return dual;
  }

  struct Value {
    Int128 value, denominator;
    std::vector<Int128> row_prices;
    bool proves(Number bound, Int128 more) const {
      return bound == 0 || value + more > denominator * (Int128(bound) - 1);
    }
  };
  /// The bound of optim/cover_dual.h, written anew.
  Value value_of(const Dual& dual) const {
    Value result{dual.denominator * chosen_, dual.denominator, {}};
    result.row_prices.assign(row_count_, 0);
    for (const auto& [column, price] : dual.prices) {
      if (times_covered_[column] > 0) continue;
      result.value += price;
      for (const std::size_t row : columns_[column]) result.row_prices[row] += price;
    }
    for (std::size_t row = 0; row < row_count_; ++row) {
      if (rows_[row] == Row::kFree && result.row_prices[row] > dual.denominator) {
        result.value -= result.row_prices[row] - dual.denominator;
      }
    }
    return result;
  }

  std::istream& in_;
  std::size_t line_ = 0;
  std::string keyword_;
  std::vector<std::string> words_;

  std::size_t row_count_;
  std::vector<std::vector<std::size_t>> columns_;     ///< rows of each, ascending
  std::vector<std::vector<std::size_t>> columns_of_;  ///< of each row, ascending
  std::vector<bool> row_remains_, column_remains_;
  std::vector<std::size_t> component_of_;  ///< of a row; 0: none so far
  Number taken_ = 0;
  std::size_t component_ = 0;
  std::vector<Dual> duals_;

  std::vector<Row> rows_;           ///< at this place of the tree
  std::vector<int> times_covered_;  ///< by chosen rows
  int chosen_ = 0;
};

}  // namespace

std::string matrix_hash(const BitRows& matrix) {
  std::string text = std::to_string(matrix.rows()) + ' ' + std::to_string(matrix.columns()) + '\n';
  for (std::size_t row = 0; row < matrix.rows(); ++row) {
    const char* separator = "";
    for_each_bit(matrix.row(row), [&](std::size_t column) {
      text.append(separator).append(std::to_string(column + 1));
      separator = " ";
    });
    text += '\n';
  }
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  if (EVP_Digest(text.data(), text.size(), digest, &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 failed");
  }
  constexpr char kDigits[] = "0123456789abcdef";
  std::string hash;
  for (unsigned int i = 0; i < size; ++i) {
    hash += kDigits[digest[i] / 16];
    hash += kDigits[digest[i] % 16];
  }
  return hash;
}

CoverProofVerdict check_cover_proof(const BitRows& matrix, std::istream& proof) {
  return Checker(matrix, proof).verdict();
}

}  // namespace viewcover
