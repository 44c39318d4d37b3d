#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/process.h"

namespace viewcover::testing {

using Json = nlohmann::ordered_json;

/// The fields of one line of a CSV file.
inline std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"')
        fields.back() += line[i++];
      else
        quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

/// A CSV file whose fields hold no line breaks.
struct Table {
  std::vector<std::string> titles;
  std::vector<std::vector<std::string>> rows;

  explicit Table(const std::filesystem::path& file) {
    std::istringstream in(read_file(file));
    std::string line;
    std::getline(in, line);
    titles = csv_fields(line);
    while (std::getline(in, line)) rows.push_back(csv_fields(line));
  }
  std::size_t column(const std::string& title) const {
    const auto place = std::find(titles.begin(), titles.end(), title);
    if (place == titles.end()) throw std::runtime_error("no column " + title);
    return static_cast<std::size_t>(place - titles.begin());
  }
};

inline Json run_json(const std::filesystem::path& bundle) {
  return Json::parse(read_file(bundle / "run.json"));
}

/// True iff the folder reads as a finished result.
inline bool is_complete(const std::filesystem::path& bundle) {
  return std::filesystem::exists(bundle / "run.json") && run_json(bundle).at("complete") == true;
}

/// One line that says why, and exit code 2.
inline void expect_refused(const Outcome& outcome, const std::string& reason) {
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, ::testing::HasSubstr(reason));
  EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
}

/// The files of a bundle without what may differ between equal runs.
inline std::map<std::string, std::string> comparable_files(const std::filesystem::path& bundle) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(bundle)) {
    const std::string name = entry.path().filename().string();
    std::string text = read_file(entry.path());
    if (name == "run.json") {
      Json run = Json::parse(text);
      run.erase("measured");
      text = run.dump();
    } else if (name == "cover.csv" || name == "viewpoints.csv") {
      const Table table(entry.path());
      const std::size_t seconds = table.column("seconds");
      text.clear();
      for (std::vector<std::string> row : table.rows) {
        row.at(seconds).clear();
        for (const std::string& field : row) text += field + ",";
        text += '\n';
      }
    }
    files[name] = text;
  }
  return files;
}

/// The last line of a text that ends with a line break, without it.
inline std::string last_line(const std::string& text) {
  if (!text.ends_with('\n')) throw std::runtime_error("no line break at the end");
  const std::string lines = text.substr(0, text.size() - 1);
  return lines.substr(lines.rfind('\n') + 1);  // npos + 1 is 0
}

/// A folder with the simple living room.
class RoomFolder {
 public:
  RoomFolder() {
    const Outcome outcome = viewcover_run({"generate", "living-room", "-o", scene()});
    if (outcome.exit_code != 0) throw std::runtime_error(outcome.error);
  }
  std::filesystem::path path() const { return folder_.path(); }
  std::string scene() const { return (folder_.path() / "room.obj").string(); }
  std::string region() const { return (folder_.path() / "room.region.json").string(); }
  std::string bundle(const std::string& name = "bundle") const {
    return (folder_.path() / name).string();
  }
  std::string write(const std::string& name, std::string_view content) const {
    return folder_.write(name, content).string();
  }
  /// Solves the room into bundle(name).
  Outcome solve(const std::string& name, std::vector<std::string> more = {},
                Process::Limits limits = {}) const {
    std::vector<std::string> arguments = {"solve",  scene(), "--region",
                                          region(), "-o",    bundle(name)};
    // Random rays and no viewpoints unless asked otherwise: the quickest way to a bundle.
    if (std::ranges::find(more, "--backend") == more.end()) {
      arguments.insert(arguments.end(), {"--backend", "rays"});
    }
    if (std::ranges::find(more, "--viewpoints") == more.end()) {
      arguments.insert(arguments.end(), {"--viewpoints", "none"});
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    return viewcover_run(arguments, limits);
  }

 private:
  ScratchFolder folder_;
};

}  // namespace viewcover::testing
