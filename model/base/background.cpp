#include "model/base/background.h"

#include <sys/resource.h>
#include <unistd.h>

namespace base {

namespace {

/// Against a thread that has not stepped back this one gets a tenth of the time.
constexpr int kNice = 10;

}  // namespace

void becomeBackground() {
    (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
}

}  // namespace base
