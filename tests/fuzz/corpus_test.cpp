#include <gtest/gtest.h>

#include "fuzz/readers.h"

namespace viewcover::fuzz {
namespace {

TEST(Corpus, EveryLineIsReadOrRefused) {
  for (const Reader& reader : readers()) {
    const std::vector<std::string> corpus = corpus_of(reader, VIEWCOVER_CORPUS);
    EXPECT_FALSE(corpus.empty()) << reader.name;
    for (const std::string& content : corpus) {
      SCOPED_TRACE(std::string(reader.name) + ": " + as_line(content));
      reader.run(content);
    }
  }
}

TEST(Corpus, IsReadOrRefusedWhereverItIsCutOrChanged) {
  for (const Reader& reader : readers()) {
    // Each of these takes a process.
    const std::size_t step = reader.name == "gltf" || reader.name == "dae" ? 11 : 1;
    for (const std::string& content : corpus_of(reader, VIEWCOVER_CORPUS)) {
      for (std::size_t size = 0; size < content.size(); size += step) {
        SCOPED_TRACE(std::string(reader.name) + ": " + as_line(content.substr(0, size)));
        reader.run(std::string_view(content).substr(0, size));
        std::string changed = content;
        changed[size] = static_cast<char>(changed[size] ^ (1 << (size % 8)));
        reader.run(changed);
      }
    }
  }
}

TEST(Corpus, LinesKeepEveryByte) {
  std::string bytes;
  for (int byte = 0; byte < 256; ++byte) bytes += static_cast<char>(byte);
  EXPECT_EQ(from_line(as_line(bytes)), bytes);
  EXPECT_EQ(as_line(bytes).find_first_of("\n\r"), std::string::npos);
  EXPECT_EQ(as_line("#\\n"), "\\x23\\\\n");
}

}  // namespace
}  // namespace viewcover::fuzz
