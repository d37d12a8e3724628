// The search of a sweep: directions are scored, the best refined, measured and polished.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "sweep/contender.hpp"
#include "sweep/descent.hpp"
#include "sweep/listing.hpp"
#include "sweep/sweep_result.hpp"
#include "sweep/sweep_tools.hpp"

namespace moldlight {

class DirectionSearch {
 public:
  /// What is evaluated and skipped goes into the result. Both must outlive it.
  DirectionSearch(SweepTools& tools, SweepResult& result)
      : tools_(tools), result_(result), limit_(tools.wanted(), tools.settings.apart_deg) {}

  /// What is found so far. Whoever asks may take from it and put into it.
  [[nodiscard]] std::vector<Contender>& contenders() { return contenders_; }
  /// By the user or by the part's shape, where directions rank as molds go; measured.
  [[nodiscard]] std::vector<Contender>& named() { return named_; }

  /// Looked at to the end, whatever its score.
  [[nodiscard]] bool is_named(const Candidate& candidate) const {
    return candidate.from_user() || (tools_.settings.rank == SweepRank::mold && candidate.canonical);
  }

  /// Scores candidates and puts them among the contenders.
  void score(std::vector<Candidate>& candidates);
  /// Measures the contenders, those of least undercut first.
  void measure_all();
  /// Those that are named have figures and count from the beginning.
  void reset_limit();
  void refine();
  /// Keeps whatever may still be among the listed ones: its optimistic undercut is below the pessimistic one
  /// of the last listed. Where more than a few times the list tie, those that the tie's order puts first are
  /// kept.
  void keep_contenders();
  /// Contenders come by their scores, so that what is measured soon says of many others that they cannot be
  /// listed.
  void measure_contenders();
  void polish_best();
  [[nodiscard]] Descent descent();
  /// Best first, indices into the contenders.
  [[nodiscard]] std::vector<std::size_t> contender_order() const;

 private:
  void score_batch(std::span<Candidate> batch, std::size_t before, std::size_t total);
  void note(const EvaluatedDirection& evaluated);
  void measure_first();
  [[nodiscard]] bool surely_hidden(const Contender& contender) const;
  void measure_batch(std::span<Contender> batch, const std::function<bool()>& stop);
  [[nodiscard]] bool may_gain(const Contender& found) const;
  [[nodiscard]] std::vector<std::size_t> contenders_to_polish() const;
  /// Undercut area above which a direction is surely not among the listed ones, by what is scored so far.
  [[nodiscard]] double listing_limit() const;

  SweepTools& tools_;
  SweepResult& result_;
  ListingLimit limit_;  // by scores, then by measured areas
  std::vector<Contender> contenders_, named_;
};

}  // namespace moldlight
