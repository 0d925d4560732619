// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the tables of cost, and what makes them.
#pragma once

#include "experiments/contestants/columns.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/stage/stage_timing.hpp"
#include "experiments/store/piece_record.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::cost {

struct Row {
  std::string mix, clipper, scalar;
  std::optional<Timing> timing;

  bool is_timed() const { return timing.has_value(); }

  static constexpr std::string_view kName = "cost";
  static constexpr std::string_view kTitle =
      "Time per triangle, view space in, NDC polygons out, four attributes";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "x textbook: how many times faster than textbook in float on the same triangles in the same round; median and 95 % interval. Not timed (-): the answers break the promise."};
  static constexpr auto columns() {
    return std::tuple(column("mix", &Row::mix), contestant_columns(&Row::clipper, &Row::scalar),
                      group(&Row::timing));
  }
};

struct OperationsRow {
  std::string mix, clipper;
  double additions = 0, multiplications = 0, divisions = 0, comparisons = 0;  // per triangle

  double arithmetic() const { return additions + multiplications + divisions; }

  static constexpr std::string_view kName = "cost_operations";
  static constexpr std::string_view kTitle = "Operations per triangle, by kind";
  static constexpr auto columns() {
    using R = OperationsRow;
    return std::tuple(column("mix", &R::mix), column("clipper", &R::clipper),
                      column("additions", "+ -", &R::additions),
                      column("multiplications", "*", &R::multiplications),
                      column("divisions", "/", &R::divisions),
                      column("comparisons", &R::comparisons));
  }
};

// A clipper of a space beside clip space on the same mix: the ratios that the finding speaks of. A
// figure that was not measured is empty.
struct SpaceRow {
  std::string mix, clipper, scalar;
  std::optional<MedianInterval> ns = {};
  std::optional<double> time = {}, arithmetic = {}, divisions = {};  // over those of clip space

  static constexpr std::string_view kName = "cost_spaces";
  static constexpr std::string_view kTitle = "Each space over clip space on the same triangles";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Time, arithmetic (additions, multiplications and divisions) and divisions, each over that of homogeneous/sutherland_hodgman."};
  static constexpr auto columns() {
    using R = SpaceRow;
    return std::tuple(column("mix", &R::mix), contestant_columns(&R::clipper, &R::scalar),
                      interval("ns_per_triangle", "ns", "ns/tri", &R::ns),
                      column("time_ratio", "x time", &R::time),
                      column("arithmetic_ratio", "x arithmetic", &R::arithmetic),
                      column("divisions_ratio", "x divisions", &R::divisions));
  }
};

struct SplitRow {
  std::string mix, clipper, scalar, part;
  MedianInterval ns, share_percent;

  static constexpr std::string_view kName = "cost_split";
  static constexpr std::string_view kTitle =
      "Where the time goes: transform, cut, divide, in the clipper's order";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Three runs side by side, each doing one step more; a part is the difference of two in the same round. The transform alone is that of positions. A processor overlaps one step with the next, which a run of the first alone can't show: a small or negative part is hidden behind the others."};
  static constexpr auto columns() {
    using R = SplitRow;
    return std::tuple(column("mix", &R::mix), contestant_columns(&R::clipper, &R::scalar),
                      column("part", &R::part), interval("ns_per_triangle", "ns", "ns/tri", &R::ns),
                      interval("share_percent", "share", "share %", &R::share_percent));
  }
};

inline constexpr std::string_view kBytesAlone = "bytes alone";  // in place of a contract

// Figures of the stage: ns first, then what of the memory limit that is in the same rounds.
struct StageFigures : Timing {
  std::optional<MedianInterval> limit_percent = {}, times_fastest = {};  // of a contestant

  static constexpr auto columns() {
    using F = StageFigures;
    return std::tuple(interval("ns_per_triangle", "ns", "ns/tri", &Timing::ns),
                      interval("limit_percent", "limit", "% of limit", &F::limit_percent),
                      interval("times_fastest", "fastest", "time / fastest", &F::times_fastest),
                      column("rounds", &Timing::rounds),
                      interval("speedup_to_textbook", "speedup", "x textbook", &Timing::speedup));
  }
};

struct StageRow {
  std::string mix;
  InputFrom from = InputFrom::memory;
  std::string clipper, scalar, build, contract;  // of a contestant, or of a pass over its bytes
  std::optional<StageFigures> timing;
  std::optional<double> bytes_in = {}, bytes_out = {}, gigabytes_per_second = {};

  // Plots and findings speak of the scalar clippers' only build, and of SIMD.
  bool is_shown() const { return timing && build != "plain"; }
  std::string label() const { return clipper + " " + scalar; }

