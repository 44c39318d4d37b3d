#include "optim/cover_methods.h"

#include <algorithm>
#include <array>

#include "optim/exact_cover.h"
#include "optim/greedy_cover.h"
#include "optim/local_search.h"
#include "optim/simulated_annealing.h"
#include "optim/tabu_search.h"

namespace viewcover {
namespace {

template <class Method>
std::unique_ptr<CoverMethod> make() {
  return std::make_unique<Method>();
}

constexpr std::array kMethods = {
    CoverMethodEntry{"exact", make<ExactCover>},      CoverMethodEntry{"local", make<LocalSearch>},
    CoverMethodEntry{"sa", make<SimulatedAnnealing>}, CoverMethodEntry{"tabu", make<TabuSearch>},
    CoverMethodEntry{"greedy", make<GreedyCover>},
};

}  // namespace

std::span<const CoverMethodEntry> cover_methods() { return kMethods; }

std::unique_ptr<CoverMethod> make_cover_method(std::string_view name) {
  const auto* const entry = std::ranges::find(kMethods, name, &CoverMethodEntry::name);
  return entry == kMethods.end() ? nullptr : entry->make();
}

}  // namespace viewcover
