#include "targets.h"

namespace fuzz {

const std::vector<Target>& targets() {
    static const std::vector<Target> kAll = [] {
        std::vector<Target> all;
        for (const auto group : {odbTargets(), formatTargets(), settingTargets(), geometryTargets()}) {
            all.insert(all.end(), group.begin(), group.end());
        }
        return all;
    }();
    return kAll;
}

}  // namespace fuzz
