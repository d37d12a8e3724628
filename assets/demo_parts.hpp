// The demo parts, in millimetres.
#pragma once

#include <TopoDS_Shape.hxx>

namespace moldlight::demo {

/// Lid of an enclosure: drafted shell with rounded corners, ribs, screw bosses, vents; a side window and two
/// of its four snap hooks are undercut along z.
TopoDS_Shape enclosure_lid();
/// A revision of it: a third hook has a window below it, one screw boss is moved, the side window is wider.
TopoDS_Shape enclosure_lid_b();

/// Screw cap: knurled outside, thread-like beads inside that are undercut along every direction.
TopoDS_Shape bottle_cap();

/// Clip for a cable: comes apart along the cable's axis but for its screw hole, along the screw hole but for
/// its ring.
TopoDS_Shape cable_clip();

/// Bracket with gussets and pockets whose only good pull is (0.48, -0.36, 0.8).
TopoDS_Shape tilted_bracket();

}  // namespace moldlight::demo
