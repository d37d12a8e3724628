// How much of the processor a thread asks for beside others.
#pragma once

namespace moldlight {

/// From now on this thread, and those that it starts, leave most of the cores to threads that draw, where
/// these want them.
void give_way();

}  // namespace moldlight
