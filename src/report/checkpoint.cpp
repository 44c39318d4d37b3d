#include "report/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <fstream>
#include <iterator>
#include <system_error>

#include "report/file_writer.h"
#include "scene/error.h"

namespace viewcover {
namespace {

constexpr const char* kStartAnew = "start the run anew, without --resume";

std::uint32_t checksum(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

/// A line of JSON, then bytes.
std::pair<Json, std::string> read_segment(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  std::getline(stream, line);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return {Json::parse(line, nullptr, false), std::move(bytes)};
}

/// Adds a segment; false where it is none.
bool add_segment(const Json& head, const std::string& bytes, VisibilityState& state) {
  if (!head.is_object() || head.value("checksum", std::uint32_t{0}) != checksum(bytes)) {
    return false;
  }
  try {
    if (!state.links.add_bytes(bytes) ||
        state.links.size() != head.at("links").get<std::size_t>()) {
      return false;
    }
    state.batches = head.at("batches");
    for (std::size_t i = 0; i < kVerdictCount; ++i) {
      state.links.set_verdicts(static_cast<Verdict>(i), head.at("verdicts").at(i));
    }
    state.statistics.clear();
    for (const auto& [name, count] : head.at("statistics").items()) {
      state.statistics.emplace_back(name, count);
    }
    return true;
  } catch (const Json::exception&) {
    return false;
  }
}

/// What two runs must have in common.
Json identity(Json record) {
  for (const char* key : {"complete", "measured", "verdicts", "backend_statistics", "results"}) {
    record.erase(key);
  }
  if (record.contains("inputs")) {
    for (Json& input : record.at("inputs")) {
      if (input.is_object()) input.erase("file");
    }
  }
  return record;
}

}  // namespace

std::filesystem::path Checkpoint::file(std::size_t number) const {
  return folder_ / fmt::format("links-{:06}", number);
}

VisibilityState Checkpoint::load() {
  VisibilityState state;
  for (files_ = 0; std::filesystem::exists(file(files_)); ++files_) {
    const auto [head, bytes] = read_segment(file(files_));
    if (!add_segment(head, bytes, state)) {
      throw InputError(file(files_).string(), "is damaged", kStartAnew);
    }
  }
  links_ = state.links.size();
  return state;
}

void Checkpoint::save(std::size_t batches, const LinkSet& links,
                      const BackendStatistics& backend_statistics) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) {
    throw InputError(folder_.string(), "cannot be made: " + error.message(),
                     "give a folder that can be written to");
  }
  const std::string bytes = links.to_bytes(links_);
  Json verdicts = Json::array(), statistics = Json::object();
  for (std::size_t i = 0; i < kVerdictCount; ++i) {
    verdicts.push_back(links.verdicts(static_cast<Verdict>(i)));
  }
  for (const auto& [name, count] : backend_statistics) statistics[name] = count;
  const Json head = {{"batches", batches},
                     {"links", links.size()},
                     {"verdicts", verdicts},
                     {"statistics", statistics},
                     {"checksum", checksum(bytes)}};
  FileWriter out(file(files_));
  out << head.dump() << '\n' << std::string_view(bytes);
  out.commit();
  ++files_;
  links_ = links.size();
}

void Checkpoint::remove() const {
  std::error_code error;
  std::filesystem::remove_all(folder_, error);
  if (error) throw InputError(folder_.string(), "cannot be removed: " + error.message(), "");
}

RunState state_of_run(const std::filesystem::path& folder, const Json& record) {
  const std::filesystem::path file = folder / "run.json";
  if (!std::filesystem::exists(file)) return RunState::kNone;
  std::ifstream stream(file);
  const Json found = Json::parse(stream, nullptr, false);
  if (!found.is_object()) throw InputError(file.string(), "is no JSON object", kStartAnew);
  // As it would be read back: names that are no UTF-8 are shown in another way.
  const Json expected =
      Json::parse(record.dump(-1, ' ', false, Json::error_handler_t::replace), nullptr, false);
  const Json differences = Json::diff(identity(found), identity(expected));
  if (!differences.empty()) {
    std::string place = differences[0].at("path").get<std::string>().substr(1);
    std::ranges::replace(place, '/', '.');
    throw InputError("--resume",
                     fmt::format("{} is of another run: it differs in {}", folder.string(), place),
                     "repeat its options with the same program, or give another folder");
  }
  return found.value("complete", false) ? RunState::kComplete : RunState::kIncomplete;
}

}  // namespace viewcover
