// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/hunt.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/hunt/breeding.hpp"
#include "experiments/hunt/evaluation.hpp"
#include "experiments/scenes/random.hpp"

namespace clipscope::experiments::hunt {
namespace {

constexpr std::size_t kIslands = 16, kLitter = 512;
// Of a guest, which takes longer, the more so where it crashes.
constexpr std::size_t kGuestLitter = 128;
constexpr std::size_t kElite = 24;          // of an island
constexpr int kPatience = 10;               // rounds
constexpr int kPatienceWithTheWorst = 100;  // of the island that has the worst of all

using Clock = std::chrono::steady_clock;

// Prey of the catalogue with the same setting.
struct Ground {
  Setting setting;
  std::vector<Prey> prey;
};

struct Island {
  Setting setting;
  std::vector<Prey> natives;  // of the catalogue: parents beside the elite
  std::vector<Prey> elite;    // the worst first
  int stale = 0;              // rounds in which the elite's first stayed
  bool has_the_worst = false;
};

bool is_usable(const HardCase& c) {
  // Options of the command line have no shear.
  const bool is_sheared = c.frustum.shear_x != 0 || c.frustum.shear_y != 0;
  return !is_sheared && c.primitive == Primitive::triangle &&
         c.attribute_count == Prey::kAttributes && is_finite(c);
}

class Hunt {
 public:
  Hunt(const Contestant& contestant, const HuntOptions& options, const Rater& rater)
      : contestant_(contestant),
        options_(options),
        rater_(rater),
        islands_(kIslands),
        random_(options.seed) {
    if (options.catalogue) survey_grounds();
    if (options.begin_with) take_known(*options.begin_with);
    for (Island& island : islands_) settle(island);
  }

  // Prey in all of a round: count, as evenly over the islands as it goes.
  void make_round(std::size_t count) {
    const std::uint64_t first = next_litter_;
    next_litter_ += kIslands;
    std::vector<Evaluated> evaluated(kIslands);
    tbb::parallel_for(std::size_t{0}, kIslands, [&](std::size_t i) {
      const std::size_t size = count * (i + 1) / kIslands - count * i / kIslands;
      Random random(options_.seed * 0x9E3779B97F4A7C15u + first + i + 1);
      const Island& island = islands_[i];
      evaluated[i] =
          rater_.evaluate(island.setting, litter(island, size, random), floor_of(island), known_);
    });
    for (std::size_t i = 0; i < kIslands; ++i) take(evaluated[i], islands_[i]);
    for (Island& island : islands_) {
      const int patience = island.has_the_worst ? kPatienceWithTheWorst : kPatience;
      if (island.stale >= patience) settle(island);
    }
    hunted_.evaluations += count;
  }

  Hunted& hunted() { return hunted_; }

 private:
  bool is_of_pairs() const { return options_.measure == Measure::crack; }
  // Clip distances would have to be those of a triangle and of its neighbour.
  SettingLimits limits() const { return {options_.space, options_.plain, !is_of_pairs()}; }

  void survey_grounds() {
    for (const HardCase& c : builtin_catalogue()) {
      if (!is_usable(c)) continue;
      const Setting setting = setting_of(c);
      const bool is_taken = takes(contestant_, setting, rater_.attributes());
      if (!is_taken || !limits().allow(setting)) continue;
      auto ground = std::ranges::find(grounds_, setting, &Ground::setting);
      if (ground == grounds_.end()) ground = grounds_.insert(ground, {setting, {}});
      ground->prey.push_back(prey_of(c));
      if (is_of_pairs()) set_attributes(ground->prey.back(), 0);
    }
  }

  void take_known(const HardCase& c) {
    Prey prey = prey_of(c);
    const Setting setting = setting_of(c);
    prey.value = rater_.exact_values(setting, {&prey, 1}).front();
    if (prey.value > 0) set_best(setting, prey);
  }

  void settle(Island& island) {
    island = Island();
    if (best_ && random_.chance(0.25)) {
      island.setting = best_->first;
      island.elite = {best_->second};
    } else if (!grounds_.empty() && random_.chance(0.5)) {
      const Ground& ground = grounds_[static_cast<std::size_t>(random_.below(grounds_.size()))];
      island.setting = ground.setting;
      island.natives = ground.prey;
    } else {
      island.setting = random_setting(contestant_, rater_.attributes(), limits(), random_);
    }
  }

  static double floor_of(const Island& island) {
    return island.elite.size() < kElite ? 0 : island.elite.back().value;
  }

