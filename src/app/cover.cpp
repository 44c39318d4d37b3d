#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <sstream>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/interrupt.h"
#include "app/option_values.h"
#include "app/progress.h"
#include "optim/cover_file.h"
#include "optim/cover_methods.h"
#include "optim/cover_proof.h"
#include "optim/simulated_annealing.h"
#include "optim/stopwatch.h"
#include "report/file_writer.h"
#include "report/run_record.h"
#include "scene/error.h"

namespace viewcover {
namespace {

struct CoverText {
  CommonOptions common;
  std::string matrix, format, weights, method = "exact", k, time_limit, proof, solutions, annealing;
};

struct FormatName {
  std::string_view name;
  CoverFormat format;
};
constexpr std::array kFormats = {
    FormatName{"mtx", CoverFormat::kMatrixMarket}, FormatName{"scp", CoverFormat::kScp},
    FormatName{"rail", CoverFormat::kRail}, FormatName{"hs", CoverFormat::kHittingSet}};

template <class Entries>
std::vector<std::string_view> names_of(const Entries& entries) {
  std::vector<std::string_view> names;
  for (const auto& entry : entries) names.push_back(entry.name);
  return names;
}

CoverFormat format_of(const CoverText& text) {
  if (text.format.empty()) return detect_cover_format(text.matrix);
  require_available("--format", text.format, names_of(kFormats));
  return std::ranges::find(kFormats, text.format, &FormatName::name)->format;
}

/// "rounds=24,cooling=0.9": a number for each name given, the others by default.
AnnealingSchedule schedule_of(std::string_view text) {
  constexpr std::string_view kOption = "--annealing";
  AnnealingSchedule schedule;
  while (!text.empty()) {
    const std::string_view entry = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), entry.size() + 1));
    const std::size_t equals = entry.find('=');
    const std::string_view name = entry.substr(0, equals),
                           value = equals == std::string_view::npos ? "" : entry.substr(equals + 1);
    if (name == "rounds") {
      schedule.rounds = integer_option(kOption, value, 1, 1'000'000);
    } else if (name == "levels") {
      schedule.levels = integer_option(kOption, value, 1, 1'000'000);
    } else if (name == "cooling") {
      schedule.cooling = number_option(kOption, value, 0, 1);
    } else if (name == "temperature") {
      schedule.temperature = non_negative_option(kOption, value);
    } else {
      throw InputError(kOption, "\"" + std::string(entry) + "\" is none of the schedule's numbers",
                       "give rounds=N, levels=N, cooling=F or temperature=F, separated by commas");
    }
  }
  return schedule;
}

std::unique_ptr<CoverMethod> method_of(const CoverText& text) {
  if (text.annealing.empty()) return make_cover_method(text.method);
  if (text.method != SimulatedAnnealing().name()) {
    throw InputError("--annealing", "is the schedule of sa", "use --method sa");
  }
  return std::make_unique<SimulatedAnnealing>(schedule_of(text.annealing));
}

struct CoverQuestion {
  BitRows matrix;
  std::vector<double> weights;
  std::unique_ptr<CoverMethod> method;
  CoverOptions options;
  std::filesystem::path proof_file;
  double best_after_seconds = 0;  ///< when the smallest whole cover was found

  explicit CoverQuestion(const CoverText& text) : proof_file(text.proof) {
    if (text.matrix.empty()) throw InputError("MATRIX", "is missing", "give a file");
    require_available("--method", text.method, names_of(cover_methods()));
    method = method_of(text);
    options.goal = text.k.empty() ? CoverGoal::kWholeCover : CoverGoal::kOneK;
    if (!text.k.empty()) options.k = count_option("--k", text.k, 1, UINT32_MAX);
    if (!text.time_limit.empty()) {
      options.time_limit_seconds = positive_option("--time-limit", text.time_limit);
    }
    if (!text.solutions.empty()) {
      options.solutions = count_option("--solutions", text.solutions, 1, 1'000'000);
    }
    options.seed = count_option("--seed", text.common.seed, 0, UINT64_MAX);
    if (!text.common.threads.empty()) count_option("--threads", text.common.threads, 1, 1024);
    if (text.method != "exact" || !text.k.empty()) {
      const std::string_view needed =
          "only the fewest choices have one: use --method exact without --k";
      if (!text.proof.empty()) throw InputError("--proof", "there is none to write", needed);
      if (options.solutions > 0) throw InputError("--solutions", "nothing to list", needed);
    }
    matrix = read_cover_file(text.matrix, format_of(text));
    weights = text.weights.empty() ? std::vector<double>(matrix.columns(), 1)
                                   : read_weights(text.weights, matrix.columns());
  }
};

std::vector<std::size_t> counted_from_1(std::vector<std::size_t> numbers) {
  for (std::size_t& number : numbers) ++number;
  return numbers;
}

