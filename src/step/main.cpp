// moldlight-step: reads one STEP file for moldlight and writes the facets to descriptor 3. Not meant to be
// run by hand.
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include <Standard_Failure.hxx>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "io/step_result.hpp"
#include "step/tessellation.hpp"

namespace {

using moldlight::StepResult;

void limit(int resource, rlim_t value) {
  const rlimit both = {value, value};
  static_cast<void>(::setrlimit(static_cast<__rlimit_resource>(resource), &both));
}

StepResult failed(const std::string& sentence) {
  StepResult result;
  result.error = sentence;
  return result;
}

StepResult read(const std::string& path, const moldlight::step::TessellationSettings& settings) {
  try {
    return moldlight::step::tessellate(path, settings);
  } catch (const Standard_Failure& failure) {
    return failed(std::string("cannot be read by OpenCASCADE (") + failure.DynamicType()->Name() +
                  "); export the part again");
  } catch (const std::bad_alloc&) {
    return failed("needs more memory than is allowed; coarsen the deflection or export the part as STL");
  } catch (const std::exception& error) {
    return failed(error.what());
  }
}

bool write_all(int descriptor, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (written <= 0) return false;
    done += static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace

/// Arguments: file, linear deflection, angular deflection in degrees, facet limit, memory limit in bytes.
int main(int argc, char** argv) {
  if (argc != 6) return 2;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CORE, 0);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  limit(RLIMIT_AS, std::strtoull(argv[5], nullptr, 10));
#endif
  moldlight::step::TessellationSettings settings;
  settings.linear_deflection = std::strtod(argv[2], nullptr);
  settings.angular_deflection_deg = std::strtod(argv[3], nullptr);
  settings.max_facets = std::strtoull(argv[4], nullptr, 10);
  const bool written = write_all(moldlight::k_step_result_descriptor, read(argv[1], settings).to_bytes());
  // Tidying up OpenCASCADE's tables takes time and serves nobody.
  ::_exit(written ? 0 : 1);
}