  static const Prey& one_of(const std::vector<Prey>& prey, Random& random) {
    return prey[static_cast<std::size_t>(random.below(prey.size()))];
  }
  // The worst more often than others.
  static const Prey& parent(const Island& island, Random& random) {
    const bool is_native = !island.natives.empty() && (island.elite.empty() || random.chance(0.2));
    if (is_native) return one_of(island.natives, random);
    const double rank = random.uniform();
    return island
        .elite[static_cast<std::size_t>(rank * rank * static_cast<double>(island.elite.size()))];
  }

  std::vector<Prey> litter(const Island& island, std::size_t size, Random& random) const {
    constexpr double kChance = 0.2, kCross = 0.15;
    // Attributes are left alone where they are not what is hunted; in `crack` they are marks.
    const int changing = options_.measure == Measure::attribute ? rater_.attributes()
                         : is_of_pairs()                        ? 0
                                         : island.setting.volume.clip_distances;
    std::vector<Prey> all;
    for (std::size_t i = 0; i < size; ++i) {
      if ((island.elite.empty() && island.natives.empty()) || random.chance(kChance)) {
        all.push_back(random_prey(island.setting, random));
      } else if (random.chance(kCross)) {
        const Prey& a = parent(island, random);
        all.push_back(crossed(a, parent(island, random), random));
      } else {
        all.push_back(mutated(island.setting, parent(island, random), changing, random));
      }
    }
    return all;
  }

  void take(const Evaluated& evaluated, Island& island) {
    const double before = island.elite.empty() ? 0 : island.elite.front().value;
    for (const Prey& prey : evaluated.worst) {
      const bool is_known = std::ranges::any_of(island.elite, [&](const Prey& p) {
        return p.position == prey.position && p.attributes == prey.attributes;
      });
      if (!is_known) island.elite.push_back(prey);
    }
    std::ranges::stable_sort(island.elite, std::ranges::greater(), &Prey::value);
    island.elite.resize(std::min(island.elite.size(), kElite));
    const double now = island.elite.empty() ? 0 : island.elite.front().value;
    island.stale = now > before ? 0 : island.stale + 1;
    if (now > 0 && (!best_ || now > best_->second.value)) keep_best(island);
    for (const auto& [outcome, prey] : evaluated.failing) {
      const auto place = static_cast<std::size_t>(outcome);
      if (known_.test(place)) continue;
      known_.set(place);
      hunted_.failing[place] = case_of(island.setting, prey, rater_.attributes());
    }
  }

  void keep_best(Island& island) {
    for (Island& other : islands_) other.has_the_worst = &other == &island;
    set_best(island.setting, island.elite.front());
  }

  void set_best(const Setting& setting, const Prey& prey) {
    best_ = {setting, prey};
    Trophy& worst = hunted_.worst.emplace();
    worst.value = prey.value;
    worst.cases = {case_of(setting, prey, rater_.attributes())};
    if (is_of_pairs()) worst.cases.push_back(neighbour_of(setting, prey, rater_.attributes()));
  }

  const Contestant& contestant_;
  const HuntOptions& options_;
  const Rater& rater_;
  std::vector<Ground> grounds_;
  std::vector<Island> islands_;
  Random random_;
  std::uint64_t next_litter_ = 0;
  Outcomes known_;
  std::optional<std::pair<Setting, Prey>> best_;
  Hunted hunted_;
};

}  // namespace

Hunted hunt(const Contestant& contestant, const HuntOptions& options,
            const std::function<void(const Hunted&)>& after_round) {
  return hunt(contestant, options, Evaluator(contestant, options.measure, options.in_domain),
              after_round);
}

Hunted hunt(const Contestant& contestant, const HuntOptions& options, const Rater& rater,
            const std::function<void(const Hunted&)>& after_round) {
  const std::size_t round = kIslands * (contestant.is_guest ? kGuestLitter : kLitter);
  Hunt hunt(contestant, options, rater);
  Hunted& hunted = hunt.hunted();
  const auto start = Clock::now();
  const auto is_over = [&] {
    return options.evaluations ? hunted.evaluations >= *options.evaluations
                               : hunted.seconds >= options.seconds;
  };
  do {
    hunt.make_round(options.evaluations ? static_cast<std::size_t>(std::min<std::uint64_t>(
                                              round, *options.evaluations - hunted.evaluations))
                                        : round);
    hunted.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (after_round) after_round(hunted);
  } while (!is_over());
  return std::move(hunted);
}

}  // namespace clipscope::experiments::hunt
