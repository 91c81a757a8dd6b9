#pragma once

#include <string>

namespace model {

struct ReadOptions {
    std::string step;        ///< empty: the first step of the matrix that has layers of its own
    bool inferNets = false;  ///< follow the copper instead of the job's nets (connectivity/net_inference.h)
};

}  // namespace model
