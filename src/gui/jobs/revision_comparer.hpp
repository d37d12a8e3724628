// Compares the window's part with another revision of it, on threads of its own: reads that, lays it on the
// part where it is to be aligned, and compares them anew when settings and direction have come to rest.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/job.hpp"
#include "gui/app_state.hpp"
#include "gui/store/files.hpp"

namespace moldlight::gui {

class RevisionComparer {
 public:
  /// `wake` is called from other threads when there is something new.
  explicit RevisionComparer(const std::function<void()>& wake)
      : prepare_job_({.wake = wake, .wake_for_progress = true}),
        compare_job_({.wake = wake, .wake_for_progress = true}),
        file_watch_(wake) {}

  /// From the next update on.
  void start(const std::string& path, RevisionState& revisions);
  /// Call it every frame, after the figures were updated. `moving`: a hand is at settings or direction.
  /// Returns why another part cannot be compared, once; then nothing is compared any more unless a former
  /// result is there, which stays.
  std::string update(const AppState& state, RevisionState& revisions, bool moving);
  /// Gives up what runs until something else is asked; what was not there before is none.
  void cancel(RevisionState& revisions);
  /// Ends the comparison.
  void leave(RevisionState& revisions);
  void end_jobs() {
    prepare_job_.give_up();
    compare_job_.give_up();
  }
  /// True once after B's file was changed, which is read again.
  [[nodiscard]] bool take_changed();

 private:
  struct File {
    std::string path;
    ReadOptions options;
    int version = 0;
    bool operator==(const File&) const = default;
  };
  struct Preparing {
    std::shared_ptr<const PartModel> a;
    File file;
    bool align = false;
    bool operator==(const Preparing&) const = default;
  };
  struct Comparing {
    std::shared_ptr<const PreparedRevision> prepared;
    ExactQuery query;
    RevisionSettings settings;
    bool operator==(const Comparing&) const = default;
  };
  /// The best direction of B, which takes long.
  struct Best {
    std::shared_ptr<const PartModel> b;
    MethodSettings method;
    glm::dvec3 direction{0.0};
  };
  struct Compared {
    std::shared_ptr<const Revisions> result;
    std::optional<Best> best;
  };
  static PreparedRevision prepare(const Preparing& wanted, std::shared_ptr<const PartModel> as_read,
                                  const Progress& progress);
  static Compared compare(const Comparing& wanted, const Query& asked, std::optional<Best> best,
                          const Progress& progress);
  std::string update_prepared(const Preparing& wanted, RevisionState& revisions, bool moving);
  std::string update_result(const Comparing& wanted, const Query& query, RevisionState& revisions,
                            bool may_start);
  std::string failed(const std::string& why, RevisionState& revisions);

  Job<PreparedRevision> prepare_job_;
  Job<Compared> compare_job_;
  FileWatch file_watch_;
  int version_ = 0;
  struct {
    std::optional<Preparing> preparing;  // for which the job runs or has ended
    std::optional<Preparing> prepared;   // of what is prepared
    std::optional<Comparing> comparing, compared;
    std::optional<Best> best;
  } asked_;
};

}  // namespace moldlight::gui
