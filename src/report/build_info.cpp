#include "report/build_info.h"

#include "viewcover_build.h"  // made by report/write_build_header.cmake at each build

namespace viewcover {

BuildInfo build_info() {
  return {
    VIEWCOVER_VERSION, VIEWCOVER_COMMIT,
#if defined(__clang__)
        "Clang " __clang_version__
#elif defined(__GNUC__)
        "GCC " __VERSION__
#else
        "unknown"
#endif
  };
}

}  // namespace viewcover
