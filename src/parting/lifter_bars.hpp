// Lifters as solids: straight bars through their half, cut out of it with what they form.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/bar_cut.hpp"
#include "parting/make_halves.hpp"
#include "parting/plain_mold.hpp"

namespace moldlight {

class LifterBars {
 public:
  /// Why a lifter is none goes to `unmade`; all must outlive it.
  LifterBars(const PlainMold& plain, std::vector<UnmadeAction>& unmade, const Progress& progress)
      : plain_(plain), unmade_(unmade), progress_(progress) {}

  /// A bar along the lifter's stem, as wide as it and as what it forms; towards its end on the side of that
  /// it narrows to the stem, so that it stands in the part's wall there, not behind it.
  void add(std::size_t lifter);
  [[nodiscard]] bool empty() const { return bars_.empty(); }
  /// What the halves are to have, too, for these bars.
  [[nodiscard]] std::vector<LiftedInsert> lifted() const;

  /// Cuts the lifters out of halves that have what they form. False, and some bars less, where one cannot be.
  [[nodiscard]] bool put(MoldHalves& halves);
  void give_up(const std::string& why);

 private:
  /// In the frame of the plain mold.
  struct Bar {
    std::size_t action = 0;
    std::vector<std::size_t> inserts;  // that it forms, of the halves without slides
    BarRoom room;
  };

  [[nodiscard]] std::vector<std::size_t> lifted_by(std::size_t lifter, std::string& why) const;
  [[nodiscard]] bool core_side(const Bar& bar) const {
    return plain_.wish.plan.actions[bar.action].core_side;
  }
  [[nodiscard]] LiftedInsert lifted(std::size_t insert, const Bar& bar) const;
  void drop(std::size_t number, const std::string& why);
  std::string put_one(const Bar& bar, std::size_t number, double unit, MoldHalves& put,
                      std::vector<Bounds>& rooms) const;
  [[nodiscard]] std::string fault_of(const Bar& bar, TriangleMesh mesh, std::vector<Bounds>& rooms) const;

  const PlainMold& plain_;
  std::vector<UnmadeAction>& unmade_;
  const Progress& progress_;
  std::vector<Bar> bars_;
};

}  // namespace moldlight
