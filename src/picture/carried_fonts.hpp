// Fonts that an archive or a wheel carries, for machines that have none.
#pragma once

namespace moldlight {

/// Makes fontconfig know the fonts that are carried beside the program; to be called before it is asked for
/// any.
void find_carried_fonts();

}  // namespace moldlight