std::vector<std::size_t> uncoverable_columns(const BitRows& matrix) {
  std::vector<std::size_t> columns;
  const std::vector<BitRows::Word> covered = matrix.union_of_all();
  for (std::size_t column = 0; column < matrix.columns(); ++column) {
    if ((covered[column / 64] >> (column % 64) & 1) == 0) columns.push_back(column);
  }
  return columns;
}

Json answer(const CoverQuestion& question, const CoverInstance& instance, const RegionCover& cover,
            double seconds) {
  const CoverStep step = cover.steps.empty() ? CoverStep{} : cover.steps.back();
  Json json;
  json["size"] = step.chosen.size();
  json["lower_bound"] = cover.lower_bound;
  const bool one_k = question.options.goal == CoverGoal::kOneK;
  json["proved"] = one_k ? step.proved : cover.proved();
  json["chosen"] = counted_from_1(step.chosen);
  json["uncoverable"] = counted_from_1(uncoverable_columns(question.matrix));
  json["covered_weight"] = instance.covered_weight(step.chosen);
  if (one_k) {
    json["covered_percent"] = instance.covered_percent(step.chosen);
    json["upper_bound_percent"] = step.upper_bound_percent;
  }
  if (question.options.solutions > 0) {
    json["solutions"] = Json::array();
    for (const auto& solution : cover.solutions) {
      json["solutions"].push_back(counted_from_1(solution));
    }
    json["solutions_complete"] = cover.solutions_complete;
  }
  json["seconds"] = seconds;
  if (!one_k) json["best_after_seconds"] = question.best_after_seconds;
  json["method"] = question.method->name();
  json["evaluations"] = step.evaluations;
  return json;
}

RegionCover search(CoverQuestion& question, const CoverInstance& instance, bool quiet) {
  std::atomic<std::size_t> best = 0, bound = instance.lower_bound();
  const Progress shown(
      "cover",
      [&] {
        const std::size_t found = best.load(), proved = std::min(bound.load(), found);
        if (found == 0) return Progress::State{0, "no cover yet"};
        return Progress::State{
            static_cast<double>(proved) / static_cast<double>(found),
            fmt::format("best {}, bound {}, gap {:.1f} %", found, proved,
                        100.0 * static_cast<double>(found - proved) / static_cast<double>(found))};
      },
      quiet);
  question.options.stop = &interrupt_flag();
  question.options.stop_keeps_best = true;
  question.options.on_better = [&](const BetterCover& better) {
    best = better.chosen.size();
    question.best_after_seconds = better.seconds;
  };
  question.options.on_bound = [&](std::size_t proved) { bound = std::max(bound.load(), proved); };
  return question.method->solve(instance, question.options);
}

int cover(const CoverText& text) {
  const Stopwatch watch;
  CoverQuestion question(text);
  const CoverInstance instance(question.matrix, question.weights);
  const RegionCover cover = search(question, instance, text.common.quiet);
  if (!question.proof_file.empty()) {
    FileWriter file(question.proof_file);
    std::ostringstream proof;
    write_cover_proof(proof, instance.rows(), *cover.proof);
    file << proof.str();
    file.commit();
  }
  const Json json = answer(question, instance, cover, watch.seconds());
  print_out(json.dump() + "\n");
  if (interrupt_flag()) return kInterrupted;
  const bool asked_for_proof = question.method->name() == "exact";
  return asked_for_proof && !json["proved"].get<bool>() ? kNotProved : kDone;
}

}  // namespace

void add_cover_command(CLI::App& app, int& exit_code) {
  const auto text = std::make_shared<CoverText>();
  const std::vector<std::string_view> methods = names_of(cover_methods());
  CLI::App* const command = app.add_subcommand(
      "cover", "find the fewest choices that cover everything coverable in a 0/1 matrix");
  const auto option = [&](const char* name, std::string& value, const std::string& what,
                          const char* type) {
    command->add_option(name, value, what)->type_name(type);
  };
  option("matrix", text->matrix,
         "Matrix Market pattern (rows are chosen, columns covered), OR-Library or hitting set file",
         "MATRIX");
  option("--format", text->format,
         "mtx, scp, rail (OR-Library: columns are chosen, rows covered; costs are ignored) or hs "
         "(PACE hitting set); default: by the first characters",
         "NAME");
  option("--weights", text->weights, "a number for each thing to cover (default: 1)", "FILE");
  option("--method", text->method, alternatives(methods) + " (default: exact)", "NAME");
  option("--annealing", text->annealing,
         "the schedule of sa, default rounds=12,levels=30,cooling=0.8,temperature=0.02",
         "NAME=VALUE,...");
  option("--k", text->k, "cover as much weight as possible with K choices instead", "K");
  option("--time-limit", text->time_limit,
         "seconds; then the best so far, exit code 1 if not proved", "S");
  option("--proof", text->proof, "write a proof of the lower bound (exact)", "FILE");
  option("--solutions", text->solutions, "list up to N different smallest covers (exact)", "N");
  add_common_options(*command, text->common);
  command->callback([text, &exit_code] { exit_code = cover(*text); });
}

}  // namespace viewcover