  static constexpr std::string_view kName = "cost_stage";
  static constexpr std::string_view kTitle =
      "The stage: clip-space triangles in, clip-space polygons out, no divide";
  static constexpr std::array<std::string_view, 3> kNotes = {
      "Contracts: copy, an array of vertices in, every surviving triangle written out; number, streams of positions in, inside triangles by number; indexed, a mesh in, each vertex classified once. Four attributes. Time / that of the contract's fastest, and x textbook: medians of the ratios of the same round.",
      "From memory the input streams through; from cache it comes in blocks that lie in the second-level one with their answers, each read before, though not clipped before (a mesh in draws of that size).",
      "B in, B out: bytes that the contract reads and that the answer takes, per triangle. The limit is what passes over the same bytes from the same place (contract `bytes alone`) take in the same round; % of limit: that time over the clipper's, 100 where it does nothing but move bytes. Answers go to a block that stays in cache. Not timed (-): see cost_stage_refused."};
  static constexpr auto columns() {
    using R = StageRow;
    return std::tuple(column("mix", &R::mix), column("from", &R::from),
                      contestant_columns(&R::clipper, &R::scalar), column("build", &R::build),
                      column("contract", &R::contract), group(&R::timing),
                      column("bytes_in", "B in", &R::bytes_in),
                      column("bytes_out", "B out", &R::bytes_out),
                      column("gigabytes_per_second", "GB/s", &R::gigabytes_per_second));
  }
};

inline constexpr const char* kGameLikeStage = "game_like";  // as the stage's tables call the mix

// What certainty costs: the correctly rounded clipper beside the fastest that promises less, on the
// same triangles in the same rounds.
struct CertaintyRow {
  std::string mix;
  Contract contract = Contract::copy;
  InputFrom from = InputFrom::memory;
  std::string fastest;  // of the others
  double fastest_ns = 0, certain_ns = 0;
  MedianInterval price = {};                        // certain over fastest, round by round
  double fastest_limit = 0, certain_limit = 0;      // percent
  double fastest_speedup = 0, certain_speedup = 0;  // over textbook

  // Whether the interval says so, and by so much that it is a price.
  bool is_dear() const { return price.low > 1 && price.median > kNoticeable; }

  static constexpr double kNoticeable = 1.05;
  static constexpr std::string_view kName = "cost_certainty";
  static constexpr std::string_view kTitle =
      "What certainty costs: correctly rounded over the fastest that is not";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "As in cost_stage. Certain: barycentric/correctly_rounded_batch, every coordinate the nearest float, proved. Certain / fastest: median and 95 % interval of the ratios of the same round. % of limit: what moving the same bytes takes over the time, in the same rounds."};
  static constexpr auto columns() {
    using R = CertaintyRow;
    return std::tuple(column("mix", &R::mix), column("contract", &R::contract),
                      column("from", &R::from), column("fastest", &R::fastest),
                      column("fastest_ns", "ns/tri", &R::fastest_ns),
                      column("certain_ns", "certain ns/tri", &R::certain_ns),
                      interval("price", "price", "certain / fastest", &R::price),
                      column("fastest_limit", "% of limit", &R::fastest_limit),
                      column("certain_limit", "certain % of limit", &R::certain_limit),
                      column("fastest_speedup", "x textbook", &R::fastest_speedup),
                      column("certain_speedup", "certain x textbook", &R::certain_speedup));
  }
};

constexpr auto share_columns() {
  using S = StageShares;
  return std::tuple(column("inside_percent", "inside %", &S::inside),
                    column("outside_percent", "outside %", &S::outside),
                    column("straddling_percent", "straddling %", &S::straddling),
                    column("one_plane_percent", "1 plane %", &S::one_plane),
                    column("two_planes_percent", "2 planes %", &S::two_planes),
                    column("more_planes_percent", "3 and more %", &S::more_planes),
                    column("behind_eye_percent", "behind the eye %", &S::behind_eye));
}

struct MixRow {
  std::string mix, contracts;
  std::int64_t triangles = 0;
  StageShares shares = {};
  double megabytes = 0;

  static constexpr std::string_view kName = "cost_stage_mixes";
  static constexpr std::string_view kTitle = "The inputs of the stage, by outcodes";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Of the straddling triangles: how many planes some vertex is outside of, and whether one is behind the eye, w < 0."};
  static constexpr auto columns() {
    using R = MixRow;
    return std::tuple(column("mix", &R::mix), column("contracts", &R::contracts),
                      column("triangles", &R::triangles), group(&R::shares, share_columns()),
                      column("megabytes", "MB", &R::megabytes));
  }
};

struct RefusedRow {
  std::string mix;
  InputFrom from = InputFrom::memory;
  std::string clipper, build, contract, reason;

  static constexpr std::string_view kName = "cost_stage_refused";
  static constexpr std::string_view kTitle =
      "Not timed: the answers break the promise of the stage";
  static constexpr auto columns() {
    using R = RefusedRow;
    return std::tuple(column("mix", &R::mix), column("from", &R::from),
                      column("clipper", &R::clipper), column("build", &R::build),
                      column("contract", &R::contract), column("reason", "reason", &R::reason, 50));
  }
};

enum class Growing { triangles, attributes, planes, threads };
inline constexpr std::array kGrowing = {Growing::triangles, Growing::attributes, Growing::planes,
                                        Growing::threads};
