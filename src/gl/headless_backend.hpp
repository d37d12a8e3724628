// How to get a GL context without a window. Apart from the GL itself, so that settings can name it.
#pragma once

namespace moldlight::gl {

enum class HeadlessBackend { automatic, egl, osmesa };

}  // namespace moldlight::gl
