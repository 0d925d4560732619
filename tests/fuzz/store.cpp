// SPDX-License-Identifier: GPL-3.0-or-later
//
// The store of a run: a file that is none is refused, one that is damaged or strange is read as far
// as it can be, and a run does not differ from itself.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "experiments/store/diff.hpp"
#include "experiments/store/results_store.hpp"
#include "experiments/table/json_text.hpp"
#include "tests/fuzz/harness.hpp"

namespace clipscope::fuzz {
namespace {

using namespace experiments;

// A file in memory that goes away, with what SQLite puts beside it.
class ShortLivedFile {
 public:
  explicit ShortLivedFile(Bytes bytes) { std::ofstream(path_, std::ios::binary) << text_of(bytes); }
  ~ShortLivedFile() {
    for (const char* suffix : {"", "-journal", "-wal", "-shm"}) {
      std::error_code ignored;
      std::filesystem::remove(path_.string() + suffix, ignored);
    }
  }
  ShortLivedFile(const ShortLivedFile&) = delete;
  ShortLivedFile& operator=(const ShortLivedFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  const std::filesystem::path path_ = fmt::format("/dev/shm/clipscope-fuzz-{}.sqlite", getpid());
};

void print(const Table& table) {
  for (const auto& text : {table.to_text(), table.to_markdown(), table.to_csv(), table.to_latex(),
                           json_text(table.to_json())}) {
    require(!text.empty(), "the table {} was printed as nothing", table.name());
  }
}

}  // namespace

void store(Bytes bytes) {
  const ShortLivedFile file(bytes);
  read_or_refuse([&] {
    const ResultsStore run(file.path());
    run.run_info();
    run.interruptions();
    for (const StoredExperiment& e : run.experiments()) {
      run.figures(e.name);
      run.worst_inputs(e.name);
      run.interruptions(e.name);
    }
    for (const StoredTable& t : run.tables()) print(run.table(t.name));
    const Difference difference = difference_of(run, run, std::nullopt);
    require(difference.moved.empty() && difference.lone.empty(), "a run differs from itself");
  });
}

}  // namespace clipscope::fuzz
