#include "compare/pair_verdicts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <ranges>
#include <span>
#include <string_view>

#include "report/csv_table.h"
#include "scene/error.h"

namespace viewcover {
namespace {

constexpr std::uint8_t kNoVerdict = 255;

/// The text up to the next separator, which is taken off with it.
std::string_view next_word(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return word;
}

/// A node from owner:level:path, owners counted from 1.
template <class Owner>
std::optional<QuadAddress<Owner>> node_of(std::string_view text) {
  std::array<std::uint64_t, 3> numbers{};
  for (std::uint64_t& number : numbers) {
    const std::string_view word = next_word(text, ':');
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  }
  const auto [owner, level, path] = numbers;
  return text.empty() ? QuadAddress<Owner>::from_file(owner, level, path) : std::nullopt;
}

std::optional<Verdict> visible_verdict(std::string_view text) {
  for (std::size_t i = 0; i < kVerdictCount; ++i) {
    const auto verdict = static_cast<Verdict>(i);
    if (is_visible(verdict) && name(verdict) == text) return verdict;
  }
  return std::nullopt;
}

/// The nodes of an ascending list that lie in a node, as a range of places.
template <class Owner>
auto places_in(const std::vector<QuadAddress<Owner>>& nodes, QuadAddress<Owner> node) {
  const auto first = std::ranges::lower_bound(nodes, node);
  const auto last =
      std::find_if_not(first, nodes.end(), [&](const auto& other) { return node.contains(other); });
  return std::views::iota(static_cast<std::size_t>(first - nodes.begin()),
                          static_cast<std::size_t>(last - nodes.begin()));
}

}  // namespace

PairVerdicts::PairVerdicts(const std::filesystem::path& folder, const RunData& run)
    : elements_(run.bundle.elements.size()), verdicts_(run.seen.rows() * elements_, kNoVerdict) {
  const std::filesystem::path file = folder / "links.csv";
  std::ifstream stream = open_for_check(file);
  std::string line;
  std::getline(stream, line);
  for (std::size_t number = 2; std::getline(stream, line); ++number) {
    std::string_view rest = line;
    const auto region = node_of<PartId>(next_word(rest, ','));
    const auto element = node_of<SurfaceId>(next_word(rest, ','));
    const auto verdict = visible_verdict(next_word(rest, ','));
    if (!region || !element || !verdict) {
      throw InputError(InputError::at_line(file.string(), number), "is no link",
                       "give the folder of a finished run");
    }
    const auto columns = places_in(run.bundle.elements, *element);
    const auto known_verdicts = [&](std::size_t row) {
      return std::span(verdicts_).subspan(row * elements_ + columns.front(), columns.size());
    };
    const auto value = static_cast<std::uint8_t>(*verdict);
    if (columns.empty()) continue;
    const auto face = run.face_regions.find(region->owner());
    if (face == run.face_regions.end()) {
      for (const std::size_t row : places_in(run.region_addresses, *region)) {
        std::ranges::fill(known_verdicts(row), value);
      }
      continue;
    }
    for (std::uint8_t& known : known_verdicts(face->second)) known = std::min(known, value);
  }
  for (std::size_t row = 0; row < run.seen.rows(); ++row) {
    for_each_bit(run.seen.row(row), [&](std::size_t column) {
      if (verdicts_[row * elements_ + column] != kNoVerdict) return;
      throw InputError(file.string(),
                       "has no link for region " + std::to_string(row + 1) + " and element " +
                           std::to_string(column + 1) + ", which visibility.mtx has",
                       "give the folder of one run");
    });
  }
}

}  // namespace viewcover
