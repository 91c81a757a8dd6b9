#include "model/base/background.h"

#include <sys/resource.h>
#include <unistd.h>

namespace base {

namespace {

/// Against a thread that has not stepped back this one gets a quarter of the time: enough to be seen to go on beside
/// other programs that are busy.
constexpr int kNice = 5;

}  // namespace

void becomeBackground() {
    (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
}

}  // namespace base
