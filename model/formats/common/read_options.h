#pragma once

#include <filesystem>
#include <string>

#include "model/formats/common/archive_limits.h"

namespace model::formats {

struct ReadOptions {
    std::string step;        ///< empty: the first one that draws anything itself
    bool inferNets = false;  ///< follow the copper instead of the job's nets (model/nets/net_inference.h)
    std::string format{};    ///< BoardFormat::key; empty: the richest that is there
    std::string member{};    ///< the file or archive to read of a folder or archive (BoardForm::member); empty: any
    bool onlyAsks = false;   ///< where there are several forms and neither format nor member is named: read none
    std::filesystem::path layerMap{};  ///< a file of gerber::LayerMap; empty: the one beside the job, if there is one
    ArchiveLimits limits{};            ///< of archives that are unpacked
};

}  // namespace model::formats