constexpr std::array<std::string_view, 4> names_of(Growing) {
  return {"triangles", "attributes", "planes", "threads"};
}

struct GrowthRow {
  Growing grows = Growing::triangles;
  std::int64_t n = 0;
  InputFrom from = InputFrom::memory;
  std::string clipper, scalar;
  Contract contract = Contract::copy;
  std::optional<double> triangles = {};  // clipped in one run
  std::optional<MedianInterval> ns = {};
  std::optional<MedianInterval> speedup_by_threads = {};  // over one of them in the same rounds
  std::optional<double> speedup = {};                     // where textbook is timed

  static constexpr std::string_view kName = "cost_growth";
  static constexpr std::string_view kTitle = "How the time of the stage grows";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "triangles: lists of n, each time others of a game-like soup, until it was gone through. attributes: floats beside the position. planes: every triangle is cut by exactly n. threads: the soup in n parts, time by the clock on the wall; x 1 thread: how many times as fast as one thread in the same rounds. From cache: the second-level one holds the list, which is read once before, though it was not clipped before (threads: the same list again and again). Column triangles: clipped in one run. Batch clippers in SIMD."};
  static constexpr auto columns() {
    using R = GrowthRow;
    return std::tuple(column("grows", &R::grows), column("n", &R::n), column("from", &R::from),
                      contestant_columns(&R::clipper, &R::scalar), column("contract", &R::contract),
                      column("triangles", &R::triangles),
                      interval("ns_per_triangle", "ns", "ns/tri", &R::ns),
                      interval("speedup_to_one_thread", "speedup_to_one_thread", "x 1 thread",
                               &R::speedup_by_threads),
                      column("speedup_to_textbook", "x textbook", &R::speedup));
  }
};

// Adds the parts, in the order of the clipper, and the whole of each clipper that has steps and
// that was timed in float or double on the mix.
void measure_split(std::span<const SampledView> views, const std::vector<Row>& times, int rounds,
                   TableOf<SplitRow>& table, PieceRecord& record);

// Emits the tables and plots of the stage; returns its finding.
std::string run_stage(const ExperimentContext& context);
StageClock stage_clock(bool quick);

struct StageTables {
  TableOf<MixRow> mixes;
  TableOf<StageRow> stage;
  TableOf<CertaintyRow> certainty;
  TableOf<RefusedRow> refused;

  // A row for each pass and each contestant, the price of certainty by contract, and a row for each
  // that was refused.
  void add(const std::string& mix, const StageMeasurement& measured, PieceRecord& record);
};

// The input in that layout.
MixRow mix_row(const StageInput& input, Contract contract);
// By contract, where both were timed.
std::vector<CertaintyRow> certainty_rows(const std::string& mix, const StageMeasurement& measured);

struct GrowthOptions {
  std::uint64_t seed = 1;
  std::size_t soup = 1'000'000;   // triangles
  std::size_t most = 10'000'000;  // triangles streamed
  std::size_t attribute_soup = 200'000;
  std::size_t crossing = 2048;  // different triangles by number of planes; each comes several times
  StageClock clock = {};
};

// A row for each n and contestant: the baseline, and what a renderer would choose from.
void measure_growth(Growing growing, const GrowthOptions& options, TableOf<GrowthRow>& table,
                    PieceRecord& record);

// Clip-space triangles that cross exactly so many planes: some vertex is outside of each of these,
// none is outside of another, and each holds an edge of what is left. Each of `different` triangles
// comes `times` times, in random order. Pre-condition: 1 <= planes <= 6.
StageInput crossing_input(int planes, std::size_t different, std::size_t times, std::uint64_t seed);

// What is said of cost at the end, from the rows of its tables alone.

// Time by mix for one clipper of each space, in float if that is there.
Plot time_plot(const std::vector<Row>& times);
// Parts by clipper for the first mix, in float if that is there. Pre-condition: rows.
Plot split_plot(const std::vector<SplitRow>& split);
// Time by mix, one bar per clipper of the best build in the contract, and the limit of memory.
Plot stage_plot(const std::vector<StageRow>& stage, Contract contract, InputFrom from);
// ns per triangle over what grows.
Plot growth_plot(const std::vector<GrowthRow>& growth, Growing growing);

// The clippers of the spaces, mix by mix, in float if that is there.
std::vector<SpaceRow> space_rows(const std::vector<Row>& times,
                                 const std::vector<OperationsRow>& operations);

// Which space is the fastest, on the first mix and the others, and which needs the most operations.
std::string space_finding(const std::vector<SpaceRow>& spaces);
// Where certainty costs time in the stage, where it does not, and the most that it costs; empty if
// it was not timed.
std::string certainty_finding(const std::vector<CertaintyRow>& certainty);
// Where certainty costs the most. Pre-condition: a row.
const CertaintyRow& dearest(const std::vector<CertaintyRow>& certainty);
// The end of a sentence: "on straddling triangles by number, from cache".
std::string where_text(const CertaintyRow& row);

}  // namespace clipscope::experiments::cost
