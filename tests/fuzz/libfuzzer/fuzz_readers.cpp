// fuzz_readers -reader=NAME [options of libFuzzer] CORPUS: a reader under libFuzzer.
// fuzz_readers -reader=NAME -seeds=FOLDER: writes the lines of the corpus as files, and ends.
// fuzz_readers -line=FILE: prints what was found as a line for the corpus, and ends.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "fuzz/readers.h"

namespace {

using namespace viewcover::fuzz;

const Reader* g_reader = nullptr;

void write_seeds(const std::string& folder) {
  std::size_t number = 0;
  for (const std::string& content : corpus_of(*g_reader, VIEWCOVER_CORPUS)) {
    std::ofstream(folder + "/seed" + std::to_string(number++), std::ios::binary) << content;
  }
  std::exit(0);
}

void print_line(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  std::printf("%s\n", as_line(content).c_str());
  std::exit(0);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  int kept = 0;
  for (int i = 0; i < *argc; ++i) {
    const std::string_view argument = (*argv)[i];
    const std::string value(argument.substr(std::min(argument.find('=') + 1, argument.size())));
    if (argument.starts_with("-reader=")) {
      g_reader = &reader(value);
    } else if (argument.starts_with("-seeds=")) {
      write_seeds(value);
    } else if (argument.starts_with("-line=")) {
      print_line(value);
    } else {
      (*argv)[kept++] = (*argv)[i];
    }
  }
  *argc = kept;
  (*argv)[kept] = nullptr;
  if (g_reader == nullptr) reader("");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  g_reader->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
